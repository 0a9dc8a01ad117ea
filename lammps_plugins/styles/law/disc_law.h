// SPDX-License-Identifier: GPL-2.0-or-later
// Engine-independent part of the pair style. The engine's own class parses the script, fetches material
// constants and supplies neighbour lists and contact histories; this class evaluates the contacts of a step
// in two dimensions. It is composed of settings (law_settings.h), material constants (material_constants.h),
// pair lists (pair_lists.h), their skin budget (skin_budget.h), packed disc data (packed_discs.h), the pair
// loop (pair_loop.h) and the record of contacts for output (contact_record.h).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "law/contact_record.h"
#include "law/law_settings.h"
#include "law/material_constants.h"
#include "law/open_steps.h"
#include "law/packed_discs.h"
#include "law/pair_lists.h"
#include "law/pair_loop.h"
#include "law/skin_budget.h"
#include "law/time_step_check.h"
#include "pointers.h"

namespace LAMMPS_NS {
class NeighList;
}

namespace mikromakro::styles {

class DiscIntegrator;

/// What the law shares with the fix that integrates the motion of the discs.
struct SharedStep {
  explicit SharedStep(LAMMPS_NS::LAMMPS* engine) : skin(engine) {}

  PackedDiscs packed;
  PairLists lists;
  SkinBudget skin;  // of the lists
  SkippedWork skipped;
};

class DiscLaw : protected LAMMPS_NS::Pointers {
  friend class AddedLoads;
  friend class CarriedDiscs;

 public:
  explicit DiscLaw(LAMMPS_NS::LAMMPS* engine) : Pointers(engine), shared_(engine), record_(engine) {}
  ~DiscLaw() override = default;
  DiscLaw(const DiscLaw&) = delete;
  DiscLaw& operator=(const DiscLaw&) = delete;

  /// Name of the pair style, as prefix of error messages.
  virtual std::string style() const = 0;
  /// The material constants given in the script.
  virtual std::vector<MaterialConstant> given_constants() const = 0;
  /// Makes the engine copy contact histories from the neighbour list to the atoms, for restart files and
  /// migration to other ranks.
  virtual void copy_histories_to_atoms() = 0;

  // The law. Constants and velocities_predicted() are valid from the start of a run.
  const physics::Effects& effects() const { return settings_.effects(); }
  /// Without friction, spins do not change, and rows do not hold them.
  bool rows_have_spins() const { return settings_.has_friction(); }
  /// Constants of two types (counted from 1).
  const physics::ContactParameters& parameters(int type_1, int type_2) const {
    return materials_(type_1, type_2);
  }
  /// True if contacts use velocities that are predicted for the time of the positions.
  bool velocities_predicted() const { return predicted_; }
  /// See SkinBudget.
  double largest_radius(int type) const { return shared_.skin.largest_radius(type); }

  // The contacts of the last evaluation.
  const PairLists& pair_lists() const { return shared_.lists; }
  /// See ContactRecord.
  const std::vector<AppliedContact>* applied_contacts() const { return record_.contacts(); }
  void warn_of_deep_overlaps() { record_.warn_of_deep_overlaps(style()); }
  /// Memory of pairs and recorded contacts in this class.
  std::size_t bytes_of_pairs() const { return shared_.lists.bytes() + record_.bytes(); }
  /// Current number of touching pairs on this rank.
  std::size_t contacts() const { return shared_.lists.contacts(shared_.packed.discs); }
  /// Largest elastic contact force on this rank [N].
  double strongest_contact() const;
  /// An owned disc as used in this step's contact evaluation; nullptr before the evaluation.
  const physics::DiscRow* evaluated_row(int i) const;

  // Open steps (packed_discs.h).
  /// True if the loads of the last force evaluation are in the packed disc data, not in the engine.
  bool step_is_open() const { return shared_.packed.open; }
  /// True if steps of this run may be open.
  bool steps_may_be_open() const { return shared_.packed.may_be_open; }
  /// True if nothing reads end-of-step data in this step, so that it ends open.
  bool step_may_end_open() const { return shared_.packed.may_be_open && !readers_.any_at_present_step(*lmp); }
  /// In an open step, contact forces are not needed until the next step begins; each disc is then moved as
  /// soon as all its contacts have been evaluated, while its row is still in cache. Call before reading
  /// loads; the integrator passes a function that advances all discs with index < before.
  void complete_step(const PairLoop::MoveDiscs& move_discs = {});
  /// For integrators, once the last step of a run is closed: the checks of its contacts. Collective.
  void run_ended();
  /// Completes the step and writes pending data to the engine's arrays: positions and velocities of the rows,
  /// loads, tangential displacements.
  void close();

  /// For the fix that integrates; other fixes use fixes_in_step.h.
  SharedStep& shared_step(const DiscIntegrator& /*caller*/) { return shared_; }

 protected:
  /// One call of the engine's pair style.
  struct Evaluation {
    const LAMMPS_NS::NeighList& list;
    bool is_step;                 // false: re-evaluation for output
    bool advances_displacements;  // false in a set-up
    bool is_tallied;              // the engine wants each contact: see tally()
  };
  /// A contact for the engine's own tallies: force [N] and torque [N m] on disc i, vector from i to j [m].
  struct TalliedContact {
    int i, j;
    double d_x, d_y, overlap, f_x, f_y, torque;
    double* history;  // nullptr for laws without a spring
  };

  virtual ContactHistory contact_history() = 0;
  virtual void tally(const TalliedContact& contact) = 0;

  [[noreturn]] void fail(const std::string& what) const;
  void require_two_dimensions() const;

  LawSettings& law_settings() { return settings_; }
  /// Call after each change of the settings.
  void use_settings() { loop_.choose_instance(settings_.effects()); }

  /// Call at the start of a run.
  void begin_run(MaterialTable materials);
  void evaluate(const Evaluation& evaluation);

 private:
  void complete_set_up(const LAMMPS_NS::NeighList& list);
  void find_integrators();
  TimeScales time_scales() const;
  void check_steps_to_come(const LAMMPS_NS::NeighList& list);
  void update_rows_and_lists(const LAMMPS_NS::NeighList& list);
  void run_loop(const Evaluation& evaluation, const PairLoop::MoveDiscs& move_discs, bool observed);
  void observe(const Evaluation& evaluation, const physics::ContactBatch& batch, int lane, int pair);
  [[noreturn]] void abort_at_coincident_centres(const physics::DiscPair& pair) const;

  LawSettings settings_;
  MaterialTable materials_;
  bool one_material_ = false;  // the same constants for all pairs of types
  SharedStep shared_;
  PairLoop loop_;
  ContactRecord record_;
  EndOfStepReaders readers_;
  std::vector<DiscIntegrator*> integrators_;
  bool predicted_ = false;  // by all integrators
  bool set_up_complete_ = false;
  int held_ = 0;             // groups_with_set_forces()
  double checked_step_ = 0;  // the largest time step checked [s]
  LAMMPS_NS::bigint checked_discs_ = 0;
  Told told_;
  const LAMMPS_NS::NeighList* list_of_run_ = nullptr;  // between the set-up and the end of a run
  LAMMPS_NS::bigint rows_step_ = -1;                   // step that the rows belong to
  std::optional<Evaluation> waiting_;                  // of an open step whose loop has not run yet
};

}  // namespace mikromakro::styles
