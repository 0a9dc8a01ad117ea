// SPDX-License-Identifier: GPL-2.0-or-later
// Slip increment of a tangential spring in one time step, and the slip rate carried from step to step: for
// pairs of discs, batched or single, and for discs at walls.
#pragma once

#include "physics/contact/contact_law.h"

namespace mikromakro::physics {

/// Time that a force evaluation stands for [s]; 0 in a set-up, which must not stretch existing springs.
/// `predicted`: velocities belong to the time of the positions, not to the middle of the step as with the
/// stock integrators.
struct StepOfSlip {
  double dt;
  bool predicted;
};

/// Mid-step slip rate [m/s], kept for the next step, and slip over the step [m].
struct SpringStep {
  double slip_rate, slip;
};

/// Slip rate at the middle of the step that ends now [m/s], from that of the previous step and the predicted
/// current rate: Verlet's prediction v_n = v_(n-1/2) + (v_(n-1/2) - v_(n-3/2)) / 2, solved for v_(n-1/2). The
/// slip over the step is this rate times dt, as in velocity Verlet. Using v_n dt instead would act as a
/// dashpot k_t dt / 2 in parallel with the spring; the trapezoidal rule on predicted rates would let the
/// spring gain energy at third order.
inline double slip_rate_of_half_step(double half_step_before, double v_t) {
  return (2 * v_t + half_step_before) * (1.0 / 3);
}

/// Slip over the step of contact onset [m]: contact began overlap / v_n ago, at most dt.
inline double slip_since_onset(const ContactState& s, double dt) {
  return s.v_t * (s.overlap < s.v_n * dt ? s.overlap / s.v_n : dt);
}

/// For a contact that existed in the previous step.
[[gnu::always_inline]] inline SpringStep step_of_old_contact(double slip_rate_before, double v_t,
                                                             const StepOfSlip& step) {
  const double half_step = slip_rate_of_half_step(slip_rate_before, v_t);
  const double rate = step.predicted ? half_step : v_t;
  return {rate, rate * step.dt};
}

/// For a new contact. One found in a set-up has zero slip and starts at the rate v_t.
inline SpringStep step_of_new_contact(const ContactState& s, const StepOfSlip& step) {
  return {s.v_t, step.predicted && step.dt > 0 ? slip_since_onset(s, step.dt) : s.v_t * step.dt};
}

}  // namespace mikromakro::physics
