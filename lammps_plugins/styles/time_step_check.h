// SPDX-License-Identifier: GPL-2.0-or-later
// Compares the time step with the shortest contact that the discs at hand can make.
#pragma once

#include <string>
#include <vector>

#include "physics/contact_law.h"

namespace LAMMPS_NS {
class LAMMPS;
class NeighList;
}  // namespace LAMMPS_NS

namespace mikromakro::styles {

/// The contact law as far as it sets time scales.
struct TimeScales {
  physics::Effects effects;
  const std::vector<physics::ContactParameters>& parameters;  // of types i, j at (i - 1) * types + j - 1
  double impact_velocity;  // [m/s] of the fastest impact to come, for Hertz's law; 0: not known
};

/// Ends the run, on all ranks and with one line, where the step is above a quarter of the shortest contact,
/// and warns where it is above a fiftieth. Linear law: t_c of the lightest discs of each pair of types.
/// Hertz: the shorter of t_c at the impact velocity, or at the sum of the largest present speeds of both
/// types where that is larger, and of pi / sqrt(k/m12) with the slope k of the force at the largest present
/// overlap, or k_t where the law has a spring. `style` begins the line. All ranks call it, when the neighbour
/// list is built.
void check_time_step(LAMMPS_NS::LAMMPS& engine, const LAMMPS_NS::NeighList& list, const std::string& style,
                     const TimeScales& law);

}  // namespace mikromakro::styles
