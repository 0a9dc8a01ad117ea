// SPDX-License-Identifier: GPL-2.0-or-later
// Tables of windows for ParaView.
#pragma once

#include "io/hdf5/hdf5_file.h"
#include "io/tables/cartesian_parts.h"
#include "io/tables/series_writer.h"
#include "io/tables/vtkhdf.h"

namespace mikromakro {

/// VTK's HDF5 layout (see write_vtkhdf()), UnstructuredGrid version 2.0 with the group Steps: the polygons
/// once, and every column of the table as cell data of each window, with vectors and tensors. Steps/Values,
/// which ParaView shows as time, are the times of the windows if these ascend, else their steps, else
/// (several runs) their numbers from 0. Readable by ParaView 5.12 and later.
class SeriesVtkhdf : public SeriesWriter {
 public:
  SeriesVtkhdf(const std::string& file, SeriesColumns columns, std::vector<Outline> outlines);

  void add(const Eigen::ArrayXd& window, const Rows& values) override;
  void finish(const Preamble& preamble) override;

 private:
  void add_column(const std::string& name, std::uint64_t length);
  void write_steps();

  Hdf5File out_;
  SeriesColumns columns_;
  std::vector<Outline> outlines_;
  std::vector<CartesianPart> parts_;  ///< of the values
  std::vector<Hdf5Dataset> window_data_, volume_data_, value_data_, part_data_;
  std::vector<double> times_, steps_;  ///< of the windows
};

}  // namespace mikromakro
