// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/creeping_tail.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace mikromakro {
namespace {

constexpr Eigen::Index fewest_inner = 4, fewest_outer = 3;
constexpr double parameters_of_line = 2, parameters_of_two = 5;

struct Line {
  double slope = 0;
  Eigen::ArrayXd residuals;

  double squares() const { return residuals.square().sum(); }
};

Line line_through(const Eigen::ArrayXd& x, const Eigen::ArrayXd& y) {
  const Eigen::ArrayXd dx = x - x.mean(), dy = y - y.mean();
  const double slope = (dx * dy).sum() / dx.square().sum();
  return {slope, dy - slope * dx};
}

// How many independent rings there are: n (1 - rho)/(1 + rho) with the correlation rho of neighbours, which
// two lines make smaller by 4/n.
double independent(const Eigen::ArrayXd& residuals) {
  const auto n = static_cast<double>(residuals.size());
  const double square = residuals.square().sum();
  if (square == 0) return n;
  const Eigen::Index pairs = residuals.size() - 1;
  const double rho = (residuals.head(pairs) * residuals.tail(pairs)).sum() / square + 4 / n;
  constexpr double most = 0.95;
  const double positive = std::clamp(rho, 0.0, most);
  return std::max(2.0, n * (1 - positive) / (1 + positive));
}

double bic(double mean_square, double points, double parameters) {
  constexpr double rounding = 1e-24;  // of log v, squared
  return points * std::log(std::max(mean_square, rounding)) + parameters * std::log(points);
}

// Rings that have a value, by radius.
std::vector<Eigen::Index> known_rings(const RingProfile& profile) {
  std::vector<Eigen::Index> rings;
  for (Eigen::Index i = 0; i < profile.r.size(); ++i)
    if (std::isfinite(profile.v[i])) rings.push_back(i);
  std::sort(rings.begin(), rings.end(),
            [&](Eigen::Index one, Eigen::Index other) { return profile.r[one] < profile.r[other]; });
  return rings;
}

}  // namespace

CreepingTail creeping_tail(const RingProfile& profile) {
  CreepingTail tail;
  const std::vector<Eigen::Index> rings = known_rings(profile);
  if (rings.empty()) return tail;
  const Eigen::ArrayXd r = profile.r(rings), v = profile.v(rings);
  Eigen::Index n = 0;
  while (n < r.size() && v[n] * v[0] > 0) ++n;
  tail.sign_from = r.size() - n;
  if (tail.sign_from > 0 && n > 0) {
    tail.found = true;
    tail.last_r = r[n - 1];
    tail.rings = tail.sign_from;
    tail.s = std::nan("");
  }
  const Eigen::ArrayXd log_v = v.head(n).abs().log();
  double least = std::numeric_limits<double>::infinity(), points = 0;
  CreepingTail best = tail;
  for (Eigen::Index inner = fewest_inner; inner + fewest_outer <= n; ++inner) {
    const Line first = line_through(r.head(inner), log_v.head(inner));
    const Line second = line_through(r.segment(inner, n - inner), log_v.tail(n - inner));
    const double squares = first.squares() + second.squares();
    if (!(second.slope > first.slope) || !(squares < least)) continue;
    least = squares;
    Eigen::ArrayXd residuals(n);
    residuals << first.residuals, second.residuals;
    points = independent(residuals);
    best = {true, r[inner - 1], r.size() - inner, -1 / second.slope, 0, tail.sign_from};
  }
  if (!std::isfinite(least)) return tail;
  const auto rings_with_sign = static_cast<double>(n);
  best.evidence =
      bic(line_through(r.head(n), log_v).squares() / rings_with_sign, points, parameters_of_line) -
      bic(least / rings_with_sign, points, parameters_of_two);
  tail.evidence = best.evidence;
  return best.evidence > 0 ? best : tail;
}

}  // namespace mikromakro
