// SPDX-License-Identifier: GPL-2.0-or-later
// Constants of a run, stored once in its snapshot file.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "io/hdf5/hdf5_file.h"

namespace mikromakro {

/// The contact law, its options and its constants: strings as attributes of /parameters, numbers as datasets
/// below it (SI units).
struct SnapshotParameters {
  struct Numbers {
    std::string name;
    std::string unit;  ///< empty: not known
    Hdf5Shape shape;
    std::vector<double> values;
    bool operator==(const Numbers&) const = default;
  };
  std::vector<std::pair<std::string, std::vector<std::string>>> words;
  std::vector<Numbers> numbers;
  std::string engine = {};  ///< name and version; the only member that may change when a file is continued
  bool operator==(const SnapshotParameters&) const = default;
};

/// The constants that averages use.
struct RunConstants {
  std::string units;                     ///< as the engine calls them; empty: not given
  double height = 0;                     ///< m, 0: not given
  std::vector<double> normal_stiffness;  ///< k_n (N/m) of all pairs of types i, j at (i - 1) * types + j - 1;
                                         ///< empty for non-linear laws
  std::string unit_of_stiffness;         ///< of kn
  bool nonlinear = false;                ///< kn is no linear stiffness, since its unit is N/m^q
  std::vector<double> friction;          ///< mu of all pairs of types
  std::string law;                       ///< its effects, and those of walls, in words; empty: not given
  std::string unrecorded_walls;          ///< whose contacts are not in the rows; empty: none, or not known
};
RunConstants read_constants(const Hdf5File& file, const std::string& name);

void write_parameters(Hdf5File& file, const SnapshotParameters& parameters);

/// Throws, naming the first difference, unless the file `name` holds the same parameters.
void check_parameters(const Hdf5File& file, const std::string& name, const SnapshotParameters& parameters);

}  // namespace mikromakro
