// SPDX-License-Identifier: GPL-2.0-or-later
// Integrals of kernels by quadrature, and the kernels that tests go through.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "averaging/kernels/kernel.h"

namespace mikromakro {

/// Integral of f from a to b by the double exponential rule, as in reference_areas.h, to about 1e-14, with
/// breaks, in any order, those outside of [a, b] and nan left out.
template <typename Function>
double quick_integral(const Function& f, double a, double b, std::vector<double> breaks = {}) {
  struct Node {
    double part, weight;
  };
  static const std::vector<Node> rule = [] {
    std::vector<Node> nodes;
    constexpr double step = 1.0 / 16;
    for (int k = -52; k <= 52; ++k) {
      const double s = std::numbers::pi / 2 * std::sinh(k * step);
      nodes.push_back({1 / (std::exp(-2 * s) + 1),
                       std::numbers::pi / 4 * step * std::cosh(k * step) / (std::cosh(s) * std::cosh(s))});
    }
    return nodes;
  }();
  std::erase_if(breaks, [&](double x) { return !(x > a && x < b); });
  breaks.insert(breaks.end(), {a, b});
  std::sort(breaks.begin(), breaks.end());
  double sum = 0;
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    const double length = breaks[i] - breaks[i - 1];
    for (const Node& node : rule) sum += length * node.weight * f(breaks[i - 1] + length * node.part);
  }
  return sum;
}

/// X from left to right, Y from bottom to top.
struct KernelRectangle {
  double left, right, bottom, top;
};

struct NamedKernel {
  std::string name;
  std::function<std::shared_ptr<const Kernel>(double width)> make;
};

inline const std::vector<NamedKernel>& kernels() {
  static const std::vector<NamedKernel> all = {
      {"gauss", [](double width) { return std::make_shared<const GaussKernel>(width); }},
      {"lucy", [](double width) { return std::make_shared<const PolynomialKernel>(lucy(), width); }},
      {"wendland", [](double width) { return std::make_shared<const PolynomialKernel>(wendland(), width); }}};
  return all;
}

/// w(q) by the formulae of the literature, not by ours.
inline double density_reference(const std::string& kernel, double q) {
  constexpr double pi = std::numbers::pi;
  if (kernel == "gauss") return std::exp(-q * q / 2) / (2 * pi);
  if (q >= 1) return 0;
  const double rest = 1 - q;
  if (kernel == "lucy") return 5 / pi * (1 + 3 * q) * rest * rest * rest;
  return 7 / pi * (1 + 4 * q) * rest * rest * rest * rest;
}

inline double reach_of(const std::string& kernel) {
  return kernel == "gauss" ? 9 : 1;
}

/// A sector inner <= r < outer, begin <= phi < end (rad, within [-pi, pi]) in which a kernel at (d, 0) lies.
struct KernelSector {
  double d, inner, outer, begin, end;
};

/// Part of a kernel of width 1, d away from the origin, in inner <= r < outer, begin <= phi < end from
/// the direction of its centre: by distances q from the kernel's centre and directions, as
/// far as they lie in the sector; for rings with begin, end = -pi, pi.
inline double sector_part(const std::string& kernel, const KernelSector& s) {
  const double d = s.d;
  const double reach = reach_of(kernel);
  const auto at_radius = [&](double r) {
    // Where the circle of radius r is nearest to the centre of the kernel, and where it leaves its reach.
    double half = std::numbers::pi;
    if (r + d > reach && r > 0 && d > 0)
      half = std::acos(std::clamp((r * r + (d - reach) * (d + reach)) / (2 * r * d), -1.0, 1.0));
    const auto density = [&](double phi) {
      const double sine = std::sin(phi / 2);
      return density_reference(kernel, std::sqrt((r - d) * (r - d) + 4 * r * d * sine * sine));
    };
    const double first = std::max(s.begin, -half);
    const double last = std::min(s.end, half);
    return last > first ? r * quick_integral(density, first, last, {0}) : 0;
  };
  const double low = std::max({s.inner, d - reach, 0.0});
  const double high = std::min(s.outer, d + reach);
  std::vector<double> breaks = {d, reach - d};
  for (const double angle : {s.begin, s.end}) {
    const double root = std::sqrt(reach * reach - d * d * std::sin(angle) * std::sin(angle));
    breaks.push_back(d * std::cos(angle) - root);
    breaks.push_back(d * std::cos(angle) + root);
  }
  return high > low ? quick_integral(at_radius, low, high, breaks) : 0;
}

/// Part of a kernel of width 1 around 0 in a rectangle.
inline double rectangle_part(const std::string& kernel, const KernelRectangle& r) {
  const double reach = reach_of(kernel);
  const auto at_x = [&](double x) {
    const double rim = std::sqrt(std::max(0.0, reach * reach - x * x));
    const auto density = [&](double y) { return density_reference(kernel, std::hypot(x, y)); };
    const double first = std::max(r.bottom, -rim);
    const double last = std::min(r.top, rim);
    return last > first ? quick_integral(density, first, last, {0}) : 0;
  };
  std::vector<double> breaks = {0};
  for (const double y : {r.bottom, r.top}) {
    const double root = std::sqrt(reach * reach - y * y);
    breaks.push_back(root);
    breaks.push_back(-root);
  }
  return quick_integral(at_x, std::max(r.left, -reach), std::min(r.right, reach), breaks);
}

}  // namespace mikromakro
