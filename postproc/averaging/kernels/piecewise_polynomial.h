// SPDX-License-Identifier: GPL-2.0-or-later
// A function of one variable as a table of polynomials.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace mikromakro {

/// Polynomials of degree 9 that interpolate a function at the Chebyshev points of each piece. For a function
/// with smooth length L (n-th derivative about sqrt(n!)/L^n), pieces of 0.7 L give 1e-11.
class PiecewisePolynomial {
 public:
  /// Interpolates between the first and the last of the ascending `breaks`, in pieces that are no longer than
  /// `longest` and end at the breaks, where the function is less smooth. Throws what the function throws.
  PiecewisePolynomial(const std::function<double(double)>& function, const std::vector<double>& breaks,
                      double longest);

  /// The function at x, between the first and the last break. Never throws.
  double operator()(double x) const {
    std::size_t i = 0;
    while (i + 1 < stretches_.size() && x >= stretches_[i + 1].begin) ++i;
    const Stretch& stretch = stretches_[i];
    const double along = (x - stretch.begin) * stretch.per_length;
    const int piece = along < stretch.last ? static_cast<int>(along) : static_cast<int>(stretch.last);
    const double* c = polynomials_[stretch.first + static_cast<std::size_t>(piece)].data();
    const double t = 2 * (along - piece) - 1;
    // Two chains without dependencies between them.
    const double s = t * t;
    const double even = c[0] + s * (c[2] + s * (c[4] + s * (c[6] + s * c[8])));
    const double odd = c[1] + s * (c[3] + s * (c[5] + s * (c[7] + s * c[9])));
    return even + t * odd;
  }

 private:
  static constexpr int terms = 10;
  using Terms = Eigen::Matrix<double, terms, 1>;
  // Equal pieces between two breaks.
  struct Stretch {
    double begin;
    double per_length;  // pieces per length
    double last;        // index of the last piece
    std::size_t first;  // index of its first polynomial
  };

  std::vector<Stretch> stretches_;
  std::vector<Terms> polynomials_;
};

}  // namespace mikromakro
