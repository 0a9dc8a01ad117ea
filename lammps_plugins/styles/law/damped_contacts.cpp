// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/damped_contacts.h"

#include <cmath>
#include <cstring>
#include <vector>

#include "atom.h"
#include "engine/engine_lists.h"
#include "fix.h"
#include "lammps.h"
#include "modify.h"
#include "neigh_list.h"
#include "physics/contact/dashpot_rate.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;

namespace {

/// Contacts of an owned disc and what is in its list, for the rate of their dashpots. Ghosts are their owners
/// if these are on this rank, or else at rest, as smooth walls are.
class DampedContacts {
 public:
  DampedContacts(LAMMPS& engine, const NeighList& list, const physics::Effects& effects,
                 const MaterialTable& materials)
      : atom_(*engine.atom), effects_(effects), materials_(materials), discs_(atom_.nlocal) {
    const int integrated = integrated_groups(*engine.modify);
    for (int i = 0; i < atom_.nlocal; ++i) {
      if (!(atom_.mask[i] & integrated)) continue;
      const double a = atom_.radius[i];
      discs_[i] = {1 / atom_.rmass[i], 2 / (atom_.rmass[i] * a * a)};
    }
    for (int k = 0; k < list.inum; ++k) {
      const int i = list.ilist[k];
      for (int n = 0; n < list.numneigh[i]; ++n) add(i, list.firstneigh[i][n] & NEIGHMASK);
    }
  }

  double largest_rate() const { return physics::largest_dashpot_rate(contacts_, discs_); }

 private:
  int owner_of(int j) const {
    if (j < atom_.nlocal) return j;
    const int owner = atom_.map_style ? atom_.map(atom_.tag[j]) : -1;
    return owner < atom_.nlocal ? owner : -1;
  }

  void add(int i, int j) {
    const double x = atom_.x[j][0] - atom_.x[i][0], y = atom_.x[j][1] - atom_.x[i][1];
    const double distance = std::hypot(x, y), overlap = atom_.radius[i] + atom_.radius[j] - distance;
    if (!(overlap > 0 && distance > 0)) return;
    const auto& p = materials_(atom_.type[i], atom_.type[j]);
    contacts_.push_back({i, owner_of(j), j < atom_.nlocal, x / distance, y / distance,
                         atom_.radius[i] - overlap / 2, atom_.radius[j] - overlap / 2,
                         effects_.normal_dashpot ? p.normal_damping : 0,
                         physics::has_dashpot(effects_.tangential) ? p.tangential_damping : 0});
  }

  Atom& atom_;  // its map is not const
  const physics::Effects& effects_;
  const MaterialTable& materials_;
  std::vector<physics::DampedDisc> discs_;
  std::vector<physics::DashpotContact> contacts_;
};

}  // namespace

int integrated_groups(const Modify& modify) {
  int bits = 0;
  for (const Fix* fix : fixes(modify))
    if (std::strncmp(fix->style, "nve", 3) == 0) bits |= fix->groupbit;
  return bits;
}

double largest_dashpot_rate(LAMMPS& engine, const NeighList& list, const physics::Effects& effects,
                            const MaterialTable& materials) {
  return DampedContacts(engine, list, effects, materials).largest_rate();
}

}  // namespace mikromakro::styles
