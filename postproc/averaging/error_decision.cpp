#include "averaging/error_decision.h"

#include <algorithm>
#include <cmath>

#include "fit/student_t.h"

namespace mikromakro {
namespace {

constexpr double fewest_samples = 8;
constexpr double bad_samples = 6;     // of which errors are not to be believed
constexpr double three_errors = 1.8;  // of log 2 tau of one series of so many samples
constexpr double least_freedom = 3;

double needed_samples(const CorrelationTime& correlation, double count) {
  if (count / correlation.most >= fewest_samples) return fewest_samples;
  const double error = three_errors / std::sqrt(correlation.independent_series);
  return std::max(fewest_samples, bad_samples * std::exp(error));
}

}  // namespace

double student_width(double freedom) {
  constexpr double one_sigma = 0.682689492137086, two_sided = 0.95, quantile = 1.959963984540054;
  return 0.5 * (student_t(one_sigma, freedom) + student_t(two_sided, freedom) / quantile);
}

ErrorDecision decide(const CorrelationTime& correlation, double count) {
  ErrorDecision decision;
  if (std::isnan(correlation.time)) return decision;
  decision.samples = count / correlation.time;
  decision.needed = needed_samples(correlation, count);
  const double of_time = correlation.uncertainty_of_series;
  decision.freedom = 2 / (2 * correlation.squares / count + of_time * of_time);
  decision.given = decision.samples >= decision.needed && decision.freedom >= least_freedom;
  if (!decision.given) return decision;
  const double near = decision.needed / decision.samples;
  const double may_be = correlation.time * (1 + 3 * correlation.uncertainty);
  const double too_small = near * (1 - 1 / may_be) * correlation.uncertainty;
  decision.widening = student_width(decision.freedom) * std::sqrt(1 + too_small);
  return decision;
}

}  // namespace mikromakro
