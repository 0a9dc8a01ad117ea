// SPDX-License-Identifier: GPL-2.0-or-later
// The disc law of pair_style disc: its arguments, constants and contact history.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "atom.h"
#include "engine/arguments.h"
#include "fix_disc_history.h"
#include "law/law_names.h"
#include "pair_disc.h"

namespace mikromakro::styles {

using LAMMPS_NS::LAMMPS;
using physics::Tangential;

PairDisc::Law::Law(PairDisc& pair, LAMMPS* engine, physics::Normal normal)
    : DiscLaw(engine), pair_(pair), normal_(normal) {
  law_settings().reset(normal_, Tangential::none);
}

std::string PairDisc::Law::style() const {
  return std::string("pair_style ") + physics::name_of(normal_);
}

void PairDisc::Law::read(int narg, char** arg) {
  require_two_dimensions();
  law_settings().reset(normal_, Tangential::none);
  Arguments arguments(*lmp, style(), narg, arg);
  while (arguments.more()) {
    if (law_settings().take(arguments)) continue;
    if (!arguments.take_once("tangential"))
      arguments.unexpected(std::string("tangential, damping, tangential_damping, limitForce") +
                           (physics::depends_on_velocity(normal_) ? ", impact_velocity" : "") +
                           " or the end of the command");
    const auto names = tangential_names();
    const auto named =
        std::find_if(names.begin(), names.end(), [&](const auto& name) { return arguments.take(name); });
    if (named == names.end()) arguments.unexpected("tangential " + alternatives(names));
    law_settings().set_tangential(*tangential_named(*named));
  }
  law_settings().finish(arguments);
  use_settings();
}

/// The constants given in the script for all pairs of types.
std::vector<MaterialConstant> PairDisc::Law::given_constants() const {
  std::vector<MaterialConstant> all;
  const int types = atom->ntypes;
  for (std::size_t k = 0; k < constants_of_law.size(); ++k) {
    MaterialConstant constant{constants_of_law[k].name, unit_of(constants_of_law[k], normal_), {}};
    for (int i = 1; i <= types; ++i) {
      for (int j = 1; j <= types; ++j) {
        const auto& value = pair_.coefficients_(std::min(i, j), std::max(i, j))[k];
        if (value) constant.values.push_back(*value);
      }
    }
    if (constant.values.size() == static_cast<std::size_t>(types) * types) all.push_back(std::move(constant));
  }
  return all;
}

void PairDisc::Law::copy_histories_to_atoms() {
  if (pair_.history_) pair_.history_->pre_exchange();
}

ContactHistory PairDisc::Law::contact_history() {
  return {pair_.history_->firstflag, pair_.history_->firstvalue, history_size};
}

void PairDisc::Law::tally(const TalliedContact& c) {
  pair_.ev_tally_xyz(c.i, c.j, atom->nlocal, 0, 0.0, 0.0, c.f_x, c.f_y, 0.0, -c.d_x, -c.d_y, 0.0);
}

}  // namespace mikromakro::styles
