// SPDX-License-Identifier: GPL-2.0-or-later
// How far a tangential spring is stretched in one time step, and the slip rate that goes with it from step to
// step: for pairs of discs, in batches or alone, and for discs at walls.
#pragma once

#include "physics/contact_law.h"

namespace mikromakro::physics {

/// The time that a force evaluation stands for [s]; 0 in a set-up, which moves no spring that is there
/// already. `predicted`: velocities are of the same instant as positions, not of the middle of the step,
/// where the stock integrators leave them.
struct StepOfSlip {
  double dt;
  bool predicted;
};

/// Rate in the middle of the step [m/s], from which the next step goes on, and slip over the step [m].
struct SpringStep {
  double slip_rate, slip;
};

/// Slip rate in the middle of the step that ends now [m/s], from the one in the middle of the step before and
/// the predicted one of now: Verlet's prediction v_n = v_(n-1/2) + (v_(n-1/2) - v_(n-3/2)) / 2, solved for
/// v_(n-1/2). The slip of the step is this rate times dt, as in velocity Verlet; v_n dt instead would act as
/// a dashpot k_t dt / 2 beside the spring, the trapezium of predicted rates lets it gain energy in order 3.
inline double slip_rate_of_half_step(double half_step_before, double v_t) {
  return (2 * v_t + half_step_before) * (1.0 / 3);
}

/// Slip over the step in which the discs met [m]: they touched overlap / v_n ago, at most dt.
inline double slip_since_onset(const ContactState& s, double dt) {
  return s.v_t * (s.overlap < s.v_n * dt ? s.overlap / s.v_n : dt);
}

/// Of a contact that was there in the step before.
[[gnu::always_inline]] inline SpringStep step_of_old_contact(double slip_rate_before, double v_t,
                                                             const StepOfSlip& step) {
  const double half_step = slip_rate_of_half_step(slip_rate_before, v_t);
  const double rate = step.predicted ? half_step : v_t;
  return {rate, rate * step.dt};
}

/// Of one that was not. One that a set-up finds has slipped by nothing, and goes on from v_t.
inline SpringStep step_of_new_contact(const ContactState& s, const StepOfSlip& step) {
  return {s.v_t, step.predicted && step.dt > 0 ? slip_since_onset(s, step.dt) : s.v_t * step.dt};
}

}  // namespace mikromakro::physics
