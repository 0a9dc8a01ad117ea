// SPDX-License-Identifier: GPL-2.0-or-later
// The contact law for a batch of pairs, laid out for SIMD. For a single contact, geometry, square root,
// division and law form one long chain of dependent operations; a batch lets the compiler vectorise across
// pairs.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "physics/contact/contact_law.h"
#include "physics/contact/spring_step.h"
#include "physics/math/inverse_root.h"
#include "physics/rows/disc_rows.h"

namespace mikromakro::physics {

/// Indices of two discs that may touch.
struct DiscPair {
  int i, j;
};

/// Tangential springs of a batch, kept from step to step: xi [m] and slip rate [m/s] as in contact_law.h, and
/// whether the discs were in contact in the previous step.
struct SpringLanes {
  static constexpr int lanes = 64;
  alignas(64) double xi[lanes], slip_rate[lanes];
  alignas(64) std::int64_t touched[lanes];
};

/// One pair (discs 1 and 2) per lane; units and signs as in contact_law.h. Lanes whose discs do not touch
/// carry zero force. A batch is small enough for the L1 cache.
struct ContactBatch {
  static constexpr int lanes = SpringLanes::lanes;
  using Lanes = double[lanes];

  // in: centre of 1 to centre of 2, sum and difference of the radii (2 - 1), velocity of 1 relative to 2, sum
  // of the spins, sum of spin times radius
  alignas(64) Lanes d_x, d_y, radius_sum, radius_difference, w_x, w_y, spin, rim_speed;
  // in: material
  alignas(64) Lanes k_n, gamma_n, k_t, gamma_t, mu, tangential_compliance;
  // only for laws with a spring; in and out: the springs; in: slip in this step
  SpringLanes* springs = nullptr;
  alignas(64) Lanes slip;
  // out: geometry, law, force on 1
  alignas(64) Lanes n_x, n_y, overlap, v_n, v_t;
  alignas(64) Lanes f_n, f_t, f_x, f_y;
  // out: f_t overlap / 2, the torque correction: lever arm = radius - overlap/2
  alignas(64) Lanes short_torque;

  void set_material(int k, const ContactParameters& p) {
    k_n[k] = p.normal_stiffness;
    gamma_n[k] = p.normal_damping;
    k_t[k] = p.tangential_stiffness;
    gamma_t[k] = p.tangential_damping;
    mu[k] = p.friction;
    tangential_compliance[k] = 1 / p.tangential_stiffness;
  }
  bool touches(int k) const { return overlap[k] > 0; }
  /// False for coincident centres, which leave the normal undefined.
  bool is_defined(int k) const { return overlap[k] < radius_sum[k]; }
};

/// Number of lanes evaluated for `count` pairs: in multiples of 8 lanes; padding lanes repeat the last pair.
constexpr int padded(int count) {
  return (count + 7) / 8 * 8;
}

/// any_changed: some contact opened or closed (laws with a spring only). any_undefined: some pair has
/// coincident centres, so its normal is undefined.
struct BatchState {
  bool any_changed, any_undefined;
};

/// Loads relative positions and motions of four pairs into lanes first to first + 3.
template <Effects effects>
[[gnu::always_inline]] inline void load_four_pairs(ContactBatch& c, int first, const DiscRow* discs,
                                                   const DiscPair (&pairs)[4]) {
  Four place[4], motion[4];
  for (int m = 0; m < 4; ++m) {
    const DiscRow &a = discs[pairs[m].i], &b = discs[pairs[m].j];
    place[m] = b.place + sign_of_place * a.place;
    motion[m] = a.motion + sign_of_motion * b.motion;
  }
  transpose(place[0], place[1], place[2], place[3]);
  transpose(motion[0], motion[1], motion[2], motion[3]);
  const auto store = [first](double* lanes, const Four& column) __attribute__((always_inline)) {
    std::memcpy(__builtin_assume_aligned(lanes + first, 32), &column, sizeof column);
  };
  store(c.d_x, place[0]);
  store(c.d_y, place[1]);
  store(c.radius_sum, place[2]);
  if constexpr (NormalLaw<effects.normal>::depends_on_radius) store(c.radius_difference, place[3]);
  store(c.w_x, motion[0]);
  store(c.w_y, motion[1]);
  if constexpr (effects.tangential != Tangential::none) {
    store(c.spin, motion[2]);
    store(c.rim_speed, motion[3]);
  }
}

/// Prefetches rows and loads of upcoming pairs.
[[gnu::always_inline]] inline void prefetch_discs(const DiscRow* discs, const DiscLoad* loads,
                                                  const DiscPair* pairs, int count) {
  for (int k = 0; k < count; ++k) {
    __builtin_prefetch(&discs[pairs[k].j]);
    __builtin_prefetch(&loads[pairs[k].j], 1);
  }
}

/// Loads relative positions and motions of the pairs. Meanwhile prefetches rows and loads of the `ahead`
/// pairs that follow the batch (0: all data are already in cache).
template <Effects effects>
[[gnu::always_inline]] inline void load_discs(ContactBatch& c, const DiscRow* discs, const DiscPair* pairs,
                                              int count, const DiscLoad* loads = nullptr, int ahead = 0) {
  int k = 0;
  for (; k + 4 <= count; k += 4) {
    load_four_pairs<effects>(c, k, discs, {pairs[k], pairs[k + 1], pairs[k + 2], pairs[k + 3]});
    if (k < ahead) prefetch_discs(discs, loads, pairs + count + k, std::min(4, ahead - k));
  }
  const int last = count - 1;
  for (; k < padded(count); k += 4) {
    load_four_pairs<effects>(
        c, k, discs,
        {pairs[std::min(k, last)], pairs[std::min(k + 1, last)], pairs[std::min(k + 2, last)], pairs[last]});
  }
}

/// Contact normal, overlap and relative velocities at the contact points.
template <Effects effects>
[[gnu::always_inline]] inline BatchState contact_geometry(ContactBatch& c, int count) {
  const int all = padded(count);
  for (int k = 0; k < all; ++k) {
    const double square = c.d_x[k] * c.d_x[k] + c.d_y[k] * c.d_y[k];
    const double inverse = inverse_root(square), distance = square * inverse;
    const double n_x = c.d_x[k] * inverse, n_y = c.d_y[k] * inverse;
    c.n_x[k] = n_x;
    c.n_y[k] = n_y;
    c.overlap[k] = c.radius_sum[k] - distance;
    c.v_n[k] = c.w_x[k] * n_x + c.w_y[k] * n_y;
    if constexpr (effects.tangential != Tangential::none) {
      // omega_1 c_1 + omega_2 c_2 with the lever arms c_i = a_i - overlap/2
      const double rolling = c.rim_speed[k] - c.spin[k] * (c.overlap[k] / 2);
      c.v_t[k] = c.w_y[k] * n_x - c.w_x[k] * n_y + rolling;
    }
  }
  std::int64_t changed = 0, undefined = 0;
  for (int k = 0; k < count; ++k) {
    undefined |= c.is_defined(k) ? 0 : 1;
    if constexpr (effects.spring()) changed |= (c.overlap[k] > 0 ? 1 : 0) ^ c.springs->touched[k];
  }
  return {changed != 0, undefined != 0};
}

/// Slip rate and slip of all lanes, as for contacts that already existed in the previous step.
[[gnu::always_inline]] inline void contact_slip(ContactBatch& c, int count, const StepOfSlip& step) {
  const int all = padded(count);
  double* slip_rate = c.springs->slip_rate;
#pragma GCC ivdep
  for (int k = 0; k < all; ++k) {
    const auto [rate, slip] = step_of_old_contact(slip_rate[k], c.v_t[k], step);
    slip_rate[k] = rate;
    c.slip[k] = slip;
  }
}

/// Resets spring and slip of a pair whose contact began or ended in this step; a new spring is unstretched.
inline void begin_or_end_contact(ContactBatch& c, int k, const StepOfSlip& step) {
  const SpringStep begun = step_of_new_contact({c.overlap[k], c.v_n[k], c.v_t[k], 0}, step);
  const auto [rate, slip] = c.touches(k) ? begun : SpringStep{0, 0};
  c.springs->xi[k] = 0;
  c.springs->slip_rate[k] = rate;
  c.slip[k] = slip;
}

/// Evaluates the force law; needs contact_geometry() and, for laws with a spring, the slip of each lane.
template <Effects effects>
[[gnu::always_inline]] inline void contact_forces(ContactBatch& c, int count) {
  const int all = padded(count);
  SpringLanes* springs = c.springs;
#pragma GCC ivdep
  for (int k = 0; k < all; ++k) {
    const ContactParameters parameters{c.k_n[k], c.gamma_n[k], c.k_t[k], c.gamma_t[k], c.mu[k]};
    ContactState state{c.overlap[k], c.v_n[k], c.v_t[k], effects.spring() ? springs->xi[k] : 0.0};
    if constexpr (NormalLaw<effects.normal>::depends_on_radius) {
      const double a_1 = (c.radius_sum[k] - c.radius_difference[k]) / 2;
      state.reduced_radius = reduced_radius(a_1, c.radius_sum[k] - a_1);
    }
    const auto force = contact_force<effects>(parameters, state, c.slip[k], c.tangential_compliance[k]);
    const bool touches = c.overlap[k] > 0;
    const double f_n = touches ? force.f_n : 0.0, f_t = touches ? force.f_t : 0.0;
    c.f_n[k] = f_n;
    c.f_t[k] = f_t;
    c.f_x[k] = -f_n * c.n_x[k] - f_t * c.n_y[k];
    c.f_y[k] = -f_n * c.n_y[k] + f_t * c.n_x[k];
    if constexpr (effects.tangential != Tangential::none) c.short_torque[k] = f_t * (c.overlap[k] / 2);
    if constexpr (effects.spring()) {
      springs->xi[k] = touches ? force.xi : 0.0;
      springs->slip_rate[k] = touches ? springs->slip_rate[k] : 0.0;
    }
  }
}

/// Adds the contact forces to the loads of both discs of each pair.
template <Effects effects>
[[gnu::always_inline]] inline void add_loads(const ContactBatch& c, const DiscPair* pairs, int count,
                                             DiscLoad* loads) {
  const auto add_four = [&](int k, int number) __attribute__((always_inline)) {
    Four rows[4] = {};
    const auto fetch = [k](Four & column, const double* lanes) __attribute__((always_inline)) {
      std::memcpy(&column, __builtin_assume_aligned(lanes + k, 32), sizeof column);
    };
    fetch(rows[0], c.f_x);
    fetch(rows[1], c.f_y);
    if constexpr (effects.tangential != Tangential::none) {
      fetch(rows[2], c.f_t);
      fetch(rows[3], c.short_torque);
    }
    transpose(rows[0], rows[1], rows[2], rows[3]);
    for (int m = 0; m < number; ++m) {
      loads[pairs[k + m].i].sums += rows[m];
      loads[pairs[k + m].j].sums += sign_of_load * rows[m];
    }
  };
  int k = 0;
  for (; k + 4 <= count; k += 4) add_four(k, 4);
  if (k < count) add_four(k, count - k);
}

}  // namespace mikromakro::physics
