// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

namespace mikromakro {
namespace {

// Extents of the volumes: limits in two coordinates, such that the volume is the product of the two lengths.
class Extents {
 public:
  explicit Extents(const Table& table) {
    // Ring areas are proportional to differences of r^2.
    add(table, "r_inner", "r_outer", true);
    add(table, "phi_begin", "phi_end", false);
    add(table, "x_min", "x_max", false);
    add(table, "y_min", "y_max", false);
  }

  double size(Eigen::Index volume) const { return common(volume, *this, volume); }
  double common(Eigen::Index volume, const Extents& other, Eigen::Index volume_there) const {
    double size = 1;
    for (std::size_t i = 0; i < limits_.size(); ++i) {
      const double low = std::max(limits_[i][0][volume], other.limits_[i][0][volume_there]);
      const double high = std::min(limits_[i][1][volume], other.limits_[i][1][volume_there]);
      size *= std::max(0.0, high - low);
    }
    return size;
  }

 private:
  void add(const Table& table, std::string_view low, std::string_view high, bool squared) {
    std::array<Eigen::ArrayXd, 2> limits;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const std::string& name = table.columns[i].name;
      if (name == low) limits[0] = table.rows.col(static_cast<Eigen::Index>(i));
      if (name == high) limits[1] = table.rows.col(static_cast<Eigen::Index>(i));
    }
    if (limits[0].size() == 0) return;
    if (squared)
      for (Eigen::ArrayXd& limit : limits) limit = limit.square().eval();
    limits_.push_back(std::move(limits));
  }

  std::vector<std::array<Eigen::ArrayXd, 2>> limits_;
};

}  // namespace

Difference difference(const Eigen::ArrayXd& values, const Eigen::ArrayXd& reference, double period) {
  double sum = 0;
  double largest = 0;
  double squares = 0;
  Eigen::Index rows = 0;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i]) || !std::isfinite(reference[i])) continue;
    const double apart = values[i] - reference[i];
    const double size = std::abs(period > 0 ? std::remainder(apart, period) : apart);
    sum += size;
    largest = std::max(largest, size);
    squares += reference[i] * reference[i];
    ++rows;
  }
  if (rows == 0) largest = std::numeric_limits<double>::quiet_NaN();
  const auto count = static_cast<double>(rows);
  return {sum / count, largest, std::sqrt(squares / count), rows, values.size() - rows};
}

Rows averaged_onto(const Table& onto, const Table& from, Eigen::Index columns) {
  const Extents there(onto);
  const Extents here(from);
  Rows result = Rows::Zero(onto.rows.rows(), columns);
  for (Eigen::Index i = 0; i < result.rows(); ++i) {
    for (Eigen::Index j = 0; j < from.rows.rows(); ++j) {
      const double common = there.common(i, here, j);
      if (common > 0) result.row(i) += common * from.rows.row(j).tail(columns);
    }
    result.row(i) /= there.size(i);
  }
  return result;
}

}  // namespace mikromakro
