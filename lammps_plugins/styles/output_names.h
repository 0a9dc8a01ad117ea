// SPDX-License-Identifier: GPL-2.0-or-later
// Files that a run writes: what one output writes, another one would replace.
#pragma once

#include <string>
#include <vector>

#include "styles_never_throw.h"

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace mikromakro::styles {

/// A fix that writes files of its own.
class FileWriter {
 public:
  virtual ~FileWriter() noexcept(styles_never_throw) = default;
  /// As the script names them, with a * for the step.
  virtual std::vector<std::string> output_names() const = 0;
};

/// Ends the run where another fix of ours or a dump writes one of the files of `own`, by whatever name or
/// link, and under other units than SI, in which the files are.
void check_outputs(LAMMPS_NS::LAMMPS& engine, const LAMMPS_NS::Fix& own);

}  // namespace mikromakro::styles
