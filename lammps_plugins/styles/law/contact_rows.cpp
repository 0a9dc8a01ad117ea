// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/contact_rows.h"

#include <cmath>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "engine/engine_access.h"
#include "engine/engine_lists.h"
#include "law/disc_law.h"
#include "modify.h"
#include "update.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;

namespace {

/// The same contact at the discs' present positions.
AppliedContact moved(const Atom& atom, AppliedContact c) {
  const double x = atom.x[c.j][0] - atom.x[c.i][0], y = atom.x[c.j][1] - atom.x[c.i][1];
  const double distance = std::hypot(x, y);
  c.n_x = x / distance;
  c.n_y = y / distance;
  c.overlap = atom.radius[c.i] + atom.radius[c.j] - distance;
  return c;
}

ContactRow row_of(const Atom& atom, const AppliedContact& c) {
  const double *x_1 = atom.x[c.i], *x_2 = atom.x[c.j];
  return {static_cast<double>(atom.tag[c.i]),
          static_cast<double>(atom.tag[c.j]),
          x_1[0],
          x_1[1],
          x_2[0],
          x_2[1],
          c.n_x,
          c.n_y,
          c.overlap,
          -c.force.f_n * c.n_x - c.force.f_t * c.n_y,
          -c.force.f_n * c.n_y + c.force.f_t * c.n_x,
          c.force.f_n,
          c.force.f_t,
          c.force.xi,
          c.v_n,
          c.v_t};
}

}  // namespace

bool append_contact_rows(LAMMPS& engine, int group_bit, std::vector<ContactRow>& rows) {
  DiscLaw* law = active_disc_law(engine);
  const auto* contacts = law ? law->applied_contacts() : nullptr;
  if (!contacts) return false;
  const Atom& atom = *engine.atom;
  // A changing box moves discs after their forces were evaluated, and dumps show the moved positions.
  const bool box_changes = engine.domain->box_change != 0;
  if (box_changes) engine.comm->forward_comm();
  law->warn_of_deep_overlaps();
  for (const auto& c : *contacts) {
    if (!(atom.mask[c.i] & group_bit) || !(atom.mask[c.j] & group_bit)) continue;
    // A contact across a rank boundary is evaluated on both ranks; the owner of the larger id reports it.
    if (c.j >= atom.nlocal && atom.tag[c.i] <= atom.tag[c.j]) continue;
    rows.push_back(row_of(atom, box_changes ? moved(atom, c) : c));
  }
  for (const Fix* fix : fixes(*engine.modify)) {
    const auto* walls = dynamic_cast<const WallContactSource*>(fix);
    if (walls && !walls->append_wall_contacts(group_bit, rows)) return false;
  }
  return true;
}

}  // namespace mikromakro::styles
