// SPDX-License-Identifier: GPL-2.0-or-later
// What several fixes say of one thing has to be the same.
#pragma once

#include "styles_never_throw.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

/// A fix that divides forces by the thickness of the discs, or writes it down.
class KnowsHeight {
 public:
  virtual ~KnowsHeight() noexcept(styles_never_throw) = default;
  /// m; 0: it was not given.
  virtual double given_height() const = 0;
};

/// One warning each where fixes have been given different heights, so that their stresses do not fit
/// together, and where walls of two fixes have the same id in contact rows. At the start of a run.
void warn_of_disagreement(LAMMPS_NS::LAMMPS& engine);

}  // namespace mikromakro::styles
