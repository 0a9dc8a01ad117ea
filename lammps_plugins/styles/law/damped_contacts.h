// SPDX-License-Identifier: GPL-2.0-or-later
// The present contacts as their dashpots see them, for the largest stable time step.
#pragma once

#include "law/material_constants.h"
#include "physics/contact/contact_law.h"

namespace LAMMPS_NS {
class Atom;
class LAMMPS;
class Modify;
class NeighList;
}  // namespace LAMMPS_NS

namespace mikromakro::styles {

/// Which atoms move under their forces: those of the fixes that integrate the equations of motion but are not
/// frozen. All others, such as wall discs, have prescribed motion and count as infinitely heavy in a contact.
/// So do discs at rest whose forces are set: of setforce 0 0 0, the usual way to hold them, and of setforce
/// NULL 0 0, the name of the style tells nothing.
class MovingAtoms {
 public:
  explicit MovingAtoms(const LAMMPS_NS::Modify& modify);
  bool include(const LAMMPS_NS::Atom& atom, int i) const;

 private:
  int integrated_ = 0, frozen_ = 0, held_ = 0;  // group bits
};

/// physics::largest_dashpot_rate of the contacts of the discs owned by this rank [1/s], or 0 if its bound is
/// below `safe`. Ghosts of discs of other ranks, and smooth walls, count as at rest: the rate is not larger
/// than the true one.
double largest_dashpot_rate(LAMMPS_NS::LAMMPS& engine, const LAMMPS_NS::NeighList& list,
                            const physics::Effects& effects, const MaterialTable& materials, double safe);

}  // namespace mikromakro::styles
