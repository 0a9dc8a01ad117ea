// SPDX-License-Identifier: GPL-2.0-or-later
// Time since a motion began, counted in whole steps so that rounding errors do not accumulate, however long
// the run. If the time step changes, the clock starts a new count at that step.
#pragma once

#include <cstdint>

namespace mikromakro::physics {

class StepClock {
 public:
  StepClock() = default;
  // `elapsed` (s) has passed at step `step`; from there on the time step is `dt` (s).
  StepClock(double elapsed, std::int64_t step, double dt) : elapsed_(elapsed), step_(step), dt_(dt) {}

  // elapsed + (step - first step) dt, in s; one rounding of a product and one of a sum.
  [[nodiscard]] double time_at(std::int64_t step) const {
    return elapsed_ + static_cast<double>(step - step_) * dt_;
  }
  // Changes the time step to `dt` from step `step` on.
  void change_step_length(std::int64_t step, double dt) { *this = StepClock(time_at(step), step, dt); }
  // For when the engine renumbers its steps: `shift` is the new number minus the old.
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
