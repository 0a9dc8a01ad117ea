// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/fit_series.h"

#include <fmt/format.h>

#include <optional>

#include "model/error.h"
#include "verbs/warnings.h"

namespace mikromakro {
namespace {

constexpr std::string_view of_window[] = {"step", "time", "step_first", "step_last", "run"};

// The tables of the windows, one after the other.
std::vector<CsvTable> windows_of(const CsvTable& table) {
  const Eigen::ArrayXd first = table.column("step_first"), last = table.column("step_last"),
                       run = table.has("run") ? table.column("run") : first;
  std::vector<CsvTable> windows;
  Eigen::Index begin = 0;
  for (Eigen::Index row = 1; row <= table.rows(); ++row) {
    if (row < table.rows() && first[row] == first[begin] && last[row] == last[begin] &&
        run[row] == run[begin])
      continue;
    windows.push_back(table.part(begin, row - begin));
    begin = row;
  }
  return windows;
}

// Least and greatest of v0 or s over all choices.
std::pair<double, double> range_of(const FitReport& report, double FitChoice::*of) {
  double least = std::nan(""), greatest = std::nan("");
  for (const FitChoice& choice : report.choices) {
    least = std::fmin(least, choice.*of);
    greatest = std::fmax(greatest, choice.*of);
  }
  return {least, greatest};
}

std::vector<Column> columns_of(const CsvTable& table, const FitOptions& options) {
  std::vector<Column> columns;
  for (const std::string_view name : of_window)
    if (table.has(name)) columns.push_back({std::string(name), table.unit(name), "-", "of the window"});
  const std::string unit = table.unit(options.column);
  const auto add = [&](const std::string& name, const std::string& of_unit, const std::string& text) {
    columns.push_back({name, of_unit, "-", text});
    columns.push_back({name + "_err", of_unit, "-", "rough standard error, from those of the rings"});
    columns.push_back({name + "_least", of_unit, "-", "least by the choices of the fit"});
    columns.push_back({name + "_greatest", of_unit, "-", "greatest by the choices of the fit"});
  };
  add("v0", unit, options.column + " at R_i");
  add("s", "m", "width of the shear zone");
  columns.push_back({"rings", "-", "-", "number of rings fitted"});
  columns.push_back({"residual_rms", unit, "-", "rms of the residuals"});
  if (!std::isnan(options.omega)) columns.push_back({"v0_scaled", "1", "-", "v0/(Omega R_i)"});
  return columns;
}

std::vector<double> row_of(const CsvTable& window, const FitOptions& options,
                           const std::optional<FitReport>& report, std::size_t columns) {
  std::vector<double> row;
  for (const std::string_view name : of_window)
    if (window.has(name)) row.push_back(window.column(name)[0]);
  if (report) {
    const auto add = [&](double value, double error, const std::pair<double, double>& range) {
      row.insert(row.end(), {value, error, range.first, range.second});
    };
    add(report->fitted.v0, report->errors.error[0], range_of(*report, &FitChoice::v0));
    add(report->fitted.s, report->errors.error[1], range_of(*report, &FitChoice::s));
    row.push_back(static_cast<double>(report->fitted.used.size()));
    row.push_back(report->fitted.residual_rms);
    if (!std::isnan(options.omega)) row.push_back(report->fitted.v0 / report->scale);
  }
  row.resize(columns, std::nan(""));
  return row;
}

Preamble header_of(const CsvTable& table, const FitOptions& options) {
  return {{"program", "mikromakro " MIKROMAKRO_VERSION " fit"},
          {"table", table.file()},
          {"fit", options.column + "(r) = v0 exp(-(r - R_i)/s) of each window"}};
}

}  // namespace

bool is_series(const CsvTable& table) {
  return table.has("step_first") && table.has("step_last");
}

std::pair<Preamble, Table> fit_windows(const std::vector<CsvTable>& tables, const FitOptions& options) {
  const CsvTable& table = *std::find_if(tables.begin(), tables.end(), is_series);
  if (tables.size() > 1)
    throw bad_input({table.file()}, "a table of windows is fitted alone", "one table", "further ones");
  if (!options.blocks.empty())
    throw bad_input({"--blocks"}, "blocks are those of one table", "no table of windows", table.file());
  const std::vector<CsvTable> windows = windows_of(table);
  if (windows.empty()) throw bad_input({table.file()}, "the table is empty", "rows of numbers", "none");
  check_ring_table(windows.front());
  Table fits{columns_of(table, options), {}};
  fits.rows.resize(std::ssize(windows), std::ssize(fits.columns));
  std::vector<Error> failed;
  std::vector<std::string> warnings;  // of the first window that has some
  for (std::size_t i = 0; i < windows.size(); ++i) {
    std::optional<FitReport> report;
    try {
      report = fit_tables({windows[i]}, options);
      if (warnings.empty()) warnings = report->warnings;
    } catch (const Error& error) {
      if (error.kind() != Error::Kind::run_failed) throw;
      failed.push_back(error);
    }
    const std::vector<double> row = row_of(windows[i], options, report, fits.columns.size());
    fits.rows.row(static_cast<Eigen::Index>(i)) =
        Eigen::Map<const Eigen::ArrayXd>(row.data(), std::ssize(row)).transpose();
  }
  if (failed.size() == windows.size()) throw Error(failed.front());
  if (!failed.empty())
    tell(fmt::format("{} of {} windows have no fit, the first of them: {}", failed.size(), windows.size(),
                     failed.front().what()));
  for (const std::string& warning : warnings) tell(warning);
  return {header_of(table, options), std::move(fits)};
}

}  // namespace mikromakro
