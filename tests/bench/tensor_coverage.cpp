// SPDX-License-Identifier: GPL-2.0-or-later
#include "tensor_coverage.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "statistics/field_trials.h"

namespace mikromakro::bench {
namespace {

std::vector<std::pair<std::string, FieldTrials>> layouts() {
  return {{"20 volumes, 64 frames", {20, 1, 64, 0}},
          {"20 volumes, 200 frames, correlation 0.5", {20, 1, 200, 0.5}},
          {"20 volumes, 8 runs of 20", {20, 8, 20, 0}},
          {"1 volume, 200 frames", {1, 1, 200, 0}},
          {"1 volume, 8 runs of 20", {1, 8, 20, 0}}};
}

std::string cells(const Coverage& covered) {
  constexpr double few = 0.001;
  if (!(covered.given > few)) return fmt::format("{:.1f} | - | -", 100 * covered.given);
  return fmt::format("{:.1f} | {:.1f} | {:.1f}", 100 * covered.given, 100 * covered.one_sigma,
                     100 * covered.two_sided);
}

void axes_line(const std::string& name, const FieldTrials& trials, double ratio, Eigen::Index rows,
               int count) {
  fmt::print("| {} | {:g} |", name, ratio);
  for (Eigen::Index column = 0; column < trials.truth.cols(); ++column)
    fmt::print(" {} |", cells(coverage_of_column(trials, column, rows, count)));
  fmt::print("\n");
}

void axes(int count) {
  fmt::print("\nPrincipal axes (deviator in standard deviations of the mean of its components)\n\n");
  fmt::print("| series | deviator |");
  for (const char* name : {"trace", "deviator", "angle", "major", "minor"})
    fmt::print(" {}: given % | 68 % | 95 % |", name);
  fmt::print("\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const auto& [name, layout] : layouts())
    for (const double ratio : {0., 1., 2., 3., 4., 5., 10.})
      axes_line(name, axes_trials(layout, Eigen::ArrayXd::Constant(layout.volumes, ratio)), ratio,
                layout.volumes, count);
  constexpr double large = 20;
  for (const auto& [name, layout] : {layouts()[0], layouts()[2]}) {
    for (const double ratio : {0., 1., 2., 3., 5.}) {
      Eigen::ArrayXd ratios = Eigen::ArrayXd::Constant(layout.volumes, large);
      ratios.head(layout.volumes / 2) = ratio;
      axes_line(name + ", half of them (counted) beside 20", axes_trials(layout, ratios), ratio,
                layout.volumes / 2, count);
    }
  }
}

void stiffnesses(int count) {
  fmt::print(
      "\nmu_c (curvature in standard deviations of the mean of its components; noise of M relative to ");
  fmt::print("that of mu_c kappa)\n\n| series | noise of M | curvature | given % | 68 % | 95 % |\n");
  fmt::print("|---|---|---|---|---|---|\n");
  for (const auto& [name, layout] : layouts())
    for (const double noise : {0.2, 1.})
      for (const double ratio : {1., 2., 3., 5., 7., 10., 20., 40.})
        fmt::print(
            "| {} | {:g} | {:g} | {} |\n", name, noise, ratio,
            cells(coverage_of_column(stiffness_trials(layout, ratio, noise), 0, layout.volumes, count)));
}

}  // namespace

void print_tensor_coverage(int trials) {
  axes(trials);
  stiffnesses(trials);
}

}  // namespace mikromakro::bench
