// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/tables/cartesian_parts.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace mikromakro {
namespace {

using Kind = CartesianPart::Kind;

struct Endings {
  Kind kind;
  bool polar;
  std::vector<std::string_view> endings;
};

const std::vector<Endings>& known_endings() {
  static const std::vector<Endings> known = {{Kind::tensor, true, {"_rr", "_rphi", "_phir", "_phiphi"}},
                                             {Kind::tensor, false, {"_xx", "_xy", "_yx", "_yy"}},
                                             {Kind::out_of_plane, true, {"_zr", "_zphi"}},
                                             {Kind::out_of_plane, false, {"_zx", "_zy"}},
                                             {Kind::vector, true, {"_r", "_phi"}},
                                             {Kind::vector, false, {"_x", "_y"}}};
  return known;
}

// The common beginning of the names from `first` on that have these endings; empty if they do not.
std::string beginning(const std::vector<Column>& columns, std::size_t first, const Endings& endings) {
  if (first + endings.endings.size() > columns.size()) return {};
  std::string name;
  for (std::size_t i = 0; i < endings.endings.size(); ++i) {
    const std::string& whole = columns[first + i].name;
    if (!whole.ends_with(endings.endings[i])) return {};
    const std::string begin = whole.substr(0, whole.size() - endings.endings[i].size());
    if (i > 0 && begin != name) return {};
    name = begin;
  }
  return name;
}

bool is_column(const std::vector<Column>& columns, const std::string& name) {
  return std::any_of(columns.begin(), columns.end(),
                     [&](const Column& column) { return column.name == name; });
}

}  // namespace

std::vector<double> CartesianPart::at(const Rows& rows, Eigen::Index row, double angle) const {
  Eigen::Matrix2d turn = Eigen::Matrix2d::Identity();
  if (polar) turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  const double* first = &rows(row, column);
  if (kind == Kind::tensor) {
    const Eigen::Map<const Eigen::Matrix<double, 2, 2, Eigen::RowMajor>> own(first);
    const Eigen::Matrix2d t = turn * own * turn.transpose();
    return {t(0, 0), t(0, 1), 0, t(1, 0), t(1, 1), 0, 0, 0, 0};
  }
  const Eigen::Vector2d v = turn * Eigen::Map<const Eigen::Vector2d>(first);
  if (kind == Kind::vector) return {v.x(), v.y(), 0};
  return {0, 0, 0, 0, 0, 0, v.x(), v.y(), 0};
}

std::vector<CartesianPart> cartesian_parts(const std::vector<Column>& columns) {
  std::vector<CartesianPart> parts;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    for (const Endings& endings : known_endings()) {
      const std::string name = beginning(columns, i, endings);
      if (name.empty() || is_column(columns, name)) continue;
      parts.push_back({name, endings.kind, endings.polar, static_cast<Eigen::Index>(i)});
      break;
    }
  }
  return parts;
}

}  // namespace mikromakro
