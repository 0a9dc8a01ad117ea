// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/disc_law.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "atom.h"
#include "domain.h"
#include "engine/abort_run.h"
#include "engine/arguments.h"
#include "engine/engine_lists.h"
#include "engine/first_rank.h"
#include "force.h"
#include "law/agreement.h"
#include "law/disc_check.h"
#include "law/effects_line.h"
#include "law/fix_on_rows.h"
#include "law/moving_atoms.h"
#include "law/unseen_forces.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"

namespace mikromakro::styles {

using LAMMPS_NS::NeighList;
using physics::DiscLoad;
using physics::DiscPair;
using physics::DiscRow;

void DiscLaw::fail(const std::string& what) const {
  stop(*lmp, style(), what);
}

void DiscLaw::require_two_dimensions() const {
  if (domain->dimension != 2)
    fail("discs require a two-dimensional simulation; put 'dimension 2' before the box");
  if (force->newton_pair) fail("needs 'newton off' before the box is created");
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

void DiscLaw::begin_run(MaterialTable materials) {
  materials_ = std::move(materials);
  one_material_ = materials_.is_uniform();
  set_up_complete_ = false;
  list_of_run_ = nullptr;
  find_integrators();
  shared_.skin.begin_run(style());
  record_.begin_run();
  readers_.look_up(*lmp);
  shared_.packed.may_be_open = shared_.packed.open = false;
  waiting_.reset();
  shared_.packed.step = rows_step_ = -1;
}

/// Called once per run, when its set-up evaluates forces, rather than on initialisation: the engine also
/// initialises when it writes a restart file.
void DiscLaw::complete_set_up(const NeighList& list) {
  set_up_complete_ = true;
  shared_.skin.check_growth_in_set_up();
  check_discs(*lmp, style(), effects().spring());
  told_.clear();
  held_ = groups_with_set_forces(*lmp);
  check_steps_to_come(list);
  list_of_run_ = &list;
  print_line(*lmp, effects_line(effects(), *modify, predicted_));
  warn_of_unseen_forces(*lmp);
  warn_of_disagreement(*lmp);
}

void DiscLaw::check_steps_to_come(const NeighList& list) {
  checked_step_ = update->dt;
  checked_discs_ = atom->natoms;
  check_time_step(*lmp, list, style(), time_scales(), told_);
}

void DiscLaw::run_ended() {
  if (list_of_run_) check_time_step_of_run(*lmp, *list_of_run_, style(), time_scales());
  list_of_run_ = nullptr;
}

TimeScales DiscLaw::time_scales() const {
  return {effects(), materials_, settings_.impact_velocity(), predicted_, held_};
}

const DiscRow* DiscLaw::evaluated_row(int i) const {
  return rows_step_ == update->ntimestep ? &shared_.packed.discs[i] : nullptr;
}

double DiscLaw::strongest_contact() const {
  double strongest = 0;
  for (const auto& pair : shared_.lists.pairs()) {
    const DiscRow &a = shared_.packed.discs[pair.i], &b = shared_.packed.discs[pair.j];
    const double overlap = a.radius() + b.radius() - std::hypot(a.x() - b.x(), a.y() - b.y());
    if (overlap <= 0) continue;
    const double k_n = parameters(atom->type[pair.i], atom->type[pair.j]).normal_stiffness;
    const double reduced = physics::reduced_radius(a.radius(), b.radius());
    strongest = std::max(strongest, physics::with_law(effects().normal, [&](auto law) {
                           return law.force(k_n, {overlap, 0, 0, 0, reduced});
                         }));
  }
  return strongest;
}

void DiscLaw::evaluate(const Evaluation& evaluation) {
  if (!set_up_complete_) complete_set_up(evaluation.list);
  // Fixes pour discs and reset the time step, and `run ... pre no` has no set-up.
  if (evaluation.is_step && (update->dt > checked_step_ || atom->natoms > checked_discs_))
    check_steps_to_come(evaluation.list);
  shared_.skipped.restore(*lmp);
  // The same on all ranks, even on those without discs.
  shared_.packed.open = evaluation.is_step && step_may_end_open();
  record_.begin_evaluation(evaluation.is_step);
  for (DiscIntegrator* integrator : integrators_) integrator->send_to_ghosts();
  if (atom->nlocal == 0) return;
  update_rows_and_lists(evaluation.list);
  rows_step_ = update->ntimestep;
  const bool observed = record_.is_recording() || evaluation.is_tallied;
  if (shared_.packed.open && !observed) {
    waiting_.emplace(evaluation);
  } else {
    run_loop(evaluation, {}, observed);
  }
}

/// Brings packed disc data and pair lists up to date with the present positions.
void DiscLaw::update_rows_and_lists(const NeighList& list) {
  const bool lists_are_new = neighbor->ago == 0 || !shared_.lists.are_built();
  // The movers of an open step work on the rows of the owned discs.
  const bool only_ghosts_moved = shared_.packed.step == update->ntimestep && neighbor->ago != 0;
  const int first = only_ghosts_moved ? atom->nlocal : 0;
  const DiscChange change = shared_.packed.pack(*atom, first, rows_have_spins());
  for (const DiscIntegrator* integrator : integrators_) integrator->predict(shared_.packed.discs, first);
  if (lists_are_new) {
    const bool springs = effects().spring();
    const ContactHistory history = springs ? contact_history() : ContactHistory{};
    shared_.lists.rebuild(list, atom->nlocal, springs ? &history : nullptr);
    shared_.skin.lists_were_built(shared_.packed.discs);
  } else {
    shared_.skin.spend(change);
  }
  if (lists_are_new || shared_.packed.prune_is_due || shared_.skin.inner_list_is_old()) {
    shared_.packed.prune_is_due = false;
    shared_.lists.prune(shared_.packed.discs, shared_.skin.begin_inner_list(), shared_.packed.exceed_cache());
  }
}

void DiscLaw::run_loop(const Evaluation& evaluation, const PairLoop::MoveDiscs& move_discs, bool observed) {
  // No time passes in a set-up or a minimisation.
  const bool advances = evaluation.is_step && evaluation.advances_displacements && update->whichflag == 1;
  PairLoop::Observer observer;
  if (observed) {
    observer = [&](const physics::ContactBatch& batch, int first, int count) {
      for (int k = 0; k < count; ++k)
        if (batch.touches(k)) observe(evaluation, batch, k, first + k);
    };
  }
  const auto coincident = loop_.run({shared_.packed, shared_.lists, materials_, one_material_, atom->type,
                                     predicted_, advances, advances ? update->dt : 0.0},
                                    move_discs, observer);
  if (coincident) abort_at_coincident_centres(*coincident);
  if (effects().spring() && advances) shared_.lists.displacements_changed();
  if (!shared_.packed.may_be_open) shared_.lists.write_history();
  if (!evaluation.is_step) {
    std::fill(shared_.packed.loads.begin(), shared_.packed.loads.end(), DiscLoad{});
  } else if (shared_.packed.open) {
    // Loads of ghosts are computed on their own ranks.
    std::fill(shared_.packed.loads.begin() + atom->nlocal, shared_.packed.loads.end(), DiscLoad{});
  } else {
    close();
  }
}

/// Passes a contact to our own record and to the engine, if they want it.
void DiscLaw::observe(const Evaluation& evaluation, const physics::ContactBatch& c, int k, int pair) {
  const auto [i, j] = *shared_.lists.inner().from(pair);
  if (record_.is_recording()) {
    const double xi = effects().spring() ? c.springs->xi[k] : 0.0;
    record_.add({i, j, c.n_x[k], c.n_y[k], c.overlap[k], {c.f_n[k], c.f_t[k], xi}, c.v_n[k], c.v_t[k]});
  }
  if (evaluation.is_tallied) {
    const double torque = shared_.packed.discs[i].radius() * c.f_t[k] - c.short_torque[k];
    tally(
        {i, j, c.d_x[k], c.d_y[k], c.overlap[k], c.f_x[k], c.f_y[k], torque, shared_.lists.history_of(pair)});
  }
}

void DiscLaw::abort_at_coincident_centres(const DiscPair& pair) const {
  for (const int i : {pair.i, pair.j}) {
    const physics::DiscRow& row = shared_.packed.discs[i];
    if (!std::isfinite(row.x() + row.y()))
      abort_run(*lmp, style(),
                "disc " + std::to_string(atom->tag[i]) +
                    " has a position that is not finite (nan or inf) in step " + std::to_string(rows_step_) +
                    ": a fix gave it a force or velocity that is not finite, from a direction of length 0 "
                    "for example");
  }
  abort_run(*lmp, style(),
            "discs " + std::to_string(atom->tag[pair.i]) + " and " + std::to_string(atom->tag[pair.j]) +
                " have the same centre in step " + std::to_string(rows_step_) +
                ": their contact has no normal");
}

void DiscLaw::complete_step(const PairLoop::MoveDiscs& move_discs) {
  if (waiting_) run_loop(*waiting_, move_discs, false);
  waiting_.reset();
  if (move_discs) move_discs(atom->nlocal);
}

void DiscLaw::close() {
  complete_step();
  if (shared_.packed.step == update->ntimestep) shared_.packed.unpack_owned(*atom, rows_have_spins());
  shared_.lists.write_history();
  shared_.packed.unload(*atom, rows_have_spins(), shared_.skipped.take_stale_forces());
  shared_.packed.open = false;
  shared_.packed.step = -1;
}

}  // namespace mikromakro::styles
