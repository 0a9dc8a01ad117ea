// SPDX-License-Identifier: GPL-2.0-or-later
// Contact law of a pair style: settings, constants and force evaluation.
#include "law/disc_law.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string>
#include <utility>

#include <mpi.h>
#include "law/agreement.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "engine/arguments.h"
#include "engine/engine_access.h"
#include "engine/engine_lists.h"
#include "engine/first_rank.h"
#include "engine/restart_state.h"
#include "force.h"
#include "law/disc_check.h"
#include "law/effects_line.h"
#include "law/fix_on_rows.h"
#include "law/time_step_check.h"
#include "law/unseen_forces.h"
#include "modify.h"
#include "neighbor.h"
#include "output.h"
#include "update.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;
using physics::Normal;
using physics::Tangential;

namespace {

/// The settings as stored in a restart file.
struct SavedSettings {
  std::int64_t key;
  StateHeader header;
  double impact_velocity;
  std::array<std::int32_t, 4> effects;
};

}  // namespace

void DiscLaw::fail(const std::string& what) const {
  stop(*lmp, style(), what);
}

void DiscLaw::require_two_dimensions() const {
  if (domain->dimension != 2) fail("discs live in two dimensions; put 'dimension 2' before the box");
  if (force->newton_pair) fail("needs 'newton off' before the box is created");
}

void DiscLaw::forget_settings(Normal normal, Tangential tangential) {
  effects_ = {};
  effects_.normal = normal;
  effects_.tangential = tangential;
  tangential_damping_ = false;
  impact_velocity_ = 0;
}

bool DiscLaw::take_switch(Arguments& arguments, const char* key, bool& value) const {
  if (!arguments.take_once(key)) return false;
  const std::string word = arguments.more() ? arguments.word(key) : "nothing";
  if (word != "on" && word != "off") fail("'" + std::string(key) + "': expected on or off, got " + word);
  value = word == "on";
  return true;
}

bool DiscLaw::take_setting(Arguments& arguments) {
  if (take_switch(arguments, "damping", effects_.normal_dashpot) ||
      take_switch(arguments, "tangential_damping", tangential_damping_) ||
      take_switch(arguments, "limitForce", effects_.no_attraction)) {
    return true;
  }
  if (!physics::depends_on_velocity(effects_.normal) || !arguments.take_once("impact_velocity")) return false;
  impact_velocity_ = arguments.positive("impact_velocity");
  return true;
}

void DiscLaw::use_settings() {
  if (tangential_damping_ && !effects_.spring())
    fail(
        "'tangential_damping on': expected 'tangential disc/cundall_strack', beside whose spring the dashpot "
        "is");
  if (effects_.spring())
    effects_.tangential = tangential_damping_ ? Tangential::damped_spring : Tangential::spring;
  choose_loops();
}

void DiscLaw::write_settings(FILE* file, std::int64_t key) const {
  const SavedSettings settings{key,
                               {.size = sizeof(SavedSettings)},
                               impact_velocity_,
                               {static_cast<int>(effects_.tangential), effects_.no_attraction,
                                static_cast<int>(effects_.normal), effects_.normal_dashpot}};
  std::fwrite(&settings, sizeof settings, 1, file);
}

void DiscLaw::read_settings(FILE* file, std::int64_t key) {
  SavedSettings settings{};
  int complete = 0;
  if (comm->me == 0) complete = std::fread(&settings, sizeof settings, 1, file) == 1 && settings.key == key;
  MPI_Bcast(&settings, sizeof settings, MPI_BYTE, 0, world);
  MPI_Bcast(&complete, 1, MPI_INT, 0, world);
  if (!complete) fail("the restart file ends inside the settings of the pair style");
  if (settings.header != StateHeader{.size = sizeof settings})
    fail("the restart file is of another version of the styles; expected version " +
         std::to_string(version_of_states) + ", got " + std::to_string(settings.header.version));
  const auto& [tangential, no_attraction, normal, normal_dashpot] = settings.effects;
  effects_ = {static_cast<Tangential>(tangential), no_attraction != 0, static_cast<Normal>(normal),
              normal_dashpot != 0};
  tangential_damping_ = effects_.tangential == Tangential::damped_spring;
  impact_velocity_ = settings.impact_velocity;
  choose_loops();
}

/// Velocities are predicted if every integrating fix predicts them.
void DiscLaw::find_integrators() {
  integrators_.clear();
  bool all_predict = true;
  for (LAMMPS_NS::Fix* fix : fixes(*modify)) {
    if (std::strncmp(fix->style, "nve", 3) != 0) continue;
    auto* integrator = dynamic_cast<DiscIntegrator*>(fix);
    all_predict = all_predict && integrator && integrator->predicts_velocities();
    if (integrator) integrators_.push_back(integrator);
  }
  predicted_ = all_predict && !integrators_.empty();
}

void DiscLaw::find_largest_radii() {
  largest_radii_.assign(atom->ntypes + 1, 0.0);
  for (int i = 0; i < atom->nlocal; ++i) {
    double& largest = largest_radii_[atom->type[i]];
    largest = std::max(largest, atom->radius[i]);
  }
  MPI_Allreduce(MPI_IN_PLACE, largest_radii_.data(), static_cast<int>(largest_radii_.size()), MPI_DOUBLE,
                MPI_MAX, world);
  for (LAMMPS_NS::Fix* fix : fixes(*modify))
    for (int type = 1; type <= atom->ntypes; ++type)
      largest_radii_[type] = std::max(largest_radii_[type], radius_to_come(*fix, type));
}

double DiscLaw::sum_of_radii() const {
  double sum = std::accumulate(atom->radius, atom->radius + atom->nlocal, 0.0);
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, world);
  return sum;
}

void DiscLaw::begin_run(std::vector<physics::ContactParameters> parameters) {
  parameters_ = std::move(parameters);
  one_material_ = std::all_of(parameters_.begin(), parameters_.end(),
                              [&](const auto& p) { return p == parameters_.front(); });
  run_started_ = false;
  find_integrators();
  find_largest_radii();
  sum_of_radii_ = sum_of_radii();
  schedule_.look_up(*lmp);
  readers_.look_up(*lmp);
  packed_.may_stay_open = packed_.open = false;
  waiting_.reset();
  packed_.step = rows_step_ = -1;
  recorded_step_ = -1;
  growth_ = 0;
}

/// Called once per run, at its set-up, rather than on initialisation: the engine also initialises when it
/// writes a restart file.
void DiscLaw::start_run(const NeighList& list) {
  run_started_ = true;
  deep_overlaps_told_ = false;
  constexpr double rounding = 1e-12;
  lists_are_old_ = sum_of_radii() > sum_of_radii_ * (1 + rounding);
  check_discs(*lmp, style(), effects_.spring());
  check_time_step(*lmp, list, style(), {effects_, parameters_, impact_velocity_});
  tell(*lmp, effects_line(effects_, *modify, predicted_));
  warn_of_unseen_forces(*lmp);
  warn_of_disagreement(*lmp);
}

const physics::ContactParameters& DiscLaw::parameters(int type_1, int type_2) const {
  return parameters_[static_cast<std::size_t>(type_1 - 1) * atom->ntypes + type_2 - 1];
}

const physics::DiscRow* DiscLaw::seen(int i) const {
  return rows_step_ == update->ntimestep ? &packed_.discs[i] : nullptr;
}

void DiscLaw::tell_of_deep_overlaps() {
  if (deep_overlaps_told_) return;
  constexpr double most = 0.5;  // radii
  int deep = std::any_of(applied_.begin(), applied_.end(), [&](const AppliedContact& c) {
    return c.overlap > most * std::min(atom->radius[c.i], atom->radius[c.j]);
  });
  MPI_Allreduce(MPI_IN_PLACE, &deep, 1, MPI_INT, MPI_MAX, world);
  if (deep == 0) return;
  deep_overlaps_told_ = true;
  warn(*lmp, style() +
                 ": discs overlap by more than half of a radius: k_n is too small for the load (is the "
                 "density rho h in kg/m^2, not in kg/m^3?)");
}

const std::vector<AppliedContact>* DiscLaw::applied_contacts() const {
  return recorded_step_ == update->ntimestep ? &applied_ : nullptr;
}

std::size_t DiscLaw::bytes_of_pairs() const {
  return pairs_.size() * sizeof(physics::DiscPair) + histories_.size() * sizeof(double*) +
         in_contact_.size() + near_.bytes() + applied_.capacity() * sizeof(AppliedContact);
}

std::size_t DiscLaw::bytes_in_engine() const {
  return histories_.size() * (2 * sizeof(double) + sizeof(int));
}

double DiscLaw::strongest_contact() const {
  double strongest = 0;
  for (const auto& pair : pairs_) {
    const physics::DiscRow &a = packed_.discs[pair.i], &b = packed_.discs[pair.j];
    const double overlap = a.radius() + b.radius() - std::hypot(a.x() - b.x(), a.y() - b.y());
    if (overlap <= 0) continue;
    const double k_n = parameters(atom->type[pair.i], atom->type[pair.j]).normal_stiffness;
    const double reduced = physics::reduced_radius(a.radius(), b.radius());
    strongest = std::max(strongest, physics::with_law(effects_.normal, [&](auto law) {
                           return law.force(k_n, {overlap, 0, 0, 0, reduced});
                         }));
  }
  return strongest;
}

std::size_t DiscLaw::contacts() const {
  return std::count_if(pairs_.begin(), pairs_.end(), [this](const physics::DiscPair& pair) {
    return physics::are_near(packed_.discs[pair.i], packed_.discs[pair.j], 0);
  });
}

void DiscLaw::evaluate(const Evaluation& evaluation) {
  if (!run_started_) start_run(evaluation.list);
  if (packed_.check_is_off) neighbor->build_once = 0;
  if (packed_.asks_for_lists != 0) asks_for_lists(*neighbor) = std::exchange(packed_.asks_for_lists, 0);
  if (packed_.clear_is_off) forces_are_not_cleared(*update->integrate) = 0;
  forces_are_stale_ = packed_.clear_is_off;
  packed_.check_is_off = packed_.clear_is_off = false;
  // The same on all ranks, even on those without discs.
  packed_.open = evaluation.is_step && will_stay_open();
  recording_ = evaluation.is_step && schedule_.due(*update, *output);
  if (recording_) applied_.clear();
  for (DiscIntegrator* integrator : integrators_) integrator->send_to_ghosts();
  if (atom->nlocal > 0) {
    const bool observed = recording_ || evaluation.is_observed;
    evaluated_step_ = update->ntimestep;
    (this->*preparation_)(evaluation);
    rows_step_ = update->ntimestep;
    if (packed_.open && !observed) {
      waiting_.emplace(evaluation);
    } else {
      (this->*(observed ? observed_loop_ : plain_loop_))(evaluation, {});
    }
  }
  if (recording_) recorded_step_ = update->ntimestep;
}

void DiscLaw::complete_step(const MoveDiscs& move_discs) {
  if (waiting_) (this->*plain_loop_)(*waiting_, move_discs);
  waiting_.reset();
  if (move_discs) move_discs(atom->nlocal);
}

}  // namespace mikromakro::styles
