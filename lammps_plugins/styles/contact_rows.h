// SPDX-License-Identifier: GPL-2.0-or-later
// The contacts of a step as rows, from the pair style and from every fix with walls, for all that hands them
// on: compute contact/disc, snapshots, averages taken in the run.
#pragma once

#include <array>
#include <vector>

#include "lmptype.h"
#include "pointers.h"
#include "styles_never_throw.h"

namespace LAMMPS_NS {
class Compute;
}

namespace mikromakro::styles {

/// id1 id2 x1 y1 x2 y2 nx ny overlap fx fy fn ft xi vn vt: signs as in physics/contact_law.h, the force acts
/// on 1, x2 y2 are those of the image that touches (of the contact point for a wall, whose id is <= 0); SI.
inline constexpr int contact_columns = 16;
using ContactRow = std::array<double, contact_columns>;

/// A wall as contact rows show it, the atom type whose material constants it has, and its curvature (1/m):
/// 1/R of a circle, negative where the discs are inside, 0 of a flat wall. Of the last force evaluation.
struct WallKind {
  int id, type;
  double curvature;
};

/// A fix whose walls touch discs.
class WallContactSource {
 public:
  virtual ~WallContactSource() noexcept(styles_never_throw) = default;
  /// Appends a row for each contact of an owned disc of the group as it was applied in this step. False: the
  /// step was not recorded.
  virtual bool append_wall_contacts(int group_bit, std::vector<ContactRow>& rows) const = 0;
  virtual std::vector<WallKind> wall_kinds() const = 0;
};

/// A fix that reads contacts in steps of its own, of which the engine's output does not know.
class ContactObserver {
 public:
  virtual ~ContactObserver() noexcept(styles_never_throw) = default;
  virtual bool wants_contacts_at(LAMMPS_NS::bigint step) const = 0;
};

/// The steps in which contacts are kept for those who read them: the set-up, the last step, those that the
/// engine has scheduled for thermo, dumps or restarts where there is a compute contact/disc, those for which
/// another fix has asked one (fix ave/time and others of a compute reduce), and those that an observer wants.
class ContactSchedule {
 public:
  /// At the start of a run, when all fixes and computes are defined.
  void look_up(LAMMPS_NS::LAMMPS& engine);
  bool due(const LAMMPS_NS::Update& update, const LAMMPS_NS::Output& output) const;

 private:
  std::vector<LAMMPS_NS::Compute*> computes_;
  std::vector<const ContactObserver*> observers_;
};

/// Appends the contacts of this step between discs of the group, then those of such discs with walls; each
/// contact on one rank only. Forces are those that were applied, geometry is that of now: a box that changes
/// at the end of a step takes discs along. Called by all ranks together. False: the step was not recorded, or
/// there is no disc law.
bool append_contact_rows(LAMMPS_NS::LAMMPS& engine, int group_bit, std::vector<ContactRow>& rows);

}  // namespace mikromakro::styles
