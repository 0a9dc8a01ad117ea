// SPDX-License-Identifier: GPL-2.0-or-later
// Tables of windows as self-describing HDF5.
#pragma once

#include "io/hdf5/hdf5_file.h"
#include "io/tables/series_writer.h"

namespace mikromakro {

/// /table/<column> as in write_table_hdf5(), with time as the first dimension: columns of the window have one
/// number per window, those of the volume one per volume, values windows x volumes; the attribute `axes`
/// names the dimensions of each.
class SeriesHdf5 : public SeriesWriter {
 public:
  SeriesHdf5(const std::string& file, SeriesColumns columns);

  void add(const Eigen::ArrayXd& window, const Rows& values) override;
  void finish(const Preamble& preamble) override;

 private:
  void describe(const Column& column, const std::vector<std::string>& axes);

  Hdf5File out_;
  SeriesColumns columns_;
  std::vector<Hdf5Dataset> of_window_, values_;
  std::uint64_t windows_ = 0;
};

}  // namespace mikromakro
