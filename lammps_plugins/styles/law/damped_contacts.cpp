// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/damped_contacts.h"

#include <cmath>
#include <vector>

#include "atom.h"
#include "engine/engine_lists.h"
#include "fix.h"
#include "lammps.h"
#include "law/contact_rows.h"
#include "modify.h"
#include "neigh_list.h"
#include "physics/contact/dashpot_rate.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;

namespace {

/// Contacts of an owned disc and what is in its list, for the rate of their dashpots. Ghosts are their owners
/// if these are on this rank, or else at rest, as smooth walls are taken to be.
class DampedContacts {
 public:
  DampedContacts(LAMMPS& engine, const NeighList& list, const MovingAtoms& moving,
                 const physics::Effects& effects, const MaterialTable& materials)
      : atom_(*engine.atom), effects_(effects), materials_(materials), discs_(atom_.nlocal) {
    for (int i = 0; i < atom_.nlocal; ++i) {
      if (!moving.include(atom_, i)) continue;
      const double a = atom_.radius[i];
      discs_[i] = {1 / atom_.rmass[i], 2 / (atom_.rmass[i] * a * a)};
    }
    for (int k = 0; k < list.inum; ++k) {
      const int i = list.ilist[k];
      for (int n = 0; n < list.numneigh[i]; ++n) add(i, list.firstneigh[i][n] & NEIGHMASK);
    }
    for (const Fix* fix : fixes(*engine.modify))
      if (const auto* walls = dynamic_cast<const WallContactSource*>(fix))
        for (const WallTouch& touch : walls->touches()) add_wall(touch);
  }

  double largest_rate(double safe) const {
    if (physics::bound_of_dashpot_rate(contacts_, discs_) < safe) return 0;
    return physics::largest_dashpot_rate(contacts_, discs_);
  }

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
                         atom_.radius[i] - overlap / 2, atom_.radius[j] - overlap / 2, gamma_n(p),
                         gamma_t(p)});
  }

  void add_wall(const WallTouch& touch) {
    constexpr int at_rest = -1;
    const auto& p = materials_(atom_.type[touch.disc], touch.type);
    contacts_.push_back(
        {touch.disc, at_rest, false, touch.n_x, touch.n_y, touch.distance, 0, gamma_n(p), gamma_t(p)});
  }

  double gamma_n(const physics::ContactParameters& p) const {
    return effects_.normal_dashpot ? p.normal_damping : 0;
  }
  double gamma_t(const physics::ContactParameters& p) const {
    return physics::has_dashpot(effects_.tangential) && p.friction > 0 ? p.tangential_damping : 0;
  }

  Atom& atom_;  // its map is not const
  const physics::Effects& effects_;
  const MaterialTable& materials_;
  std::vector<physics::DampedDisc> discs_;
  std::vector<physics::DashpotContact> contacts_;
};

}  // namespace

double largest_dashpot_rate(LAMMPS& engine, const NeighList& list, const MovingAtoms& moving,
                            const physics::Effects& effects, const MaterialTable& materials, double safe) {
  return DampedContacts(engine, list, moving, effects, materials).largest_rate(safe);
}

}  // namespace mikromakro::styles
