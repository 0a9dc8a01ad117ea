// SPDX-License-Identifier: GPL-2.0-or-later
#include "statistics/error_decision.h"

#include <algorithm>
#include <cmath>

#include "statistics/student_t.h"

namespace mikromakro {
namespace {

constexpr double two_sided_quantile = 1.959963984540054;
constexpr double fewest_samples = 8;
constexpr double most_uncertain = 0.2;  // of 2 tau, relative
constexpr double most_unknown = 0.1;    // of the variation between series
constexpr double least_freedom = 3;

double needed_samples(const CorrelationTime& correlation, double count) {
  if (count / correlation.most >= fewest_samples) return fewest_samples;
  const double ratio = correlation.uncertainty / most_uncertain;
  return std::max(fewest_samples * (1 + correlation.uncertainty), ratio * ratio * count / correlation.time);
}

}  // namespace

double student_width(double freedom) {
  constexpr double one_sigma = 0.682689492137086, two_sided = 0.95;
  return 0.5 * (student_t(one_sigma, freedom) + student_t(two_sided, freedom) / two_sided_quantile);
}

double skewed_width(double square_skewness, double samples) {
  constexpr double square = two_sided_quantile * two_sided_quantile;
  // No correction at one sigma.
  constexpr double mean = 0.5 * (square * square + 2 * square - 3) / 18;
  return 1 + mean * square_skewness * (samples - 1) / std::pow(samples - 2, 2);
}

ErrorDecision decide(const CorrelationTime& correlation, double count) {
  ErrorDecision decision;
  if (std::isnan(correlation.time)) return decision;
  decision.samples = count / correlation.time;
  decision.needed = needed_samples(correlation, count);
  decision.unlike = correlation.unknown_scatter > most_unknown;
  const double of_time = correlation.uncertainty_of_series;
  // Subtracting the mean of all values takes one degree of freedom.
  decision.freedom = 2 / (2 * correlation.squares / (count - 1) + of_time * of_time);
  decision.given =
      decision.samples >= decision.needed && !decision.unlike && decision.freedom >= least_freedom;
  if (!decision.given) return decision;
  const double near = decision.needed / decision.samples;
  const double may_be = correlation.time * (1 + correlation.uncertainty);
  const double too_small = near * (1 - 1 / may_be) * correlation.uncertainty;
  decision.widening = student_width(decision.freedom) * std::sqrt(1 + too_small) *
                      skewed_width(correlation.square_skewness, decision.samples);
  return decision;
}

ErrorDecision decide_by_runs(double freedom) {
  ErrorDecision decision;
  decision.by_runs = true;
  decision.samples = freedom + 1;
  decision.needed = 1 + least_freedom;
  decision.freedom = freedom;
  constexpr double rounding = 1e-9;
  decision.given = decision.freedom > least_freedom - rounding;
  if (decision.given) decision.widening = student_width(decision.freedom);
  return decision;
}

}  // namespace mikromakro
