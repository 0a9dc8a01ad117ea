// SPDX-License-Identifier: GPL-2.0-or-later
// Which discs move under their forces.
#pragma once

namespace LAMMPS_NS {
class Atom;
class LAMMPS;
class Modify;
}  // namespace LAMMPS_NS

namespace mikromakro::styles {

/// Bits of the groups whose forces along x and y are all replaced by fixes setforce and aveforce. The names
/// of these styles tell nothing (setforce NULL NULL 0 leaves both as they are), so each acts once on forces
/// that differ from atom to atom, which are put back. Call while forces are evaluated in a set-up, before
/// these fixes act. Collective.
int groups_with_set_forces(LAMMPS_NS::LAMMPS& engine);

/// Atoms that move under their forces: those of the fixes that integrate the equations of motion but are not
/// frozen. All others, such as wall discs, have prescribed motion and count as infinitely heavy in a contact.
/// So do discs at rest whose forces are set: setforce 0 0 0 is the usual way to hold them.
class MovingAtoms {
 public:
  MovingAtoms(const LAMMPS_NS::Modify& modify, int groups_with_set_forces);
  bool include(const LAMMPS_NS::Atom& atom, int i) const;

 private:
  int integrated_ = 0, frozen_ = 0, held_;  // group bits
};

}  // namespace mikromakro::styles
