// SPDX-License-Identifier: GPL-2.0-or-later
// Consistency checks across fixes.
#pragma once

#include "engine/styles_never_throw.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

/// A fix that divides forces by the disc thickness or writes the thickness to a file.
class KnowsHeight {
 public:
  virtual ~KnowsHeight() noexcept(styles_never_throw) = default;
  /// m; 0 if not given.
  virtual double given_height() const = 0;
};

/// Warns, once each, if fixes have different heights, so that their stresses are inconsistent, and if walls
/// of two fixes have the same id in contact rows. Call at the start of a run.
void warn_of_disagreement(LAMMPS_NS::LAMMPS& engine);

}  // namespace mikromakro::styles
