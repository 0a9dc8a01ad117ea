// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/contact_schedule.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "compute.h"
#include "engine/engine_lists.h"
#include "modify.h"
#include "output.h"
#include "update.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;

namespace {

/// Our compute, and the engine's computes that evaluate single contacts of the pair style.
bool reads_contacts(const Compute& compute) {
  constexpr std::array names = {"contact/disc", "pair/local", "fabric", "group/group"};
  return std::any_of(names.begin(), names.end(),
                     [&](const char* name) { return std::strcmp(compute.style, name) == 0; });
}

}  // namespace

void ContactSchedule::look_up(LAMMPS& engine) {
  const Modify& modify = *engine.modify;
  computes_.clear();
  for (Compute* compute : computes(modify))
    if (reads_contacts(*compute)) computes_.push_back(compute);
  observers_.clear();
  for (const Fix* fix : fixes(modify))
    if (const auto* observer = dynamic_cast<const ContactObserver*>(fix)) observers_.push_back(observer);
}

bool ContactSchedule::due(const Update& update, const Output& output) const {
  const bool scheduled =
      update.setupflag || update.ntimestep == update.laststep || update.ntimestep == output.next;
  if (scheduled && (!computes_.empty() || !observers_.empty())) return true;
  const auto is_asked = [&](Compute* compute) { return compute->matchstep(update.ntimestep) != 0; };
  if (std::any_of(computes_.begin(), computes_.end(), is_asked)) return true;
  return std::any_of(observers_.begin(), observers_.end(), [&](const ContactObserver* observer) {
    return observer->wants_contacts_at(update.ntimestep);
  });
}

}  // namespace mikromakro::styles
