// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/tables/series_table.h"

namespace mikromakro {

void SeriesTable::add(const Eigen::ArrayXd& window, const Rows& values) {
  for (Eigen::Index volume = 0; volume < values.rows(); ++volume) {
    numbers_.insert(numbers_.end(), window.begin(), window.end());
    const auto place = columns_.volumes.row(volume);
    numbers_.insert(numbers_.end(), place.begin(), place.end());
    const auto row = values.row(volume);
    numbers_.insert(numbers_.end(), row.begin(), row.end());
  }
}

Table SeriesTable::table() const {
  Table all{columns_.all(), {}};
  const auto columns = std::ssize(all.columns);
  all.rows = Eigen::Map<const Rows>(numbers_.data(), std::ssize(numbers_) / columns, columns);
  return all;
}

}  // namespace mikromakro
