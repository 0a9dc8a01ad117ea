// SPDX-License-Identifier: GPL-2.0-or-later
// Output files of averages as functions of time.
#pragma once

#include <memory>
#include <vector>

#include "io/tables/series_writer.h"
#include "options/table_outputs.h"

namespace mikromakro {

/// Writes each window to all files as soon as it is known; the files appear at the end.
class SeriesOutputs {
 public:
  /// `center`: of rings, for ParaView.
  SeriesOutputs(OutputFiles files, const SeriesColumns& columns, const Eigen::Vector2d& center);

  void add(const Eigen::ArrayXd& window, const Rows& values);
  void commit(const Preamble& preamble);

 private:
  OutputFiles files_;
  std::vector<std::unique_ptr<SeriesWriter>> writers_;
};

}  // namespace mikromakro
