// SPDX-License-Identifier: GPL-2.0-or-later
// What fixes may do within a step, open (packed_discs.h) or closed. Constructing one of these objects
// completes the contacts of the step, so that loads and rows cannot be accessed before they are complete.
#pragma once

#include "law/packed_discs.h"
#include "physics/math/plane_vector.h"

namespace LAMMPS_NS {
class Atom;
}

namespace mikromakro::styles {

class DiscLaw;

/// Adds forces of fixes to those of the contacts, after all contacts: in the packed loads while the step is
/// open, in the engine's arrays otherwise, with the same sums in both.
class AddedLoads {
 public:
  /// `law` may be nullptr: without one, no step is open.
  AddedLoads(DiscLaw* law, LAMMPS_NS::Atom& atom);

  /// To the owned disc i; force [N].
  void add(int i, const physics::PlaneVector& force);
  /// And the torque [N m] of a force at its rim; ignored without friction, where spins do not change.
  void add(int i, const physics::PlaneVector& force, double torque);

 private:
  LAMMPS_NS::Atom& atom_;
  PackedDiscs* open_ = nullptr;  // nullptr: not an open step
  bool spins_ = true;
};

/// Moves discs on a prescribed path, in an open step: only their rows need to be written.
class CarriedDiscs {
 public:
  explicit CarriedDiscs(DiscLaw& law);

  /// The owned disc i; position [m], velocity [m/s], spin [1/s]. Inline: called for each disc of a ring.
  void carry(int i, const physics::PlaneVector& place, const physics::PlaneVector& velocity, double spin) {
    auto& row = packed_.discs[i];
    row.move_to(place.x, place.y);
    row.set_motion(velocity.x, velocity.y, spin);
  }
  /// Call with an upper bound of their displacement in this step [m], which ages the neighbour list.
  void moved_by(double at_most);

 private:
  PackedDiscs& packed_;
};

}  // namespace mikromakro::styles
