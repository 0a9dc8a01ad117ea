// SPDX-License-Identifier: GPL-2.0-or-later
// Compares the time step with the shortest contact duration of the present discs.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "law/material_constants.h"
#include "physics/contact/contact_law.h"

namespace LAMMPS_NS {
class LAMMPS;
class NeighList;
}  // namespace LAMMPS_NS

namespace mikromakro::styles {

/// The parameters of the contact law that set time scales.
struct TimeScales {
  physics::Effects effects;
  const MaterialTable& materials;
  double impact_velocity;  // fastest expected impact, for Hertz's law [m/s]; 0: unknown
  bool predicted;          // dashpots see velocities that are predicted for the time of the positions
  int held;                // groups_with_set_forces() of this run
};

/// Warnings that a run has been given: each once.
using Told = std::set<std::string_view>;

/// Stops the run on all ranks, with one line, if the time step exceeds a quarter of the shortest contact
/// duration, or the largest for which the normal dashpots of a pair, or of all contacts that there are, are
/// stable (contact_duration.h, dashpot_rate.h); warns above a fiftieth, a quarter of m12/gamma_n, the same of
/// a pair's tangential dashpot, and three quarters of that of all contacts with both. Linear law: t_c of the
/// lightest discs of each pair of types. Hertz: the shorter of two times: t_c at the impact velocity, or at
/// the sum of the largest present speeds of both types if that is larger; and pi / sqrt(k/m12) with the
/// tangent stiffness k at the largest present overlap, or k_t for a law with a spring. `style`: prefix of
/// messages. Collective; call when the neighbour list is built: in a set-up, and again where the time step
/// has grown or there are more discs than before.
void check_time_step(LAMMPS_NS::LAMMPS& engine, const LAMMPS_NS::NeighList& list, const std::string& style,
                     const TimeScales& law, Told& told);

/// At the end of a run, whose contacts may not have been there at its start: warns if their dashpots were
/// unstable.
void check_time_step_of_run(LAMMPS_NS::LAMMPS& engine, const LAMMPS_NS::NeighList& list,
                            const std::string& style, const TimeScales& law);

}  // namespace mikromakro::styles
