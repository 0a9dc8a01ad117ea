// SPDX-License-Identifier: GPL-2.0-or-later
// The contacts of a step as rows, from the pair style and from all fixes with walls. Used by compute
// contact/disc, snapshots and in-situ averages.
#pragma once

#include <array>
#include <vector>

#include "engine/styles_never_throw.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

/// id1 id2 x1 y1 x2 y2 nx ny overlap fx fy fn ft xi vn vt: signs as in physics/contact/contact_law.h, the
/// force acts on 1, x2 y2 is the periodic image in contact (for a wall, whose id is <= 0: the contact point);
/// SI units.
inline constexpr int contact_columns = 16;
using ContactRow = std::array<double, contact_columns>;

/// A wall at the last force evaluation: id in contact rows, atom type that supplies the material constants,
/// and curvature (1/m): 1/R for a circle, negative if the discs are inside, 0 for a flat wall.
struct WallKind {
  int id, type;
  double curvature;
};

/// A disc of this rank at a wall: its index, the normal from its centre to the wall, the distance of the
/// centre [m], and the type of the wall.
struct WallTouch {
  int disc;
  double n_x, n_y, distance;
  int type;
};

/// A fix with walls in contact with discs.
class WallContactSource {
 public:
  virtual ~WallContactSource() noexcept(styles_never_throw) = default;
  /// Appends a row for each wall contact of an owned disc of the group, as applied in this step. Returns
  /// false if the step was not recorded.
  virtual bool append_wall_contacts(int group_bit, std::vector<ContactRow>& rows) const = 0;
  virtual std::vector<WallKind> wall_kinds() const = 0;
  /// The contacts at the last force evaluation, or before the first one of a run those of its start.
  virtual std::vector<WallTouch> touches() const = 0;
};

/// Appends the contacts of this step between discs of the group, then those of these discs with walls; each
/// contact on one rank only. Forces are those applied; the geometry is current, because a box change at the
/// end of a step moves the discs. Collective. Returns false if the step was not recorded or there is no disc
/// law.
bool append_contact_rows(LAMMPS_NS::LAMMPS& engine, int group_bit, std::vector<ContactRow>& rows);

}  // namespace mikromakro::styles
