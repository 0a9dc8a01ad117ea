// SPDX-License-Identifier: GPL-2.0-or-later
// What a contact law is given and what it returns. Shared by all engines, the walls and the tests.
//
// Conventions: the normal n points from particle 1 to particle 2, the tangent is t = (-n_y, n_x).
//   overlap  a_1 + a_2 - |r_1 - r_2|, > 0 in contact                                      [m]
//   v_n      rate of the overlap, (v_1 - v_2).n, > 0 on approach                           [m/s]
//   v_t      slip rate of 1 against 2, (v_1 - v_2).t + omega_1 c_1 + omega_2 c_2           [m/s]
//   xi       tangential spring: slip of 1 against 2 that is stored elastically             [m]
// with the lever arms c_i = a_i - overlap/2 to the contact point. Both v_t and xi keep their sign when the
// particles are swapped. The force on 1 is -f_n n + f_t t, on 2 its opposite; both get the torque c_i f_t.
#pragma once

#include <limits>

namespace mikromakro::physics {

/// Material constants for a pair of particle types.
struct ContactParameters {
  double normal_stiffness = 0;      // k_n [N/m]; Hertz: [N/m^2]
  double normal_damping = 0;        // gamma_n [kg/s]
  double tangential_stiffness = 0;  // k_t [N/m]
  double tangential_damping = 0;    // gamma_t [kg/s]
  double friction = 0;              // mu [-]

  constexpr bool operator==(const ContactParameters&) const = default;
};

struct ContactState {
  double overlap;  // [m]
  double v_n;      // [m/s]
  double v_t;      // [m/s]
  double xi;       // [m], before this step's slip
  // a_1 a_2 / (a_1 + a_2) [m]: Hertz only; NaN by default so that an unset value reaches the force
  double reduced_radius = std::numeric_limits<double>::quiet_NaN();
};

struct ContactForce {
  double f_n;  // [N], > 0: repulsive
  double f_t;  // [N], on particle 1 along t
  double xi;   // [m], after this step's slip
};

/// a_1 a_2 / (a_1 + a_2) [m]; a_2 < 0 for a disc inside a circle of radius |a_2|; for a flat wall use a_1.
constexpr double reduced_radius(double a_1, double a_2) {
  return a_1 * a_2 / (a_1 + a_2);
}

/// The two discs of a collision: reduced mass m12 [kg], reduced radius a_12 [m], velocity of approach [m/s],
/// and the largest overlap that is already there [m].
struct Collision {
  double m12, reduced_radius, velocity, overlap;
};

}  // namespace mikromakro::physics
