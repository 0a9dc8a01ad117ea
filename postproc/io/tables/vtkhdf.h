// SPDX-License-Identifier: GPL-2.0-or-later
// Tables of averages for ParaView.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "io/hdf5/hdf5_file.h"
#include "model/table.h"

namespace mikromakro {

/// A polygon in the plane (m) that shows the values of one table row.
struct Outline {
  std::vector<Eigen::Vector2d> corners;
  Eigen::Index row = 0;
  double direction = 0;  ///< of e_r in its middle (rad from x)
};

/// VTK's HDF5 layout
/// (https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html#vtkhdf-file-format), UnstructuredGrid
/// version 1.0: polygons with every column of the table as cell data, and with vectors (3 components) and
/// tensors (9) in Cartesian components, polar ones rotated to each polygon. Readable by ParaView 5.11 and
/// later.
void write_vtkhdf(const std::string& file, const Table& table, const std::vector<Outline>& outlines);

/// Such a file without its grid, of the given major version.
Hdf5File begin_vtkhdf(const std::string& file, std::int64_t major_version);
/// The grid of such a file.
void add_outlines(Hdf5File& out, const std::vector<Outline>& outlines);

}  // namespace mikromakro
