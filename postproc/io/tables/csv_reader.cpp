// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/tables/csv_reader.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "io/files/line_reader.h"
#include "io/files/row_parser.h"
#include "model/nearest_name.h"

namespace mikromakro {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string_view> cells(std::string_view line) {
  std::vector<std::string_view> all;
  for (auto comma = line.find(','); comma != std::string_view::npos; comma = line.find(',')) {
    all.push_back(trimmed(line.substr(0, comma)));
    line.remove_prefix(comma + 1);
  }
  all.push_back(trimmed(line));
  return all;
}

std::vector<std::string> checked_names(std::string_view line, const Place& place) {
  std::vector<std::string> names;
  for (const std::string_view name : cells(line)) {
    if (name.empty())
      throw bad_input(place, "column without a name", "names between commas", in_quotes(line));
    if (std::find(names.begin(), names.end(), name) != names.end())
      throw bad_input(place, "column named twice", "each name once", in_quotes(name));
    names.emplace_back(name);
  }
  return names;
}

double cell_value(std::string_view cell, const std::string& column, const Place& place) {
  if (cell == "nan" || cell == "-nan") return std::nan("");
  double value = 0;
  const auto parsed = fast_float::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (parsed.ptr == cell.data())
    throw bad_input(place, fmt::format("not a number in column {}", in_quotes(column)),
                    "a number, as in tables of `mikromakro average`", in_quotes(cell));
  return parse_number(cell, place);
}

}  // namespace

CsvTable::CsvTable(const std::string& file) : file_(file) {
  LineReader lines(file);
  std::vector<double> values;
  std::string_view line;
  while (lines.next(line)) {
    if (line.starts_with('#')) {
      comments_.emplace_back(trimmed(line.substr(1)));
    } else if (names_.empty()) {
      names_ = checked_names(line, lines.place());
      names_line_ = lines.line();
    } else {
      const auto row = cells(line);
      if (row.size() != names_.size()) {
        throw bad_input(lines.place(), "wrong number of columns in the row", fmt::format("{}", names_.size()),
                        fmt::format("{}", row.size()));
      }
      row_lines_.push_back(lines.line());
      for (std::size_t i = 0; i < row.size(); ++i)
        values.push_back(cell_value(row[i], names_[i], lines.place()));
    }
  }
  if (names_.empty()) throw bad_input({file_}, "no table in the file", "a line of column names", "none");
  const auto columns = static_cast<Eigen::Index>(names_.size());
  const auto rows = static_cast<Eigen::Index>(values.size()) / columns;
  using RowMajor = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  values_ = Eigen::Map<const RowMajor>(values.data(), rows, columns);
}

bool CsvTable::has(std::string_view name) const {
  return std::find(names_.begin(), names_.end(), name) != names_.end();
}

Eigen::ArrayXd CsvTable::column(std::string_view name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end())
    throw bad_input({file_, names_line_}, "no such column", fmt::format("one of {}", fmt::join(names_, " ")),
                    in_quotes_with_guess(name, std::vector<std::string_view>(names_.begin(), names_.end())));
  return values_.col(found - names_.begin());
}

CsvTable CsvTable::part(Eigen::Index begin, Eigen::Index rows) const {
  CsvTable some = *this;
  some.values_ = values_.middleRows(begin, rows);
  some.row_lines_.assign(row_lines_.begin() + begin, row_lines_.begin() + begin + rows);
  return some;
}

// 'column NAME [UNIT] (EQUATION) TEXT', as written by csv_text().
std::string CsvTable::unit(std::string_view name) const {
  const std::string begin = fmt::format("column {} [", name);
  for (const std::string_view line : comments_)
    if (line.starts_with(begin)) return std::string(line.substr(begin.size(), line.find(']') - begin.size()));
  return {};
}

}  // namespace mikromakro
