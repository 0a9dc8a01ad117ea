// SPDX-License-Identifier: GPL-2.0-or-later
// Contents of a snapshot file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/files/column_map.h"
#include "io/hdf5/hdf5_file.h"

namespace mikromakro {

/// Contents of a snapshot file, obtained without reading its frames.
struct SnapshotSummary {
  std::vector<std::int64_t> steps;
  std::vector<double> times;                  ///< s; empty: none in the file
  std::vector<std::int64_t> contact_offsets;  ///< empty: no contacts
  std::uint64_t most_particles = 0;
  ColumnSet particles_given = 0;
  ColumnSet contacts_given = 0;
  std::vector<Hdf5Dataset> elements;  ///< in the order of snapshot::elements
  std::vector<Hdf5Dataset> columns;   ///< by ContactColumn; empty: no contacts
};
/// Throws if datasets have other shapes or units than in the layout, or are inconsistent.
SnapshotSummary summarise_snapshots(const Hdf5File& file, const std::string& name);

}  // namespace mikromakro
