// SPDX-License-Identifier: GPL-2.0-or-later
#include "statistics/exponential_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <Eigen/LU>
#include <unsupported/Eigen/NonLinearOptimization>

#include "model/error.h"

namespace mikromakro {
namespace {

constexpr int least_points = 3;
constexpr int most_steps = 500;

struct Points {
  std::vector<Eigen::Index> used;
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
    const std::string there =
        all.r.size() > 0 ? fmt::format(" (r = {:.4g} to {:.4g} m)", all.r.minCoeff(), all.r.maxCoeff()) : "";
    throw run_failed("too few rings for the fit",
                     fmt::format("at least {} with finite values{}", least_points, there),
                     fmt::format("{}", used.size()));
  }
  if ((all.v(used) == 0).all())
    throw run_failed("there is nothing to fit", "values that are not 0", "0 in every ring");
  Points points{used, all.r(used) - r_i, all.v(used),
                Eigen::ArrayXd::Ones(static_cast<Eigen::Index>(used.size()))};
  // Relative to the smallest error, so that the sums stay of order v^2.
  if (weighted) points.weight = (all.error(used).minCoeff() / all.error(used)).square();
  return points;
}

// v0 and the decay rate q = 1/s: the sum of squares is smooth in q, even for a profile that hardly decays.
using Parameters = Eigen::Vector2d;

// ln|v| is a straight line in r. Values of weight 0 may have any sign.
Parameters straight_line(const Points& points, const Eigen::ArrayXd& weight, double sign) {
  const Eigen::ArrayXd logarithm = (sign * points.v > 0).select((points.v.abs()).log(), 0.0);
  const double sum = weight.sum();
  const double mean_x = (weight * points.x).sum() / sum;
  const double mean_l = (weight * logarithm).sum() / sum;
  const double spread = (weight * (points.x - mean_x).square()).sum();
  const double slope = (weight * (points.x - mean_x) * (logarithm - mean_l)).sum() / spread;
  return {sign * std::exp(mean_l - slope * mean_x), -slope};
}

double sign_of(const Points& points) {
  return (points.weight * points.v * points.v.abs()).sum() < 0 ? -1 : 1;
}

// Weighted by v^2, since the logarithm amplifies the scatter of small values.
Parameters start(const Points& points) {
  const double sign = sign_of(points);
  return straight_line(points, (sign * points.v > 0).select(points.weight * points.v.square(), 0.0), sign);
}

// Derivatives of v with respect to the parameters.
Eigen::MatrixX2d jacobian(const Points& points, const Parameters& p) {
  Eigen::MatrixX2d jacobian(points.x.size(), 2);
  const Eigen::ArrayXd decay = (-p[1] * points.x).exp();
  jacobian.col(0) = decay;
  jacobian.col(1) = -p[0] * points.x * decay;
  return jacobian;
}

// For Eigen's port of MINPACK's lmder: residuals and their derivatives by v0 and q.
struct Residuals {
  const Points& points;
  Eigen::ArrayXd root_of_weight = points.weight.sqrt();

  Eigen::Index values() const { return points.x.size(); }
  int operator()(const Eigen::VectorXd& p, Eigen::VectorXd& residual) const {
    residual = root_of_weight * (p[0] * (-p[1] * points.x).exp() - points.v);
    return residual.allFinite() ? 0 : -1;
  }
  int df(const Eigen::VectorXd& p, Eigen::MatrixXd& change) const {
    change = root_of_weight.matrix().asDiagonal() * jacobian(points, p);
    return 0;
  }
};

Parameters least_squares(const Points& points) {
  Residuals residuals{points};
  Eigen::LevenbergMarquardt<Residuals> search(residuals);
  // Iterates until no better point exists to within rounding.
  search.parameters.ftol = search.parameters.xtol = 0;
  search.parameters.maxfev = most_steps;
  Eigen::VectorXd p = start(points);
  const auto end = search.minimize(p);
  using namespace Eigen::LevenbergMarquardtSpace;
  if (!p.allFinite() || end == TooManyFunctionEvaluation || end == UserAsked)
    throw run_failed("the fit does not converge", "a profile v0 exp(-(r - R_i)/s)",
                     fmt::format("v0 = {}, s = {} after {} steps", p[0], 1 / p[1], search.nfev));
  return p;
}

// Derivative of p with respect to v, where rows of `of_p` are d f/d p, f is the fitted quantity, and `of_v`
// is df/dv.
Eigen::Matrix2Xd change_with_v(const Eigen::MatrixX2d& of_p, const Eigen::ArrayXd& weight,
                               const Eigen::ArrayXd& of_v) {
  const Eigen::Matrix2Xd weighted = of_p.transpose() * weight.matrix().asDiagonal();
  return (weighted * of_p).inverse() * weighted * of_v.matrix().asDiagonal();
}

struct Fitted {
  Parameters p;
  Eigen::Matrix2Xd change;  // of p with v
};

Fitted fit_velocity(const Points& points) {
  const Parameters p = least_squares(points);
  return {p, change_with_v(jacobian(points, p), points.weight, Eigen::ArrayXd::Ones(points.v.size()))};
}

Fitted fit_logarithm(const Points& points, bool weighted) {
  const double sign = sign_of(points);
  if ((sign * points.v <= 0).any())
    throw run_failed("log v is undefined in some rings, where v is 0 or has the other sign",
                     "values of one sign, or a --range where they are",
                     fmt::format("{} to {}", points.v.minCoeff(), points.v.maxCoeff()));
  const Eigen::ArrayXd weight = weighted ? Eigen::ArrayXd(points.weight * points.v.square()) : points.weight;
  const Parameters p = straight_line(points, weight, sign);
  Eigen::MatrixX2d of_p(points.x.size(), 2);
  of_p.col(0).setConstant(1 / p[0]);
  of_p.col(1) = -points.x;
  return {p, change_with_v(of_p, weight, 1 / points.v)};
}

// Distance between the two points closest to the wheel.
double first_distance(Eigen::ArrayXd x) {
  std::partial_sort(x.begin(), x.begin() + 2, x.end());
  return x[1] - x[0];
}

}  // namespace

ExponentialProfile fit_exponential(const ProfilePoints& all, double r_i, FitOf of) {
  const Points points = finite_points(all, r_i);
  const auto [p, change] =
      of == FitOf::v ? fit_velocity(points) : fit_logarithm(points, all.error.size() > 0);
  const double s = 1 / p[1];
  // A profile that falls by less than this over the rings is constant to within rounding.
  constexpr double least_fall = 1e-9;
  const bool falls = p[1] * (points.x.maxCoeff() - points.x.minCoeff()) > least_fall;
  if (!falls || p[0] == 0) {
    throw run_failed("the profile does not decay", "v0 != 0 and s > 0",
                     fmt::format("v0 = {}, s = {}", p[0], s));
  }
  // If a profile falls below a millionth from one ring to the next, only one ring is resolved, which does not
  // determine v0 and s.
  constexpr double most_fall = 14;
  if (p[1] * first_distance(points.x) > most_fall)
    throw run_failed("the profile decays within a ring", "finer rings, or another profile",
                     fmt::format("v0 = {}, s = {}", p[0], s));
  ExponentialProfile profile{p[0], s, 0, points.used, change};
  profile.change.row(1) *= -s * s;
  profile.residual_rms = std::sqrt((points.v - p[0] * (-p[1] * points.x).exp()).square().mean());
  return profile;
}

}  // namespace mikromakro
