// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/tables/csv_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "model/error.h"

namespace mikromakro {

namespace {

// Names of files may contain line breaks.
std::string on_one_line(const std::string& value) {
  return one_line(value, value.size());
}

}  // namespace

std::string number_text(double value) {
  return std::isnan(value) ? "nan" : fmt::format("{:.17g}", value);
}

std::string csv_text(const Preamble& preamble, const Table& table) {
  std::string text;
  for (const auto& [name, value] : preamble)
    fmt::format_to(std::back_inserter(text), "# {}: {}\n", name, on_one_line(value));
  for (const Column& column : table.columns) {
    fmt::format_to(std::back_inserter(text), "# column {} [{}] ({}) {}\n", column.name,
                   on_one_line(column.unit), column.equation, on_one_line(column.text));
  }
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    text.append(i > 0 ? "," : "").append(table.columns[i].name);
  text += '\n';
  for (Eigen::Index row = 0; row < table.rows.rows(); ++row) {
    for (Eigen::Index i = 0; i < table.rows.cols(); ++i)
      text.append(i > 0 ? "," : "").append(number_text(table.rows(row, i)));
    text += '\n';
  }
  return text;
}

}  // namespace mikromakro
