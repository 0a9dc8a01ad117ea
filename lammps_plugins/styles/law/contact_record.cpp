// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/contact_record.h"

#include <mpi.h>

#include <algorithm>

#include "atom.h"
#include "engine/first_rank.h"
#include "update.h"

namespace mikromakro::styles {

void ContactRecord::begin_run() {
  schedule_.look_up(*lmp);
  has_warned_ = false;
  step_ = -1;
}

void ContactRecord::begin_evaluation(bool is_step) {
  recording_ = is_step && schedule_.due(*update, *output);
  if (!recording_) return;
  contacts_.clear();
  step_ = update->ntimestep;
}

const std::vector<AppliedContact>* ContactRecord::contacts() const {
  return step_ == update->ntimestep ? &contacts_ : nullptr;
}

void ContactRecord::warn_of_deep_overlaps(const std::string& style) {
  if (has_warned_) return;
  constexpr double most = 0.5;  // radii
  int deep = std::any_of(contacts_.begin(), contacts_.end(), [&](const AppliedContact& c) {
    return c.overlap > most * std::min(atom->radius[c.i], atom->radius[c.j]);
  });
  MPI_Allreduce(MPI_IN_PLACE, &deep, 1, MPI_INT, MPI_MAX, world);
  if (deep == 0) return;
  has_warned_ = true;
  warn(*lmp, style +
                 ": discs overlap by more than half of a radius: k_n is too small for the load (is the "
                 "density rho h in kg/m^2, not in kg/m^3?)");
}

}  // namespace mikromakro::styles
