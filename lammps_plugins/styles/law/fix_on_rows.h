// SPDX-License-Identifier: GPL-2.0-or-later
// Interfaces of fixes that work on the packed disc data of a step (packed_discs.h). A fix that implements one
// of them takes part in open steps; the disc law knows no other fix.
#pragma once

#include <vector>

#include "engine/styles_never_throw.h"
#include "physics/rows/disc_rows.h"

namespace mikromakro::styles {

/// A fix that moves discs in their rows, or adds to their loads.
class FixOnRows {
 public:
  virtual ~FixOnRows() noexcept(styles_never_throw) = default;
  /// The calls (FixConst) in which the fix, while a step is open, reads and writes nothing of the discs but
  /// rows and loads. Any other call of it closes every step.
  virtual int calls_on_rows() const = 0;
};

/// A fix that integrates the motion of discs and may predict velocities for the time of the positions.
class DiscIntegrator {
 public:
  virtual ~DiscIntegrator() noexcept(styles_never_throw) = default;
  virtual bool predicts_velocities() const = 0;
  /// Turns the engine's velocities into those used for contacts, in the rows from `first` on.
  virtual void predict(std::vector<physics::DiscRow>& rows, int first) const = 0;
  /// In a closed step, sends ghosts what the engine does not send within the step: the predictions, and the
  /// radii, which a fix may have changed. Collective.
  virtual void send_to_ghosts() = 0;
};

}  // namespace mikromakro::styles
