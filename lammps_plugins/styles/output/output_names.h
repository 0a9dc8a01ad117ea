// SPDX-License-Identifier: GPL-2.0-or-later
// Output files of a run: two outputs must not write the same file.
#pragma once

#include <string>
#include <vector>

#include "engine/styles_never_throw.h"

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace mikromakro::styles {

/// A fix that writes files of its own.
class FileWriter {
 public:
  virtual ~FileWriter() noexcept(styles_never_throw) = default;
  /// File names as in the script, with a * for the step.
  virtual std::vector<std::string> output_names() const = 0;
};

/// Stops the run if another of our fixes or a dump writes a file of `own`, under any name or link, or if
/// units are not SI, in which the files are written.
void check_outputs(LAMMPS_NS::LAMMPS& engine, const LAMMPS_NS::Fix& own);

}  // namespace mikromakro::styles
