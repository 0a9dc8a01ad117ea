// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/profile_fit.h"

#include <fmt/format.h>

#include <set>

#include "model/error.h"
#include "model/printed_digits.h"
#include "verbs/warnings.h"

namespace mikromakro {
namespace {

constexpr std::string_view unit_of_velocity = "m/s";

// Checks that the rows are consecutive rings, if the table gives their edges: a repeated row, or one with a
// radius in another ring, would silently get the wrong weight.
void check_rings(const CsvTable& table) {
  if (!table.has("r_inner") || !table.has("r_outer")) return;
  const Eigen::ArrayXd inner = table.column("r_inner"), outer = table.column("r_outer"),
                       r = table.column("r");
  Eigen::Index elsewhere = 0;
  constexpr double arithmetic = 1e-14;
  PrintedDigits digits;
  for (Eigen::Index i = 0; i < table.rows(); ++i) digits.add(r[i]);
  for (Eigen::Index i = 0; i < table.rows(); ++i) {
    if (!(inner[i] <= r[i] && r[i] <= outer[i]))
      throw bad_input(table.row_place(i), "r lies outside of its ring",
                      fmt::format("{} to {}", inner[i], outer[i]), fmt::format("{}", r[i]));
    if (std::abs(r[i] - 0.5 * (inner[i] + outer[i])) > 2 * digits.rounding(outer[i]) + arithmetic * outer[i])
      ++elsewhere;
    if (i == 0) continue;
    const double overlap = outer[i - 1] - inner[i];
    constexpr double rounding = 1e-9;  // for edges written with fewer digits
    if (overlap > rounding * outer[i])
      throw bad_input(table.row_place(i), "rings overlap or occur twice",
                      fmt::format("r_inner of at least {}", outer[i - 1]), fmt::format("{}", inner[i]));
  }
  Notes notes;
  if (elsewhere > 0)
    notes.add(fmt::format("{}: r is not the middle of its ring in {} rows", table.file(), elsewhere));
  tell(notes);
}

// Without edges, a duplicate row is recognised by a radius that occurs twice.
void check_radii_differ(const CsvTable& table) {
  const Eigen::ArrayXd r = table.column("r");
  std::set<double> radii;
  for (Eigen::Index i = 0; i < r.size(); ++i)
    if (!radii.insert(r[i]).second)
      throw bad_input(table.row_place(i), "a radius occurs twice", "each ring once", fmt::format("{}", r[i]));
}

void check_kind(const CsvTable& table) {
  const std::string& file = table.file();
  if (table.has("block") && table.has("frames"))
    throw bad_input({file}, "the table contains blocks", "it as --blocks, along with the table of all frames",
                    "it as a table");
  if (!table.has("r"))
    throw bad_input({file}, "the table has no rings", "a column r, as from average --rings", "none");
  if (table.has("phi_begin"))
    throw bad_input({file}, "the table contains sectors, whose profiles may differ",
                    "rings, as from average --rings without --sectors", "phi_begin");
  if (table.rows() == 0) throw bad_input({file}, "the table is empty", "rows of numbers", "none");
}

RingProfile profile_of(const CsvTable& table, const FitOptions& options) {
  const std::string error = options.column + "_err";
  RingProfile profile{"", table.column("r"), table.column(options.column), {}};
  if (options.files.size() > 1) profile.name = table.file();
  if (options.weights == "errors" || table.has(error)) profile.error = table.column(error);
  for (Eigen::Index i = 0; i < profile.error.size(); ++i)
    if (profile.error[i] < 0)
      throw bad_input(table.row_place(i), fmt::format("{} is negative", error), "a standard error, or nan",
                      fmt::format("{}", profile.error[i]));
  if (options.weights == "errors" && !profile.error.isFinite().any())
    throw bad_input({"--weights"}, fmt::format("{} is nan in all rows of {}", error, table.file()),
                    "errors (more frames, see docs/manual/errors.md), or --weights none", "none");
  return profile;
}

// A further table is another average of the same profile.
void check_comparable(const CsvTable& table, const CsvTable& first, const std::string& column) {
  for (const std::string& name : {std::string("r"), column}) {
    const std::string unit = table.unit(name), right = first.unit(name);
    if (!unit.empty() && !right.empty() && unit != right)
      throw bad_input({table.file()},
                      fmt::format("the unit of {} differs from that in {}", name, first.file()), right, unit);
  }
  const Eigen::ArrayXd r = table.column("r"), there = first.column("r");
  if (r.minCoeff() > there.maxCoeff() || r.maxCoeff() < there.minCoeff())
    throw bad_input({table.file()},
                    fmt::format("the rings do not overlap those of {} (m or mm?)", first.file()),
                    fmt::format("some of r = {:.6g} to {:.6g} m", there.minCoeff(), there.maxCoeff()),
                    fmt::format("{:.6g} to {:.6g}", r.minCoeff(), r.maxCoeff()));
}

// What `average` says of its frames and discs above a table. Names of files may be written in several ways.
std::set<std::string> input_lines(const CsvTable& table) {
  std::set<std::string> lines;
  for (const std::string& line : table.comments())
    for (const std::string_view name :
         {"frames: ", "first frame: ", "center: ", "bulk types: ", "frames of "})
      if (line.starts_with(name)) lines.insert(line);
  return lines;
}

// A further table of other frames is no choice but another profile.
void note_other_input(const CsvTable& table, const CsvTable& first) {
  const std::set<std::string> here = input_lines(table), there = input_lines(first);
  if (here.empty() || there.empty()) return;
  for (const std::string& line : here)
    if (there.count(line) == 0)
      return tell(
          fmt::format("{} is not from the same discs and frames as {} ({}): the spread over choices would be "
                      "that of different profiles",
                      table.file(), first.file(), line));
}

FitWay way_of(const FitOptions& options) {
  FitWay way;
  if (options.log) way.of = FitOf::log_v;
  way.by_errors = options.weights == "errors";
  if (options.range.empty()) return way;
  way.from = options.range[0];
  way.to = options.range[1];
  if (!(way.from < way.to))
    throw bad_input({"--range"}, "the range is empty", "R1 < R2", fmt::format("{} {}", way.from, way.to));
  return way;
}

// Rings begin at the wheel only if there are discs in the first one.
double edge_of_wheel(const CsvTable& table, const std::string& column) {
  const Eigen::ArrayXd values = table.column(column), inner = table.column("r_inner");
  if (std::isfinite(values[0])) return inner[0];
  throw bad_input(table.row_place(0),
                  fmt::format("R_i is unknown, since {} is nan in the first ring", column),
                  "--ri R_I (m), the radius of the wheel, or rings that begin there",
                  fmt::format("r_inner = {} m", inner[0]));
}

// Sets R_i and Omega R_i.
void take_wheel(const FitOptions& options, const CsvTable& table, FitReport& report) {
  report.unit = table.unit(options.column);
  report.omega = options.omega;
  report.r_i = std::isnan(options.ri) ? edge_of_wheel(table, options.column) : options.ri;
  report.scale = report.omega * report.r_i;
  const double last = table.column("r").maxCoeff();
  if (report.r_i > last)
    throw bad_input({"--ri"}, "R_i lies beyond all rings", fmt::format("less than {} m", last),
                    fmt::format("{}", report.r_i));
  if (std::isnan(options.omega)) return;
  if (!report.unit.empty() && report.unit != unit_of_velocity)
    throw bad_input({"--omega"}, fmt::format("{} is not a velocity", options.column),
                    fmt::format("a column in {}", unit_of_velocity), report.unit);
  if (options.omega == 0)
    throw bad_input({"--omega"}, "the wheel does not rotate", "a rate other than 0", "0");
  if (report.r_i == 0)
    throw bad_input({"--omega"}, "a wheel of zero radius has no velocity",
                    "--ri above 0, or rings that begin there", "0");
}

FitSaid said(const FitOptions& options) {
  return {!options.range.empty() || options.without_tail, !options.weights.empty() || options.log};
}

FitErrors errors_of(const FitOptions& options, const CsvTable& table, const RingProfile& profile,
                    const FitReport& report) {
  if (!options.blocks.empty()) {
    const ColumnWithoutBlocks blocks = column_without_blocks(CsvTable(options.blocks), options.column, table);
    return errors_from_blocks(report.fitted, blocks, [&](const Eigen::ArrayXd& values) {
      RingProfile without = profile;
      without.v = values;
      return fit_exponential(without, report.r_i, report.way);
    });
  }
  if (profile.error.size() > 0) return errors_from_rings(report.fitted, profile.error);
  FitErrors none;
  none.remark = fmt::format("neither --blocks nor a column {}_err", options.column);
  return none;
}

// s of the same fit to all rings.
double s_with_tail(const RingProfile& profile, double r_i, FitWay way) {
  way.to = std::numeric_limits<double>::infinity();
  try {
    return fit_exponential(profile, r_i, way).s;
  } catch (const Error&) {
    return std::nan("");
  }
}

void leave_tail_out(const RingProfile& profile, FitReport& report) {
  report.tail = creeping_tail(profile);
  report.s_of_all = s_with_tail(profile, report.r_i, report.way);
  if (report.tail->found) report.way.to = report.tail->last_r;
}

double residuals_over_errors(const RingProfile& profile, const FitReport& report) {
  if (profile.error.size() == 0) return std::nan("");
  const ExponentialProfile& fitted = report.fitted;
  const Eigen::ArrayXd r = profile.r(fitted.used), v = profile.v(fitted.used);
  const Eigen::ArrayXd residual = v - fitted.v0 * (-(r - report.r_i) / fitted.s).exp();
  return std::sqrt((residual / profile.error(fitted.used)).square().mean());
}

// Rings in the range that have a value but no weight.
Eigen::Index left_out(const RingProfile& profile, const FitReport& report) {
  const FitWay& way = report.way;
  return (profile.r >= way.from && profile.r <= way.to && profile.v.isFinite()).count() -
         static_cast<Eigen::Index>(report.fitted.used.size());
}

}  // namespace

void check_ring_table(const CsvTable& table) {
  check_kind(table);
  check_rings(table);
  check_radii_differ(table);
}

FitReport fit_tables(const std::vector<CsvTable>& tables, const FitOptions& options) {
  std::vector<RingProfile> profiles;
  for (const CsvTable& table : tables) {
    check_comparable(table, tables.front(), options.column);
    note_other_input(table, tables.front());
    profiles.push_back(profile_of(table, options));
  }
  const CsvTable& table = tables.front();
  const RingProfile& profile = profiles.front();
  FitReport report;
  report.column = options.column;
  report.way = way_of(options);
  take_wheel(options, table, report);
  if (options.without_tail) leave_tail_out(profile, report);
  report.fitted = fit_exponential(profile, report.r_i, report.way);
  if (report.fitted.v0 * report.scale < 0)
    report.warnings.push_back(
        fmt::format("--omega {}: the wheel rotates against the profile, v0 = {} m/s (clockwise is negative)",
                    options.omega, report.fitted.v0));
  const Eigen::ArrayXd r = profile.r(report.fitted.used);
  report.first_r = r.minCoeff();
  report.last_r = r.maxCoeff();
  if (const auto without = options.weights == "errors" ? left_out(profile, report) : 0; without > 0)
    report.warnings.push_back(
        fmt::format("--weights errors: {} rings have no error above 0 and are left out", without));
  report.errors = errors_of(options, table, profile, report);
  report.residuals_over_errors = residuals_over_errors(profile, report);
  report.choices = fit_choices(profiles, report.r_i, report.way, report.fitted.s, said(options));
  return report;
}

}  // namespace mikromakro
