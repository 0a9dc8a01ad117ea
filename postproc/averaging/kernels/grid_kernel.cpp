// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/kernels/grid_kernel.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "averaging/volumes/reached_intervals.h"

namespace mikromakro {
namespace {

// Edges along one axis, relative to a point.
class Axis {
 public:
  Axis(std::vector<double> edges, const Kernel& kernel)
      : edges_(std::move(edges)), width_(kernel.width()), reach_(kernel.reach() * kernel.width()) {}

  int intervals() const { return static_cast<int>(edges_.size()) - 1; }

  Intervals reached(double x) const { return reached_intervals(edges_, x - reach_, x + reach_); }

  // From the point to an edge, in kernel widths.
  double to_edge(int edge, double x) const { return (edges_[static_cast<std::size_t>(edge)] - x) / width_; }

 private:
  std::vector<double> edges_;
  double width_;
  double reach_;
};

class GridKernel : public PointShares {
 public:
  GridKernel(std::shared_ptr<const Kernel> kernel, std::vector<double> x_edges, std::vector<double> y_edges)
      : kernel_(std::move(kernel)), x_(std::move(x_edges), *kernel_), y_(std::move(y_edges), *kernel_) {}

 protected:
  std::shared_ptr<const Kernel> kernel_;
  Axis x_;
  Axis y_;
};

class GaussGrid : public GridKernel {
 public:
  using GridKernel::GridKernel;

  void add(const Eigen::Vector2d& point, double factor, ShareSums& shares) const override {
    const Intervals columns = x_.reached(point[0]);
    const Intervals rows = y_.reached(point[1]);
    const std::vector<double> along_x = parts(x_, columns, point[0]);
    const std::vector<double> along_y = parts(y_, rows, point[1]);
    for (int j = rows.first; j < rows.last; ++j) {
      const double of_row = factor * along_y[static_cast<std::size_t>(j - rows.first)];
      for (int i = columns.first; i < columns.last; ++i)
        shares.add(j * x_.intervals() + i, of_row * along_x[static_cast<std::size_t>(i - columns.first)]);
    }
  }

 private:
  // Fraction of the kernel below an edge, taking all of it to lie within the reach.
  double below(const Axis& axis, int edge, double x) const {
    const double q = axis.to_edge(edge, x);
    if (std::abs(q) >= kernel_->reach()) return q < 0 ? 0 : 1;
    return 0.5 * std::erfc(-q / std::numbers::sqrt2);
  }
  std::vector<double> parts(const Axis& axis, const Intervals& range, double x) const {
    std::vector<double> parts;
    if (range.last <= range.first) return parts;
    parts.reserve(static_cast<std::size_t>(range.last - range.first));
    double before = below(axis, range.first, x);
    for (int i = range.first; i < range.last; ++i) {
      const double next = below(axis, i + 1, x);
      parts.push_back(next - before);
      before = next;
    }
    return parts;
  }
};

class RadialGrid : public GridKernel {
 public:
  using GridKernel::GridKernel;

  void add(const Eigen::Vector2d& point, double factor, ShareSums& shares) const override {
    const Intervals columns = x_.reached(point[0]);
    const Intervals rows = y_.reached(point[1]);
    if (columns.last <= columns.first) return;
    std::vector<double> below(static_cast<std::size_t>(columns.last - columns.first) + 1);
    // Differences of the corners give the cell outlines.
    const auto corner = [&](int i, int j) {
      const double x = x_.to_edge(i, point[0]);
      const double y = y_.to_edge(j, point[1]);
      return kernel_->line_sweep(x, y) + kernel_->line_sweep(y, x);
    };
    for (int j = rows.first; j <= rows.last; ++j) {
      double left = 0;
      for (int i = columns.first; i <= columns.last; ++i) {
        const double upper = corner(i, j);
        const double next = upper - std::exchange(below[static_cast<std::size_t>(i - columns.first)], upper);
        if (j > rows.first && i > columns.first && next - left > rounding)
          shares.add((j - 1) * x_.intervals() + i - 1, factor * (next - left));
        left = next;
      }
    }
  }

 private:
  static constexpr double rounding = 4e-15;
};

}  // namespace

std::unique_ptr<const PointShares> grid_kernel(std::shared_ptr<const Kernel> kernel,
                                               std::vector<double> x_edges, std::vector<double> y_edges) {
  if (dynamic_cast<const GaussKernel*>(kernel.get()) != nullptr)
    return std::make_unique<const GaussGrid>(std::move(kernel), std::move(x_edges), std::move(y_edges));
  return std::make_unique<const RadialGrid>(std::move(kernel), std::move(x_edges), std::move(y_edges));
}

}  // namespace mikromakro
