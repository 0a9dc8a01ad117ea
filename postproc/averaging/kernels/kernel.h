// SPDX-License-Identifier: GPL-2.0-or-later
// Coarse-graining kernels: radially symmetric functions in the plane with unit integral.
#pragma once

#include <Eigen/Core>
#include <span>

namespace mikromakro {

/// W(x) = w(q)/width^2, q = |x|/width, where w integrates to 1 over the plane. Arguments and results below
/// are dimensionless, with lengths in units of the width. No member throws.
class Kernel {
 public:
  explicit Kernel(double width) : width_(width) {}
  Kernel(const Kernel&) = delete;
  Kernel& operator=(const Kernel&) = delete;
  virtual ~Kernel() = default;

  /// m.
  double width() const { return width_; }
  /// Distance beyond which the kernel is 0.
  virtual double reach() const = 0;
  virtual double density(double q) const = 0;
  /// e(q)/q^2, with e the integral of the kernel within the distance q < reach; finite at 0.
  virtual double part_over_square(double q) const = 0;
  /// The same for many points at once, in place: q^2 in, e(q)/q^2 out, to 1e-12.
  virtual void parts_over_squares(std::span<double> squares) const = 0;
  /// Length of pieces on which ten Gauss-Legendre points integrate it to 1e-11.
  virtual double smooth_length() const = 0;
  /// Longest pieces on which 6, 10 and 16 points do so; of_16 = of_10 if more points do not help.
  struct Pieces {
    double of_6, of_10, of_16;
  };
  virtual Pieces pieces() const = 0;
  /// Length of pieces of a branch on which five points integrate shares to 1e-8.
  virtual double branch_piece() const = 0;

  /// Integral of e(|p|)/(2 pi) dtheta, with theta the direction of p seen from the centre of the kernel,
  /// along a straight line from the point nearest to the centre over a length `t`; the line passes at
  /// distance `h` with the centre on its left (negative: on its right). Along a closed outline such integrals
  /// add up to the fraction of the kernel inside it (Green's theorem).
  double line_sweep(double h, double t) const;

  /// The same between two positions on the line, t_1 <= t_2.
  virtual double line_part(double h, double t_1, double t_2) const;

 protected:
  /// The integral from 0 to t >= 0, restricted to the part within the reach.
  virtual double inner_sweep(double h, double t) const = 0;

 private:
  double width_;
};

/// exp(-q^2/2)/(2 pi): the width is the standard deviation in each direction. The tail beyond 7 widths, 2e-11
/// of the integral, is lumped at 7 widths.
class GaussKernel : public Kernel {
 public:
  using Kernel::Kernel;
  double reach() const override { return 7; }
  double density(double q) const override;
  double part_over_square(double q) const override;
  void parts_over_squares(std::span<double> squares) const override;
  double smooth_length() const override { return 1; }
  Pieces pieces() const override;
  double branch_piece() const override { return 1.5; }
  double line_part(double h, double t_1, double t_2) const override;

 protected:
  double inner_sweep(double h, double t) const override;
};

/// w = sum_k c_k q^k for q < 1, else 0: the width is the radius of the support.
class PolynomialKernel : public Kernel {
 public:
  /// c_0 ... c_5, normalised to unit integral.
  using Coefficients = Eigen::Array<double, 6, 1>;
  PolynomialKernel(const Coefficients& coefficients, double width);
  double reach() const override { return 1; }
  double density(double q) const override;
  double part_over_square(double q) const override;
  void parts_over_squares(std::span<double> squares) const override;
  double smooth_length() const override { return 0.25; }
  Pieces pieces() const override;
  double branch_piece() const override { return 0.1875; }

 protected:
  double inner_sweep(double h, double t) const override;

 private:
  Coefficients density_;
  Coefficients part_;  // e_k = 2 pi c_k/(k + 2)
};

/// 5/pi (1 + 3 q)(1 - q)^3 (Lucy1977).
PolynomialKernel::Coefficients lucy();
/// 7/pi (1 + 4 q)(1 - q)^4 (Wendland1995), the one with two continuous derivatives.
PolynomialKernel::Coefficients wendland();

}  // namespace mikromakro
