// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/tables/series_csv.h"

#include <ostream>

namespace mikromakro {
namespace {

template <typename Numbers>
void append(const Numbers& numbers, std::string& text) {
  for (const double number : numbers) text.append(number_text(number)) += ',';
}

}  // namespace

std::vector<Column> SeriesColumns::all() const {
  std::vector<Column> columns = of_window;
  columns.insert(columns.end(), of_volume.begin(), of_volume.end());
  columns.insert(columns.end(), values.begin(), values.end());
  return columns;
}

SeriesCsv::SeriesCsv(SeriesColumns columns, std::function<void(const Write&)> publish)
    : columns_(std::move(columns)), publish_(std::move(publish)) {}

void SeriesCsv::add(const Eigen::ArrayXd& window, const Rows& values) {
  std::string begin;
  append(window, begin);
  for (Eigen::Index volume = 0; volume < values.rows(); ++volume) {
    std::string line = begin;
    append(columns_.volumes.row(volume), line);
    append(values.row(volume), line);
    line.back() = '\n';
    rows_.add(line);
  }
}

void SeriesCsv::finish(const Preamble& preamble) {
  publish_([&](std::ostream& stream) {
    stream << csv_text(preamble, {columns_.all(), {}});
    rows_.copy_to(stream);
  });
}

}  // namespace mikromakro
