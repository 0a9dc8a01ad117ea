// SPDX-License-Identifier: GPL-2.0-or-later
#include "pair_disc.h"

#include <mpi.h>

#include <algorithm>
#include <utility>

#include "atom.h"
#include "comm.h"
#include "engine/arguments.h"
#include "engine/engine_access.h"
#include "engine/first_rank.h"
#include "engine/private_member.h"
#include "error.h"
#include "fix_disc_history.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "update.h"
#include "utils.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;
using physics::ContactParameters;

namespace {

std::string types_text(const std::string& i, const std::string& j) {
  return "pair_coeff " + i + " " + j;
}

/// Requests a neighbour list of discs by size, with or without history. The API changed in LAMMPS of 24 Mar
/// 2022.
template <class Engine, class Style>
void request_list(Engine& neighbor, Style* pair, int instance, bool springs) {
  if constexpr (requires { neighbor.add_request(pair, 0); }) {
    constexpr int by_size = 1 << 2, with_history = 1 << 3;  // REQ_SIZE, REQ_HISTORY
    neighbor.add_request(pair, by_size | (springs ? with_history : 0));
  } else {
    const int request = neighbor.request(pair, instance);
    neighbor.requests[request]->size = 1;
    neighbor.requests[request]->history = springs ? 1 : 0;
  }
}

// Identifies our pair style in a restart file.
constexpr std::int64_t restart_key = 0x64697363;

constexpr const char *history_id = "NEIGH_HISTORY_DISC", *dummy_id = "NEIGH_HISTORY_DISC_DUMMY";

}  // namespace

PairDisc::PairDisc(LAMMPS* engine, physics::Normal normal)
    : WithHistory(engine), law_(*this, engine, normal) {
  restartinfo = 1;
  single_enable = 1;
  single_extra = 4;
  svector = new double[single_extra]();
  no_virial_fdotr_compute = 1;
  finitecutflag = 1;
  nondefault_history_transfer = 1;
  // Placeholder for the contact history fix, which must precede the fixes of the script but can be created
  // only once its restart data are available.
  modify->add_fix(std::string(dummy_id) + " all DUMMY");
}

PairDisc::~PairDisc() {
  modify->delete_fix(history_ ? history_id : dummy_id);
  delete[] svector;
  if (!allocated) return;
  memory->destroy(setflag);
  memory->destroy(cutsq);
}

void PairDisc::allocate() {
  allocated = 1;
  const int types = atom->ntypes;
  memory->create(setflag, types + 1, types + 1, "pair:setflag");
  memory->create(cutsq, types + 1, types + 1, "pair:cutsq");
  for (int i = 1; i <= types; ++i) std::fill_n(&setflag[i][1], types, 0);
  coefficients_ = TypePairTable<Coefficients>(types);
}

void PairDisc::settings(int narg, char** arg) {
  law_.read(narg, arg);
  if (history_ && !law_.effects().spring()) {
    modify->replace_fix(history_id, std::string(dummy_id) + " all DUMMY", 1);
    history_ = nullptr;
  }
  warn_of_foreign_springs();
}

struct StylesInRestart {
  friend auto member(StylesInRestart);
};

template struct PrivateMember<StylesInRestart, &Modify::style_restart_peratom>;

/// For a restart file of a run under another law: no fix of ours reads its springs.
void PairDisc::warn_of_foreign_springs() const {
  if (!law_.effects().spring()) return;
  for (int k = 0; k < modify->nfix_restart_peratom; ++k) {
    if (std::string("NEIGH_HISTORY") != (modify->*member(StylesInRestart{}))[k]) continue;
    print_line(*lmp, "WARNING: " + law_.style() +
                         ": the restart file holds springs of another law: they are discarded, and all "
                         "springs start at zero");
  }
}

void PairDisc::coeff(int narg, char** arg) {
  if (!allocated) allocate();
  if (narg < 2) law_.fail("pair_coeff: expected two types and constants");
  int i_low = 0, i_high = 0, j_low = 0, j_high = 0;
  utils::bounds(FLERR, arg[0], 1, atom->ntypes, i_low, i_high, error);
  utils::bounds(FLERR, arg[1], 1, atom->ntypes, j_low, j_high, error);
  // Later versions of LAMMPS exchange two types in descending order by themselves.
  if (i_low == i_high && j_low == j_high && i_low > j_low) {
    std::swap(i_low, j_low);
    std::swap(i_high, j_high);
  }
  Arguments arguments(*lmp, law_.style() + ": " + types_text(arg[0], arg[1]), narg, arg, 2);
  Coefficients given;
  while (arguments.more()) {
    const auto constant =
        std::find_if(constants_of_law.begin(), constants_of_law.end(),
                     [&](const ConstantOfLaw& c) { return arguments.take_once(c.keyword); });
    if (constant == constants_of_law.end()) arguments.unexpected("kn, gamman, kt, gammat or mu");
    given[constant - constants_of_law.begin()] = arguments.not_negative(constant->keyword);
  }
  int count = 0;
  for (int i = i_low; i <= i_high; ++i) {
    for (int j = std::max(i, j_low); j <= j_high; ++j, ++count) {
      setflag[i][j] = 1;
      coefficients_(i, j) = given;
    }
  }
  if (count == 0) arguments.fail("expected types I <= J");
}

void PairDisc::init_style() {
  if (force->pair != this)
    law_.fail(std::string("expected to be the only pair style, got it under '") + force->pair_style +
              "', where output and walls would not find its contacts; give it alone, with a pair_coeff for "
              "each pair "
              "of types");
  law_.require_two_dimensions();
  if (!stores_discs(*atom) || !atom->omega_flag || !atom->torque_flag)
    law_.fail(std::string("needs 'atom_style ") + disc_atom_style + "'");
  if (comm->ghost_velocity == 0) law_.fail("needs 'comm_modify vel yes'");
  request_list(*neighbor, this, instance_me, law_.effects().spring());
  provide_history();
  law_.begin_run(materials());
}

void PairDisc::provide_history() {
  if (history_ || !law_.effects().spring()) return;
  const std::string command =
      std::string(history_id) + " all NEIGH_HISTORY/DISC " + std::to_string(history_size);
  history_ = dynamic_cast<FixDiscHistory*>(modify->replace_fix(dummy_id, command, 1));
  history_->pair = this;
}

ContactParameters PairDisc::parameters(int i, int j) const {
  const std::string pair = types_text(std::to_string(i), std::to_string(j));
  if (!setflag[i][j]) law_.fail("expected '" + pair + " ...': constants of two types are not mixed");
  ContactParameters p;
  for (std::size_t k = 0; k < constants_of_law.size(); ++k) {
    const ConstantOfLaw& constant = constants_of_law[k];
    const auto& value = coefficients_(i, j)[k];
    if (value) p.*constant.member = *value;
    if (!is_needed(constant, law_.effects())) continue;
    if (!value)
      law_.fail(pair + " needs the constant " + label_of(constant, law_.effects().normal) + "; expected '" +
                pair + " ... " + constant.keyword + " VALUE'");
    if (constant.positive && *value == 0) law_.fail(pair + ": " + constant.keyword + ": expected > 0, got 0");
  }
  return p;
}

MaterialTable PairDisc::materials() const {
  MaterialTable all(atom->ntypes);
  for (int i = 1; i <= all.types(); ++i)
    for (int j = i; j <= all.types(); ++j) all(i, j) = all(j, i) = parameters(i, j);
  return all;
}

/// Cutoff: touching discs.
double PairDisc::init_one(int i, int j) {
  return law_.largest_radius(i) + law_.largest_radius(j);
}

void PairDisc::compute(int eflag, int vflag) {
  ev_init(eflag, vflag);
  law_.evaluate({*list, true, update->setupflag == 0, evflag != 0});
}

void PairDisc::write_restart(FILE* file) {
  law_.law_settings().write(file, restart_key);
  for (int i = 1; i <= atom->ntypes; ++i) {
    for (int j = i; j <= atom->ntypes; ++j) {
      std::fwrite(&setflag[i][j], sizeof(int), 1, file);
      std::fwrite(&coefficients_(i, j), sizeof(Coefficients), 1, file);
    }
  }
}

void PairDisc::read_restart(FILE* file) {
  law_.law_settings().read(*lmp, law_.style(), file, restart_key);
  law_.use_settings();
  if (!allocated) allocate();
  for (int i = 1; i <= atom->ntypes; ++i) {
    for (int j = i; j <= atom->ntypes; ++j) {
      if (comm->me == 0) {
        utils::sfread(FLERR, &setflag[i][j], sizeof(int), 1, file, nullptr, error);
        utils::sfread(FLERR, &coefficients_(i, j), sizeof(Coefficients), 1, file, nullptr, error);
      }
      MPI_Bcast(&setflag[i][j], 1, MPI_INT, 0, world);
      MPI_Bcast(&coefficients_(i, j), sizeof(Coefficients), MPI_BYTE, 0, world);
    }
  }
}

/// The partner disc has the same spring: its sign does not depend on the order of the discs.
void PairDisc::turn_history(const double* from, double* to) {
  std::copy_n(from, history_size, to);
}

double PairDisc::memory_usage() {
  return static_cast<double>(law_.bytes_of_pairs());
}

}  // namespace mikromakro::styles
