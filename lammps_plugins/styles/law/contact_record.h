// SPDX-License-Identifier: GPL-2.0-or-later
// Record of the contacts between discs as applied in a step, for output.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "law/contact_schedule.h"
#include "physics/contact/contact_state.h"
#include "pointers.h"

namespace mikromakro::styles {

/// A contact as applied in the last force evaluation; signs as in physics/contact/contact_state.h, SI units.
struct AppliedContact {
  int i, j;  // local indices; i is owned, j may be a ghost
  double n_x, n_y, overlap;
  physics::ContactForce force;
  double v_n, v_t;
};

/// Holds the contacts of one step at a time, and only of steps in which something reads them.
class ContactRecord : protected LAMMPS_NS::Pointers {
 public:
  explicit ContactRecord(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}

  /// Call at the start of a run, when all fixes and computes are defined.
  void begin_run();
  /// A force evaluation begins. `is_step`: false in a re-evaluation for output, which is not recorded.
  void begin_evaluation(bool is_step);
  bool is_recording() const { return recording_; }
  void add(const AppliedContact& contact) { contacts_.push_back(contact); }

  /// Contacts of this step's force evaluation; nullptr if the step was not recorded.
  const std::vector<AppliedContact>* contacts() const;
  /// Warns, once per run, if a recorded overlap exceeds half of the smaller radius. `style`: prefix of the
  /// message. Collective.
  void warn_of_deep_overlaps(const std::string& style);
  std::size_t bytes() const { return contacts_.capacity() * sizeof(AppliedContact); }

 private:
  ContactSchedule schedule_;
  bool recording_ = false;
  bool has_warned_ = false;
  LAMMPS_NS::bigint step_ = -1;  // of the contacts
  std::vector<AppliedContact> contacts_;
};

}  // namespace mikromakro::styles
