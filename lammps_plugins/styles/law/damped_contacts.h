// SPDX-License-Identifier: GPL-2.0-or-later
// The present contacts as their dashpots see them, for the largest stable time step.
#pragma once

#include "law/material_constants.h"
#include "law/moving_atoms.h"
#include "physics/contact/contact_law.h"

namespace LAMMPS_NS {
class LAMMPS;
class NeighList;
}  // namespace LAMMPS_NS

namespace mikromakro::styles {

/// physics::largest_dashpot_rate of the contacts of the discs owned by this rank [1/s], or 0 if its bound is
/// below `safe`. Ghosts of discs of other ranks, and smooth walls, count as at rest: the rate is not larger
/// than the true one.
double largest_dashpot_rate(LAMMPS_NS::LAMMPS& engine, const LAMMPS_NS::NeighList& list,
                            const MovingAtoms& moving, const physics::Effects& effects,
                            const MaterialTable& materials, double safe);

}  // namespace mikromakro::styles
