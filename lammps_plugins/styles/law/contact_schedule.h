// SPDX-License-Identifier: GPL-2.0-or-later
// The steps in which contacts are recorded, because something reads them.
#pragma once

#include <vector>

#include "engine/styles_never_throw.h"
#include "lmptype.h"
#include "pointers.h"

namespace LAMMPS_NS {
class Compute;
}

namespace mikromakro::styles {

/// A fix that reads contacts in steps of its own, which are not in the engine's output schedule.
class ContactObserver {
 public:
  virtual ~ContactObserver() noexcept(styles_never_throw) = default;
  virtual bool wants_contacts_at(LAMMPS_NS::bigint step) const = 0;
};

/// The steps in which contacts are recorded: the set-up; the last step; steps scheduled for thermo, dumps or
/// restarts if a compute contact/disc exists; steps for which another fix has requested one (e.g. fix
/// ave/time through a compute reduce); and steps requested by an observer.
class ContactSchedule {
 public:
  /// Call at the start of a run, when all fixes and computes are defined.
  void look_up(LAMMPS_NS::LAMMPS& engine);
  bool due(const LAMMPS_NS::Update& update, const LAMMPS_NS::Output& output) const;

 private:
  std::vector<LAMMPS_NS::Compute*> computes_;
  std::vector<const ContactObserver*> observers_;
};

}  // namespace mikromakro::styles
