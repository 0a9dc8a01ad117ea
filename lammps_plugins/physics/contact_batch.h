// The contact law for several contacts side by side, so that a compiler evaluates them at the same time:
// geometry, square root, division and law of a single contact are one long chain of dependent operations.
#pragma once

#include <cmath>

#include "physics/contact_law.h"

namespace mikromakro::physics {

/// Contacts of discs 1 and 2, one for each lane; units and signs as in contact_law.h. The lanes of a batch
/// fit into the first cache of any processor.
struct ContactBatch {
  static constexpr int lanes = 64;
  using Lanes = double[lanes];

  // in: from the centre of 1 to that of 2, radii, velocity of 1 relative to 2, spins
  alignas(64) Lanes d_x, d_y, a_1, a_2, w_x, w_y, omega_1, omega_2;
  // in: material
  alignas(64) Lanes k_n, gamma_n, k_t, gamma_t, mu;
  // in and out, for laws with a spring: the spring, its slip rate in the middle of a step; in: the slip of
  // this step
  alignas(64) Lanes xi, slip_rate, slip;
  // out: geometry, law, force on 1 and torques
  alignas(64) Lanes n_x, n_y, overlap, arm_1, arm_2, v_n, v_t;
  alignas(64) Lanes f_n, f_t, f_x, f_y, torque_1, torque_2;

  void set_material(int k, const ContactParameters& p) {
    k_n[k] = p.normal_stiffness;
    gamma_n[k] = p.normal_damping;
    k_t[k] = p.tangential_stiffness;
    gamma_t[k] = p.tangential_damping;
    mu[k] = p.friction;
  }
};

/// Whether all of the first `count` pairs touch, and none has a common centre, which leaves the normal
/// undefined.
struct BatchState {
  bool all_touch, all_defined;
};

/// Normal, overlap, lever arms and relative velocities at the contact points of the first `count` lanes.
template <Effects effects>
[[gnu::always_inline]] inline BatchState contact_geometry(ContactBatch& c, int count) {
  for (int k = 0; k < count; ++k) {
    const double distance = std::sqrt(c.d_x[k] * c.d_x[k] + c.d_y[k] * c.d_y[k]);
    const double inverse = 1 / distance;
    c.n_x[k] = c.d_x[k] * inverse;
    c.n_y[k] = c.d_y[k] * inverse;
    c.overlap[k] = c.a_1[k] + c.a_2[k] - distance;
    c.arm_1[k] = c.a_1[k] - c.overlap[k] / 2;
    c.arm_2[k] = c.a_2[k] - c.overlap[k] / 2;
    c.v_n[k] = c.w_x[k] * c.n_x[k] + c.w_y[k] * c.n_y[k];
    if constexpr (effects.tangential != Tangential::none) {
      c.v_t[k] =
          c.w_y[k] * c.n_x[k] - c.w_x[k] * c.n_y[k] + c.omega_1[k] * c.arm_1[k] + c.omega_2[k] * c.arm_2[k];
    }
  }
  int apart = 0, undefined = 0;
  for (int k = 0; k < count; ++k) {
    apart += c.overlap[k] <= 0;
    undefined += c.n_x[k] != c.n_x[k];
  }
  return {apart == 0, undefined == 0};
}

/// Slip of the step [m] of contacts that touched before, from velocities that were predicted for this instant
/// (slip_rate_of_half_step) or belong to the middle of the step, as the stock integrators leave them.
[[gnu::always_inline]] inline void contact_slip(ContactBatch& c, int count, bool predicted, double dt) {
  for (int k = 0; k < count; ++k) {
    const double rate = slip_rate_of_half_step(c.slip_rate[k], c.v_t[k]);
    c.slip_rate[k] = predicted ? rate : c.v_t[k];
    c.slip[k] = c.slip_rate[k] * dt;
  }
}

/// The law, after contact_geometry() and with the slip of each lane.
template <Effects effects>
[[gnu::always_inline]] inline void contact_forces(ContactBatch& c, int count) {
  for (int k = 0; k < count; ++k) {
    const ContactParameters parameters{c.k_n[k], c.gamma_n[k], c.k_t[k], c.gamma_t[k], c.mu[k]};
    ContactState state{c.overlap[k], c.v_n[k], c.v_t[k], c.xi[k]};
    if constexpr (effects.normal == Normal::hertz) state.reduced_radius = reduced_radius(c.a_1[k], c.a_2[k]);
    const auto force = contact_force<effects>(parameters, state, c.slip[k]);
    c.f_n[k] = force.f_n;
    c.f_t[k] = force.f_t;
    if constexpr (effects.spring()) c.xi[k] = force.xi;
    c.f_x[k] = -force.f_n * c.n_x[k] - force.f_t * c.n_y[k];
    c.f_y[k] = -force.f_n * c.n_y[k] + force.f_t * c.n_x[k];
    if constexpr (effects.tangential != Tangential::none) {
      c.torque_1[k] = c.arm_1[k] * force.f_t;
      c.torque_2[k] = c.arm_2[k] * force.f_t;
    }
  }
}

}  // namespace mikromakro::physics
