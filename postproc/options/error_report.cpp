#include "options/error_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mikromakro {
namespace {

std::string report(const FieldErrors& made) {
  const CorrelationTime& correlation = made.correlation;
  const ErrorDecision& decision = made.decision;
  if (std::isnan(correlation.time)) return made.field.name + ": none, 2 tau is not known";
  const std::string time =
      fmt::format("{}: {}2 tau = {:.3g} +- {:.2g} frames", made.field.name, decision.given ? "" : "none, ",
                  correlation.time, correlation.time * correlation.uncertainty);
  if (!decision.given)
    return fmt::format("{}, {:.3g} effective samples of the {:.3g} that are needed", time, decision.samples,
                       std::ceil(decision.needed));
  return fmt::format(
      "{}, from series to series by {:.0f} %, {:.3g} effective samples, {:.3g} degrees of freedom", time,
      100 * correlation.scatter, decision.samples, decision.freedom);
}

}  // namespace

void describe_errors(const BlockErrors& errors, const TimeAverage& average, Preamble& lines) {
  const std::string blocks =
      fmt::format("{} blocks of {} frames", average.blocks().size(), average.block_length());
  lines.emplace_back("errors", errors.any() ? fmt::format("standard errors by the jackknife of {}", blocks)
                                            : fmt::format("nan: {} are too few for standard errors", blocks));
  const bool known = std::any_of(errors.fields.begin(), errors.fields.end(),
                                 [](const FieldErrors& made) { return !std::isnan(made.correlation.time); });
  if (!known) return;
  for (const FieldErrors& made : errors.fields) lines.emplace_back("errors of", report(made));
}

}  // namespace mikromakro
