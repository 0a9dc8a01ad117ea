// SPDX-License-Identifier: GPL-2.0-or-later
// Tables of windows as comma-separated text: one long table, with a row for each volume of each window.
#pragma once

#include <functional>
#include <iosfwd>

#include "io/files/spool.h"
#include "io/tables/series_writer.h"

namespace mikromakro {

class SeriesCsv : public SeriesWriter {
 public:
  /// `publish` receives the function that writes the complete text; called by finish().
  using Write = std::function<void(std::ostream&)>;
  SeriesCsv(SeriesColumns columns, std::function<void(const Write&)> publish);

  void add(const Eigen::ArrayXd& window, const Rows& values) override;
  void finish(const Preamble& preamble) override;

 private:
  SeriesColumns columns_;
  std::function<void(const Write&)> publish_;
  Spool rows_;
};

}  // namespace mikromakro
