// SPDX-License-Identifier: GPL-2.0-or-later
// The present contacts as their dashpots see them, for the largest stable time step.
#pragma once

#include "law/material_constants.h"
#include "physics/contact/contact_law.h"

namespace LAMMPS_NS {
class LAMMPS;
class Modify;
class NeighList;
}  // namespace LAMMPS_NS

namespace mikromakro::styles {

/// Group bits of the fixes that integrate the equations of motion; all other atoms, such as wall discs, have
/// prescribed motion and count as infinitely heavy in a contact.
int integrated_groups(const LAMMPS_NS::Modify& modify);

/// physics::largest_dashpot_rate of the contacts of the discs owned by this rank [1/s]. Ghosts of discs of
/// other ranks, and smooth walls, count as at rest or are left out: the rate is not larger than the true one.
double largest_dashpot_rate(LAMMPS_NS::LAMMPS& engine, const LAMMPS_NS::NeighList& list,
                            const physics::Effects& effects, const MaterialTable& materials);

}  // namespace mikromakro::styles
