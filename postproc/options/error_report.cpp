// SPDX-License-Identifier: GPL-2.0-or-later
#include "options/error_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mikromakro {
namespace {

std::string of_runs(const FieldErrors& made) {
  const double chi_square = made.between.chi_square;
  return std::isnan(chi_square) ? "" : fmt::format(", chi^2 between runs {:.2g}", chi_square);
}

// For runs that differ, that change as slowly as they last, or that are many.
std::string report_by_runs(const FieldErrors& made) {
  const ErrorDecision& decision = made.decision;
  std::string why = fmt::format("as always for eight or more runs of about the same length{}", of_runs(made));
  if (made.between.differ())
    why = fmt::format("runs differ by more than their frames explain{}", of_runs(made));
  else if (made.slow.shows())
    why = fmt::format(
        "something changes over times as long as a run (its slowest wave squared is {:.2g} times the next "
        "ones)",
        made.slow.ratio);
  if (decision.given)
    return fmt::format("{}: from the spread of the runs, {:.3g} degrees of freedom; {}", made.field.name,
                       decision.freedom, why);
  return fmt::format("{}: none, {}; four runs of the same length would suffice", made.field.name, why);
}

// Columns and directions without errors, because they are not linear in the sums.
std::string withheld(const FieldErrors& made) {
  std::string remark;
  for (const CurvedColumn& curved : made.nonlinear.curved)
    remark += fmt::format(
        "; none of {}, which is not linear in the sums over the range of its error ({:.2g} times as many "
        "frames or runs would do)",
        curved.name, curved.frames_needed);
  if (made.nonlinear.undirected > 0)
    remark += fmt::format(
        "; none of {} directions, which are hardly determined (deviators below four of their errors)",
        made.nonlinear.undirected);
  return remark;
}

std::string decided(const FieldErrors& made) {
  const CorrelationTime& correlation = made.correlation;
  const ErrorDecision& decision = made.decision;
  if (made.series == 0) return made.field.name + ": none, no column fluctuates";
  if (decision.by_runs) return report_by_runs(made);
  if (std::isnan(correlation.time)) return made.field.name + ": none, 2 tau is too long for so few blocks";
  const std::string time =
      fmt::format("{}: {}2 tau = {:.3g} +- {:.2g} frames", made.field.name, decision.given ? "" : "none, ",
                  correlation.time, correlation.time * correlation.uncertainty);
  if (decision.unlike)
    return fmt::format(
        "{}, but it differs from series to series by {:.0f} %, more than its uncertainty in each", time,
        100 * correlation.scatter);
  if (!decision.given)
    return fmt::format("{}, {:.3g} effective samples of the {:.3g} that are needed", time, decision.samples,
                       std::ceil(decision.needed));
  return fmt::format(
      "{}, from series to series by {:.0f} %, {:.3g} effective samples, {:.3g} degrees of freedom{}", time,
      100 * correlation.scatter, decision.samples, decision.freedom, of_runs(made));
}

std::string report(const FieldErrors& made) {
  const bool all_curved = !made.decision.given && !made.nonlinear.curved.empty();
  return (all_curved ? made.field.name + ": none" : decided(made)) + withheld(made);
}

Json json_of(const FieldErrors& made) {
  const CorrelationTime& correlation = made.correlation;
  const bool known = !std::isnan(correlation.time);
  const auto if_known = [known](double value) { return known ? value : std::nan(""); };
  Json json = Json::object();
  json["given"] = std::int64_t{made.decision.given};
  json["series"] = static_cast<std::int64_t>(made.series);
  json["two_tau"] = correlation.time;
  json["two_tau_err"] = if_known(correlation.time * correlation.uncertainty);
  json["two_tau_scatter"] = if_known(correlation.scatter);
  json["two_tau_scatter_unknown"] = if_known(correlation.unknown_scatter);
  const auto if_decided = [&](double value) { return known || made.decision.by_runs ? value : std::nan(""); };
  json["effective_samples"] = if_decided(made.decision.samples);
  json["needed_samples"] = if_decided(made.decision.needed);
  json["degrees_of_freedom"] = if_decided(made.decision.freedom);
  json["slow_wave_ratio"] = made.slow.ratio;
  json["by_runs"] = std::int64_t{made.decision.by_runs};
  json["chi2_between_runs"] = made.between.chi_square;
  json["nonlinear_columns"] = Json::array();
  for (const CurvedColumn& curved : made.nonlinear.curved) json["nonlinear_columns"].push_back(curved.name);
  json["undirected"] = static_cast<std::int64_t>(made.nonlinear.undirected);
  json["widening"] = made.decision.given ? made.decision.widening : std::nan("");
  return json;
}

// The reason if no field has errors and all have the same reason; otherwise each field has its own line.
std::string summary_of(const BlockErrors& errors, bool known, const std::string& blocks) {
  if (errors.any()) return "standard errors by the jackknife of " + blocks;
  if (errors.enough_blocks && !known) return "nan: nothing fluctuates in " + blocks;
  const auto is_short = [](const FieldErrors& made) { return made.series > 0 && !made.decision.by_runs; };
  if (!known || std::any_of(errors.fields.begin(), errors.fields.end(), is_short))
    return fmt::format("nan: {} are too few for standard errors", blocks);
  return "nan: no field has standard errors";
}

}  // namespace

std::string doubt_of(const BlockErrors& errors) {
  const bool repeat = std::any_of(errors.fields.begin(), errors.fields.end(),
                                  [](const FieldErrors& made) { return made.between.repeat(); });
  return repeat ? "two runs are closer to each other than independent runs are (one run twice?); errors are "
                  "then too small"
                : "";
}

void describe_errors(const BlockErrors& errors, const TimeAverage& average, Preamble& lines) {
  const std::string blocks =
      fmt::format("{} blocks of {} frames", average.blocks().size(), average.block_length());
  const bool known = std::any_of(errors.fields.begin(), errors.fields.end(),
                                 [](const FieldErrors& made) { return made.series > 0; });
  lines.emplace_back("errors", summary_of(errors, known, blocks));
  if (!known) return;
  for (const FieldErrors& made : errors.fields) lines.emplace_back("errors of", report(made));
  const bool differ = std::any_of(errors.fields.begin(), errors.fields.end(),
                                  [](const FieldErrors& made) { return made.between.differ(); });
  if (differ)
    lines.emplace_back("note",
                       "runs differ by more than their frames explain: their errors are those of packings, "
                       "and more frames of the same runs do not make them smaller");
  if (const std::string doubt = doubt_of(errors); !doubt.empty()) lines.emplace_back("note", doubt);
  if (!errors.all() && average.block_length() > 1)
    lines.emplace_back("note",
                       "shorter blocks may give more errors: --error-blocks, or fewer fields or volumes");
}

Json error_json(const BlockErrors& errors, const TimeAverage& average) {
  Json json = Json::object();
  json["method"] = "jackknife over blocks, 2 tau pooled by field";
  json["frames"] = errors.frames;
  json["blocks"] = static_cast<std::int64_t>(average.blocks().size());
  json["block_length"] = average.block_length();
  Json fields = Json::object();
  for (const FieldErrors& made : errors.fields) fields[made.field.name] = json_of(made);
  json["fields"] = fields;
  return json;
}

}  // namespace mikromakro
