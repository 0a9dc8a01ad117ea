// SPDX-License-Identifier: GPL-2.0-or-later
#include "pair_gran_disc.h"

#include <cstring>

#include "atom.h"
#include "compute_pair_gran_local.h"
#include "engine/arguments.h"
#include "engine/engine_lists.h"
#include "fix.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;
using physics::Normal;
using physics::Tangential;

namespace {

Normal normal_of(int64_t hash) {
  return static_cast<Normal>(static_cast<int>(hash & 63) - model_of(Normal{}));
}

Tangential tangential_of(int64_t hash) {
  const int model = static_cast<int>((hash >> 6) & 63);
  return model == model_of(Tangential::none) ? Tangential::none
                                             : static_cast<Tangential>(model - model_of(Tangential{1}) + 1);
}

}  // namespace

PairGranDisc::PairGranDisc(LAMMPS* engine, PairGran* parent, int64_t hash) : DiscLaw(engine), hash_(hash) {
  law_settings().reset(normal_of(hash), tangential_of(hash));
  // Spring and slip rate keep their signs when the particles are swapped, so "0": no sign change between the
  // two copies.
  if (effects().spring()) {
    parent->add_history_value("xi", "0");
    parent->add_history_value("slip_rate", "0");
  }
}

std::string PairGranDisc::style() const {
  return std::string("pair_style gran model ") + physics::name_of(effects().normal);
}

void PairGranDisc::settings(int narg, char** arg, LIGGGHTS::IContactHistorySetup* /*history*/) {
  require_two_dimensions();
  bool absolute_damping = true;
  Arguments arguments(*DiscLaw::lmp, style(), narg, arg);
  while (arguments.more()) {
    if (law_settings().take(arguments) || arguments.take_switch("absolute_damping", absolute_damping))
      continue;
    arguments.unexpected(std::string("damping, tangential_damping, limitForce, absolute_damping") +
                         (physics::depends_on_velocity(effects().normal) ? ", impact_velocity" : "") +
                         " or the end of the command");
  }
  // Accepted for compatibility with the stock law; the disc law has only absolute damping constants.
  if (!absolute_damping) fail("has only 'absolute_damping on' (gamman_abs, gammat_abs)");
  law_settings().finish(arguments);
  use_settings();
  discard_foreign_springs();
}

void PairGranDisc::init_granular() {
  require_two_dimensions();
  if (force->cg_active()) fail("works without coarse graining only");
  begin_run(read_material_constants());
}

void PairGranDisc::write_restart_settings(FILE* file) {
  law_settings().write(file, hash_);
}

void PairGranDisc::read_restart_settings(FILE* file, int64_t /*hash*/) {
  law_settings().read(*DiscLaw::lmp, style(), file, hash_);
  use_settings();
}

int PairGranDisc::get_history_offset(const std::string name) {
  if (!effects().spring()) return -1;
  return name == "xi" ? history_xi : name == "slip_rate" ? history_slip_rate : -1;
}

bool PairGranDisc::contact_match(const std::string kind, const std::string model) {
  if (kind == "normal") return model == physics::name_of(effects().normal);
  if (kind == "tangential") return model == physics::name_of(effects().tangential);
  if (kind == "surface") return model == "default";
  return model == "off";
}

void PairGranDisc::copy_histories_to_atoms() {
  for (LAMMPS_NS::Fix* fix : fixes(*modify))
    if (std::strcmp(fix->style, "contacthistory") == 0) fix->pre_exchange();
}

ContactHistory PairGranDisc::contact_history() {
  const NeighList& list = *pair_->listgranhistory;
  return {list.firstneigh, list.firstdouble, pair_->dnum()};
}

/// For `compute pair/gran/local` and the virial.
void PairGranDisc::tally(const TalliedContact& c) {
  if (pair_->cpl() && adds_to_compute_) {
    LCM::SurfacesIntersectData data;
    LCM::ForceData force_on_i;
    data.i = c.i;
    data.j = c.j;
    data.deltan = c.overlap;
    data.contact_history = c.history;
    force_on_i.delta_F[0] = c.f_x;
    force_on_i.delta_F[1] = c.f_y;
    force_on_i.delta_torque[2] = c.torque;
    pair_->cpl_add_pair(data, force_on_i);
  }
  if (pair_->evflag) {
    pair_->ev_tally_xyz(c.i, c.j, atom->nlocal, 0, 0.0, 0.0, c.f_x, c.f_y, 0.0, -c.d_x, -c.d_y, 0.0);
  }
}

void PairGranDisc::compute_force(PairGran* pair, int eflag, int vflag, int addflag) {
  if (eflag || vflag) {
    pair->ev_setup(eflag, vflag);
  } else {
    pair->evflag = pair->vflag_fdotr = 0;
  }
  pair_ = pair;
  adds_to_compute_ = addflag != 0;
  evaluate({*pair->list, pair->computeflag() != 0, pair->shearupdate() != 0, pair->evflag || addflag});
  if (addflag && pair->cpl()) pair->cpl_pair_finalize();
}

}  // namespace mikromakro::styles
