// SPDX-License-Identifier: GPL-2.0-or-later
#include "audit/ring_balance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "audit/table_column.h"
#include "fields/velocity_gradient.h"

namespace mikromakro {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The larger of the two, nan if either is nan: an unknown balance must not pass.
double larger(double a, double b) {
  return std::isnan(a) || std::isnan(b) ? nan : std::max(a, b);
}

}  // namespace

std::vector<RingBalance> ring_balances(const Table& table, double height, double margin) {
  const Eigen::ArrayXd inner = column_of(table, "r_inner");
  const Eigen::ArrayXd outer = column_of(table, "r_outer");
  const Eigen::ArrayXd r = column_of(table, "r");
  const Eigen::ArrayXd rr = column_of(table, "sigma_rr");
  const Eigen::ArrayXd phiphi = column_of(table, "sigma_phiphi");
  const Eigen::ArrayXd torque = 2 * std::numbers::pi * r.square() * height * column_of(table, "sigma_phir");
  const Eigen::ArrayXd slope = slopes(r, r * rr);
  // A margin of whole rings excludes the same number on either side, however their edges are rounded.
  const double from = inner[0] + margin * (1 - 1e-9), to = outer[r.size() - 1] - margin * (1 - 1e-9);
  std::vector<RingBalance> rings;
  for (Eigen::Index i = 0; i < r.size(); ++i) {
    const bool counts = inner[i] >= from && outer[i] <= to;
    rings.push_back({r[i], torque[i], slope[i], phiphi[i], -0.5 * (rr[i] + phiphi[i]), counts});
  }
  return rings;
}

double torque_deviation(const std::vector<RingBalance>& rings, double wheel_torque) {
  double largest = -1;
  for (const RingBalance& ring : rings)
    if (ring.counts) largest = larger(largest, std::abs(ring.torque / wheel_torque - 1));
  return largest < 0 ? nan : largest;
}

double radial_deviation(const std::vector<RingBalance>& rings) {
  double largest = -1;
  double pressure = 0;
  int count = 0;
  for (std::size_t i = 1; i + 1 < rings.size(); ++i) {
    const RingBalance& ring = rings[i];
    if (!rings[i - 1].counts || !ring.counts || !rings[i + 1].counts) continue;
    largest = larger(largest, std::abs(ring.slope - ring.sigma_phiphi));
    pressure += ring.pressure;
    ++count;
  }
  return count == 0 ? nan : largest / std::abs(pressure / count);
}

}  // namespace mikromakro
