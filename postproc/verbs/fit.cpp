// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/fit.h"

#include <algorithm>

#include "io/tables/csv_reader.h"
#include "options/value_checks.h"
#include "verbs/fit_series.h"
#include "verbs/warnings.h"

namespace mikromakro {

void add_fit_options(CLI::App& app, FitOptions& options) {
  app.add_option(
         "file", options.files,
         "table of `mikromakro average`; further ones, with other rings for example, are alternative choices")
      ->required();
  app.add_option("--column", options.column, "column to fit, default v_phi");
  app.add_option("--blocks", options.blocks,
                 "file written by `average --blocks` with the table: the profile without each block of "
                 "frames, for intervals that account for the correlation of rings");
  app.add_option("--weights", options.weights,
                 "none (default): each ring counts the same; errors: by its standard error COLUMN_err")
      ->check(one_of({"none", "errors"}));
  app.add_flag("--log", options.log, "least squares of log v, not of v");
  CLI::Option* range = app.add_option("--range", options.range, "R1 R2: rings with R1 <= r <= R2 only (m)")
                           ->expected(2)
                           ->allow_extra_args(false);
  app.add_flag("--without-tail", options.without_tail,
               "rings up to where log v bends into a slower decay, the creeping tail; says where, and s with "
               "the tail")
      ->excludes(range);
  app.add_option("--ri", options.ri, "R_i (m), default r_inner of the first ring")->check(positive());
  app.add_option("--omega", options.omega, "rate of rotation of the wheel (rad/s), for v0/(Omega R_i)");
  app.add_flag("--json", options.json, "print JSON");
}

FitResult fit(const FitOptions& options) {
  std::vector<CsvTable> tables;
  for (const std::string& file : options.files) tables.emplace_back(file);
  if (std::any_of(tables.begin(), tables.end(), is_series)) {
    auto [lines, fits] = fit_windows(tables, options);
    return {csv_text(lines, fits), json_of(fits), lines, fits};
  }
  for (const CsvTable& table : tables) check_ring_table(table);
  const FitReport report = fit_tables(tables, options);
  for (const std::string& warning : report.warnings) tell(warning);
  return {text_of(report), json_of(report), {}, {}};
}

}  // namespace mikromakro
