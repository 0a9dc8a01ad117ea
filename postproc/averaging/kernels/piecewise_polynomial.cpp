// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/kernels/piecewise_polynomial.h"

#include <cmath>
#include <Eigen/LU>
#include <numbers>

namespace mikromakro {

PiecewisePolynomial::PiecewisePolynomial(const std::function<double(double)>& function,
                                         const std::vector<double>& breaks, double longest) {
  Terms points;
  for (int i = 0; i < terms; ++i) points[i] = std::cos(std::numbers::pi * (i + 0.5) / terms);
  Eigen::Matrix<double, terms, terms> powers;
  for (int k = 0; k < terms; ++k) powers.col(k) = points.array().pow(k);
  const Eigen::Matrix<double, terms, terms> to_terms = powers.inverse();
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    const double length = breaks[i] - breaks[i - 1];
    const double pieces = std::fmax(1, std::ceil(length / longest));
    stretches_.push_back({breaks[i - 1], pieces / length, pieces - 1, polynomials_.size()});
    for (double piece = 0; piece < pieces; ++piece) {
      Terms values;
      for (int k = 0; k < terms; ++k)
        values[k] = function(breaks[i - 1] + length * (piece + 0.5 + 0.5 * points[k]) / pieces);
      polynomials_.emplace_back(to_terms * values);
    }
  }
}

}  // namespace mikromakro
