// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/fit_choices.h"

#include <fmt/format.h>

#include <cmath>

#include "model/error.h"

namespace mikromakro {
namespace {

constexpr double behind_layers = 0.5;  // in units of s
constexpr double end_of_zone = 4;      // in units of s

std::vector<FitWay> ways_of_range(const FitWay& way, const FitSaid& said) {
  if (said.way) return {way};
  std::vector<FitWay> ways(3, way);
  ways[1].of = FitOf::log_v;
  ways[2].by_errors = true;
  return ways;
}

std::vector<FitWay> reasonable_ways(double r_i, const FitWay& way, double s, const FitSaid& said) {
  if (said.range) return ways_of_range(way, said);
  std::vector<FitWay> ways;
  for (const double from : {way.from, r_i + behind_layers * s}) {
    for (const double to : {way.to, r_i + end_of_zone * s}) {
      FitWay in_range = way;
      in_range.from = from;
      in_range.to = to;
      for (const FitWay& one : ways_of_range(in_range, said)) {
        if (said.way || one.of == FitOf::v || std::isfinite(to)) ways.push_back(one);
      }
    }
  }
  return ways;
}

std::string name_of(const FitWay& way) {
  std::string name = way.of == FitOf::v ? "v" : "log v";
  if (way.by_errors) name += " by errors";
  if (std::isfinite(way.from)) name += fmt::format(", from {:.4g} m", way.from);
  if (std::isfinite(way.to)) name += fmt::format(", to {:.4g} m", way.to);
  return name;
}

FitChoice choose(const RingProfile& profile, double r_i, const FitWay& way) {
  FitChoice choice{name_of(way), way};
  if (!profile.name.empty()) choice.name += ", " + profile.name;
  try {
    const ExponentialProfile fitted = fit_exponential(profile, r_i, way);
    choice.v0 = fitted.v0;
    choice.s = fitted.s;
  } catch (const Error& error) {
    // v0 and s stay nan.
    const std::string why = error.what();
    choice.missing = why.substr(0, why.find(';'));
  }
  return choice;
}

}  // namespace

ExponentialProfile fit_exponential(const RingProfile& profile, double r_i, const FitWay& way) {
  const auto inside = profile.r >= way.from && profile.r <= way.to;
  return fit_exponential(
      {profile.r, inside.select(profile.v, std::nan("")), way.by_errors ? profile.error : Eigen::ArrayXd()},
      r_i, way.of);
}

std::vector<FitChoice> fit_choices(const std::vector<RingProfile>& profiles, double r_i, const FitWay& way,
                                   double s, const FitSaid& said) {
  std::vector<FitChoice> choices;
  for (const RingProfile& profile : profiles) {
    for (const FitWay& one : reasonable_ways(r_i, way, s, said)) {
      if (!one.by_errors || profile.error.isFinite().any()) choices.push_back(choose(profile, r_i, one));
    }
  }
  return choices;
}

}  // namespace mikromakro
