// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/fit_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace mikromakro {
namespace {

// v0, s or v0/(Omega R_i), with its error, and the fit choices that give its smallest and largest value.
struct Estimate {
  std::string name, key, unit;
  double value = 0, error = 0, half_width = 0;
  std::string least_by = {}, greatest_by = {};
  double least = 0, greatest = 0;

  // Whether the interval of the decay rate 1/s, which is value^-2 times as wide, includes 0: the interval of
  // s is then unbounded above.
  bool no_decay() const { return key == "s" && half_width >= value; }
  double low() const { return no_decay() ? value / (1 + half_width / value) : value - half_width; }
  double high() const { return no_decay() ? std::nan("") : value + half_width; }
};

void take_range(const std::vector<FitChoice>& choices, double FitChoice::*of, double scale,
                Estimate& estimate) {
  estimate.least = estimate.greatest = std::nan("");
  for (const FitChoice& choice : choices) {
    const double value = choice.*of / scale;
    if (std::isnan(value)) continue;
    if (!(value >= estimate.least)) {
      estimate.least = value;
      estimate.least_by = choice.name;
    }
    if (!(value <= estimate.greatest)) {
      estimate.greatest = value;
      estimate.greatest_by = choice.name;
    }
  }
}

std::vector<Estimate> estimates(const FitReport& report) {
  const ExponentialProfile& fitted = report.fitted;
  const FitErrors& errors = report.errors;
  const double scale = report.scale, size = std::abs(scale);
  std::vector<Estimate> all(2);
  all[0] = {"v0", "v0", report.unit, fitted.v0, errors.error[0], errors.half_width[0]};
  all[1] = {"s", "s", "m", fitted.s, errors.error[1], errors.half_width[1]};
  take_range(report.choices, &FitChoice::v0, 1, all[0]);
  take_range(report.choices, &FitChoice::s, 1, all[1]);
  all.push_back({"v0/(Omega R_i)", "v0_scaled", "", fitted.v0 / scale, errors.error[0] / size,
                 errors.half_width[0] / size});
  take_range(report.choices, &FitChoice::v0, scale, all[2]);
  return all;
}

void add_line(const Estimate& one, bool rough, bool chosen, std::string& text) {
  const std::string unit = one.unit.empty() ? "" : " " + one.unit;
  fmt::format_to(std::back_inserter(text), "{} = {:.6g}", one.name, one.value);
  const std::string kind = rough ? "rough; " : "";
  if (one.no_decay())
    fmt::format_to(std::back_inserter(text), "{} ({}95 %: above {:.3g}{}, no decay is seen)", unit, kind,
                   one.low(), unit);
  else if (!std::isnan(one.error))
    fmt::format_to(std::back_inserter(text), " +- {:.2g}{} ({}95 %: {:.6g} to {:.6g})", one.error, unit, kind,
                   one.low(), one.high());
  else
    fmt::format_to(std::back_inserter(text), "{}", unit);
  if (chosen)
    fmt::format_to(std::back_inserter(text), "; by choices {:.4g} to {:.4g}", one.least, one.greatest);
  text += "\n";
}

void add_errors(const FitErrors& errors, std::string& text) {
  fmt::format_to(std::back_inserter(text), "errors: {}", errors.method);
  if (!errors.remark.empty()) fmt::format_to(std::back_inserter(text), ": {}", errors.remark);
  if (!std::isnan(errors.two_tau))
    fmt::format_to(std::back_inserter(text), ", 2 tau = {:.3g} +- {:.2g} frames", errors.two_tau,
                   errors.two_tau_error);
  if (!std::isnan(errors.freedom))
    fmt::format_to(std::back_inserter(text), ", {:.3g} effective samples, {:.3g} degrees of freedom",
                   errors.samples, errors.freedom);
  if (!std::isnan(errors.correlation))
    fmt::format_to(std::back_inserter(text), "; correlation of v0 and s {:.2f}", errors.correlation);
  text += "\n";
}

void add_choices(const FitReport& report, const std::vector<Estimate>& all, std::string& text) {
  const auto made = std::count_if(report.choices.begin(), report.choices.end(),
                                  [](const FitChoice& choice) { return !std::isnan(choice.v0); });
  fmt::format_to(std::back_inserter(text), "choices: {} fits", made);
  for (std::size_t i = 0; i < 2; ++i)
    fmt::format_to(std::back_inserter(text), "; least {} by {}, greatest by {}", all[i].name, all[i].least_by,
                   all[i].greatest_by);
  std::map<std::string, int> missing;
  for (const FitChoice& choice : report.choices)
    if (!choice.missing.empty()) ++missing[choice.missing];
  for (const auto& [why, count] : missing)
    fmt::format_to(std::back_inserter(text), "; {} of {} failed: {}", count, report.choices.size(), why);
  text += "\n";
}

void add(const Estimate& one, Json& json) {
  json[one.key] = one.value;
  json[one.key + "_err"] = one.error;
  json[one.key + "_low"] = one.low();
  json[one.key + "_high"] = one.high();
  json[one.key + "_least"] = one.least;
  json[one.key + "_greatest"] = one.greatest;
}

Json errors_json(const FitErrors& errors) {
  Json json = Json::object();
  json["method"] = errors.method;
  json["remark"] = errors.remark;
  json["covariance"] = errors.correlation * errors.error[0] * errors.error[1];
  json["two_tau"] = errors.two_tau;
  json["two_tau_err"] = errors.two_tau_error;
  json["effective_samples"] = errors.samples;
  json["degrees_of_freedom"] = errors.freedom;
  return json;
}

Json choices_json(const std::vector<FitChoice>& choices) {
  Json json = Json::object();
  for (const FitChoice& choice : choices) {
    Json one = Json::object();
    one["v0"] = choice.v0;
    one["s"] = choice.s;
    json[choice.name] = one;
  }
  return json;
}

Json tail_json(const FitReport& report) {
  Json json = Json::object();
  json["found"] = report.tail->found;
  json["rings"] = static_cast<std::int64_t>(report.tail->rings);
  json["s"] = report.tail->found ? report.tail->s : std::nan("");
  json["evidence"] = report.tail->evidence;
  json["s_of_all_rings"] = report.s_of_all;
  return json;
}

void add_tail(const FitReport& report, std::string& text) {
  const CreepingTail& tail = *report.tail;
  if (!tail.found) {
    fmt::format_to(
        std::back_inserter(text),
        "tail: none, one line through log {} does as well as two (BIC {:.3g} less): all rings are used\n",
        report.column, -tail.evidence);
    return;
  }
  fmt::format_to(std::back_inserter(text), "tail: {} rings from behind r = {:.6g} m on are left out",
                 tail.rings, tail.last_r);
  if (tail.evidence > 0)
    fmt::format_to(std::back_inserter(text),
                   ", where log {} bends (two lines, BIC {:.3g} less than of one; s behind = {:.3g} m)",
                   report.column, tail.evidence, tail.s);
  if (tail.sign_from > 0)
    fmt::format_to(std::back_inserter(text), ", {} of them since one moves the other way", tail.sign_from);
  fmt::format_to(std::back_inserter(text), "; {}\n",
                 std::isnan(report.s_of_all) ? "with them there is no fit"
                                             : fmt::format("with them s = {:.6g} m", report.s_of_all));
}

std::string of_what(const FitReport& report) {
  return fmt::format("{}{}{}", report.way.of == FitOf::v ? "" : "log ", report.column,
                     report.way.by_errors ? ", weights by errors" : "");
}

}  // namespace

Json json_of(const FitReport& report) {
  Json json = Json::object();
  for (const Estimate& one : estimates(report)) add(one, json);
  json["r_i"] = report.r_i;
  json["omega"] = report.omega;
  json["fit_of"] = of_what(report);
  json["rings"] = static_cast<std::int64_t>(report.fitted.used.size());
  json["range"] = std::vector<double>{report.first_r, report.last_r};
  json["residual_rms"] = report.fitted.residual_rms;
  json["residuals_over_errors"] = report.residuals_over_errors;
  if (report.tail) json["tail"] = tail_json(report);
  json["errors"] = errors_json(report.errors);
  json["choices"] = choices_json(report.choices);
  return json;
}

std::string text_of(const FitReport& report) {
  std::string text;
  fmt::format_to(
      std::back_inserter(text),
      "{}(r) = v0 exp(-(r - R_i)/s), R_i = {:.6g} m, least squares of {}, {} rings, r = {:.6g} to {:.6g} m\n",
      report.column, report.r_i, of_what(report), report.fitted.used.size(), report.first_r, report.last_r);
  const std::vector<Estimate> all = estimates(report);
  const bool chosen = report.choices.size() > 1;  // else all choices were fixed by the user
  const bool rough = !std::isnan(report.errors.error[0]) && std::isnan(report.errors.freedom);
  for (const Estimate& one : all)
    if (!std::isnan(one.value)) add_line(one, rough, chosen, text);
  if (report.tail) add_tail(report, text);
  add_errors(report.errors, text);
  if (chosen) add_choices(report, all, text);
  fmt::format_to(std::back_inserter(text), "rms of the residuals = {:.6g} {}", report.fitted.residual_rms,
                 report.unit.empty() ? "(the table does not give the unit)" : report.unit);
  if (!std::isnan(report.residuals_over_errors))
    fmt::format_to(std::back_inserter(text), ", {:.2g} of the rings' errors", report.residuals_over_errors);
  fmt::format_to(std::back_inserter(text), " (it describes the fit, and is not an error of v0 or s)");
  text += "\n";
  return text;
}

}  // namespace mikromakro
