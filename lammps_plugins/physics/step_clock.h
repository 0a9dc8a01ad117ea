// SPDX-License-Identifier: GPL-2.0-or-later
// Time since a motion began, counted in whole steps so that no rounding error is summed up, whatever the
// number of steps. The time step may change: the clock then starts a new count at the step where it changed.
#pragma once

#include <cstdint>

namespace mikromakro::physics {

class StepClock {
 public:
  StepClock() = default;
  // The motion has lasted `elapsed` (s) at step `step`; from there on every step lasts `dt` (s).
  StepClock(double elapsed, std::int64_t step, double dt) : elapsed_(elapsed), step_(step), dt_(dt) {}

  // elapsed + (step - first step) dt, in s; one rounding of a product and one of a sum.
  [[nodiscard]] double time_at(std::int64_t step) const {
    return elapsed_ + static_cast<double>(step - step_) * dt_;
  }
  // From `step` on every step lasts `dt`.
  void change_step_length(std::int64_t step, double dt) { *this = StepClock(time_at(step), step, dt); }
  // The engine counts its steps anew: `shift` is the new number of a step minus its old one.
  void shift_steps(std::int64_t shift) { step_ += shift; }

  [[nodiscard]] double elapsed() const { return elapsed_; }
  [[nodiscard]] std::int64_t step() const { return step_; }
  [[nodiscard]] double dt() const { return dt_; }

 private:
  double elapsed_ = 0.0;
  std::int64_t step_ = 0;
  double dt_ = 0.0;
};

}  // namespace mikromakro::physics
