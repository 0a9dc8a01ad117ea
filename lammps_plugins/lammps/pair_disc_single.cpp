// SPDX-License-Identifier: GPL-2.0-or-later
// Single contacts of pair_style disc, for computes of the engine.
#include <algorithm>
#include <cmath>

#include "atom.h"
#include "error.h"
#include "pair_disc.h"
#include "physics/contact/contact_energy.h"
#include "update.h"

namespace mikromakro::styles {

using physics::ContactParameters;

const AppliedContact* PairDisc::contact_of(int i, int j) {
  if (contacts_step_ != update->ntimestep) {
    const auto* applied = law_.applied_contacts();
    if (!applied)
      error->one(FLERR, (law_.style() + ": contacts of this step were not kept; expected their compute to be "
                                        "defined before the run")
                            .c_str());
    contacts_.clear();
    for (const AppliedContact& contact : *applied) contacts_[{contact.i, contact.j}] = &contact;
    contacts_step_ = update->ntimestep;
  }
  const auto found = contacts_.find({i, j});
  return found == contacts_.end() ? nullptr : found->second;
}

double PairDisc::elastic_energy(const AppliedContact& c) const {
  const physics::ContactState state{c.overlap, 0, 0, 0,
                                    physics::reduced_radius(atom->radius[c.i], atom->radius[c.j])};
  const ContactParameters& p = law_.parameters(atom->type[c.i], atom->type[c.j]);
  return physics::with_law(law_.effects().normal,
                           [&](auto law) { return law.energy(p.normal_stiffness, state); });
}

double PairDisc::single(int i, int j, int /*type_i*/, int /*type_j*/, double distance_square,
                        double /*factor_coulomb*/, double /*factor_lj*/, double& force_over_distance) {
  std::fill_n(svector, single_extra, 0.0);
  force_over_distance = 0;
  const AppliedContact* there = contact_of(i, j);
  const AppliedContact* back = there ? nullptr : contact_of(j, i);
  if (!there && !back) return 0;
  const AppliedContact& c = there ? *there : *back;
  const double side = there ? 1 : -1;
  force_over_distance = c.force.f_n / std::sqrt(distance_square);
  svector[0] = -side * c.force.f_t * c.n_y;
  svector[1] = side * c.force.f_t * c.n_x;
  svector[3] = std::abs(c.force.f_t);
  return elastic_energy(c);
}

}  // namespace mikromakro::styles
