#include "fit/exponential_profile.h"

#include <fmt/format.h>

#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <vector>

#include "fit/student_t.h"
#include "io/error.h"

namespace mikromakro {
namespace {

constexpr int least_points = 3;
constexpr int most_steps = 500;
constexpr double confidence = 0.95;

struct Points {
  Eigen::ArrayXd x;  // r - r_i
  Eigen::ArrayXd v;
  Eigen::ArrayXd weight;
};

Points finite_points(const ProfilePoints& all, double r_i) {
  const bool weighted = all.error.size() > 0;
  std::vector<Eigen::Index> used;
  for (Eigen::Index i = 0; i < all.v.size(); ++i) {
    const bool known = std::isfinite(all.r[i]) && std::isfinite(all.v[i]);
    if (known && (!weighted || (std::isfinite(all.error[i]) && all.error[i] > 0))) used.push_back(i);
  }
  if (static_cast<int>(used.size()) < least_points) {
    throw run_failed("too few rings for the fit", fmt::format("at least {} with finite values", least_points),
                     fmt::format("{}", used.size()));
  }
  if ((all.v(used) == 0).all())
    throw run_failed("there is nothing to fit", "values that are not 0", "0 in every ring");
  Points points{all.r(used) - r_i, all.v(used), Eigen::ArrayXd::Ones(static_cast<Eigen::Index>(used.size()))};
  // Relative to the smallest error, so that the sums stay of the size of v^2.
  if (weighted) points.weight = (all.error(used).minCoeff() / all.error(used)).square();
  return points;
}

// v0 and the decay rate q = 1/s: the sum of squares is smooth in q, also where a profile hardly decays.
using Parameters = Eigen::Vector2d;

double sum_of_squares(const Points& points, const Parameters& p) {
  return (points.weight * (points.v - p[0] * (-p[1] * points.x).exp()).square()).sum();
}

// ln|v| is a straight line in r; weighted by v^2, since the logarithm stretches the small values.
Parameters start(const Points& points) {
  const double sign = (points.weight * points.v * points.v.abs()).sum() < 0 ? -1 : 1;
  const Eigen::ArrayXd weight = (sign * points.v > 0).select(points.weight * points.v.square(), 0.0);
  const Eigen::ArrayXd logarithm = (sign * points.v > 0).select((points.v.abs()).log(), 0.0);
  const double sum = weight.sum();
  const double mean_x = (weight * points.x).sum() / sum;
  const double mean_l = (weight * logarithm).sum() / sum;
  const double spread = (weight * (points.x - mean_x).square()).sum();
  const double slope = (weight * (points.x - mean_x) * (logarithm - mean_l)).sum() / spread;
  return {sign * std::exp(mean_l - slope * mean_x), -slope};
}

struct NormalEquations {
  Eigen::Matrix2d matrix;
  Eigen::Vector2d right;
};

NormalEquations normal_equations(const Points& points, const Parameters& p) {
  Eigen::MatrixX2d jacobian(points.x.size(), 2);
  const Eigen::ArrayXd decay = (-p[1] * points.x).exp();
  jacobian.col(0) = decay;
  jacobian.col(1) = -p[0] * points.x * decay;
  const Eigen::VectorXd residual = points.v - p[0] * decay;
  const auto weighted = points.weight.matrix().asDiagonal();
  return {jacobian.transpose() * weighted * jacobian, jacobian.transpose() * weighted * residual};
}

Parameters levenberg_marquardt(const Points& points) {
  Parameters p = start(points);
  double damping = 1e-3;
  double best = sum_of_squares(points, p);
  for (int step = 0; step < most_steps && p.allFinite(); ++step) {
    const NormalEquations equations = normal_equations(points, p);
    Eigen::Matrix2d damped = equations.matrix;
    damped.diagonal() *= 1 + damping;
    const Parameters change = damped.ldlt().solve(equations.right);
    const bool settled = (change.array().abs() <= 1e-14 * p.array().abs()).all();
    const double now = sum_of_squares(points, p + change);
    if (settled) return p;
    if (now <= best) {
      p += change;
      best = now;
      damping = std::max(0.1 * damping, 1e-12);
    } else if (damping > 1e12) {
      return p;  // no better point within rounding
    } else {
      damping *= 10;
    }
  }
  throw run_failed("the fit does not converge", "a profile v0 exp(-(r - R_i)/s)",
                   fmt::format("v0 = {}, s = {} after {} steps", p[0], 1 / p[1], most_steps));
}

}  // namespace

ExponentialProfile fit_exponential(const ProfilePoints& all, double r_i) {
  const Points points = finite_points(all, r_i);
  const Parameters p = levenberg_marquardt(points);
  if (!(p[1] > 0) || p[0] == 0) {
    throw run_failed("the profile does not decay", "v0 != 0 and s > 0",
                     fmt::format("v0 = {}, s = {}", p[0], 1 / p[1]));
  }
  const auto n = static_cast<int>(points.x.size());
  const Eigen::Matrix2d inverse = normal_equations(points, p).matrix.inverse();
  const double variance = sum_of_squares(points, p) / (n - 2);
  const double t = student_t(confidence, n - 2);
  const double s = 1 / p[1];
  const double half_v0 = t * std::sqrt(variance * inverse(0, 0));
  const double half_s = t * std::sqrt(variance * inverse(1, 1)) * s * s;  // ds = s^2 dq
  ExponentialProfile profile;
  profile.v0 = {p[0], p[0] - half_v0, p[0] + half_v0};
  profile.s = {s, s - half_s, s + half_s};
  profile.points = n;
  profile.residual_rms = std::sqrt((points.v - p[0] * (-p[1] * points.x).exp()).square().mean());
  return profile;
}

}  // namespace mikromakro
