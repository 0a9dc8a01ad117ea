// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <memory>

#include "app/commands.h"
#include "app/fit_series.h"
#include "app/profile_fit.h"
#include "app/warnings.h"
#include "options/value_checks.h"

namespace mikromakro {
namespace {

void fit_files(const FitOptions& options) {
  std::vector<CsvTable> tables;
  for (const std::string& file : options.files) tables.emplace_back(file);
  if (std::any_of(tables.begin(), tables.end(), is_series)) return fit_windows(tables, options);
  for (const CsvTable& table : tables) check_ring_table(table);
  const FitReport report = fit_tables(tables, options);
  for (const std::string& warning : report.warnings) tell(warning);
  options.json ? print_json(report) : print_text(report);
}

}  // namespace

void add_fit_command(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("fit", "exponential velocity profile v0 exp(-(r - R_i)/s), of windows too");
  auto options = std::make_shared<FitOptions>();
  app->add_option(
         "file", options->files,
         "table of `mikromakro average`; further ones, with other rings for example, are alternative choices")
      ->required();
  app->add_option("--column", options->column, "column to fit, default v_phi");
  app->add_option("--blocks", options->blocks,
                  "file written by `average --blocks` with the table: the profile without each block of "
                  "frames, for intervals that account for the correlation of rings");
  CLI::Option* weights =
      app->add_option("--weights", options->weights,
                      "none (default): each ring counts the same; errors: by its standard error COLUMN_err")
          ->check(one_of({"none", "errors"}));
  CLI::Option* log = app->add_flag("--log", options->log, "least squares of log v, not of v");
  CLI::Option* range = app->add_option("--range", options->range, "R1 R2: rings with R1 <= r <= R2 only (m)")
                           ->expected(2)
                           ->allow_extra_args(false);
  app->add_flag(
         "--without-tail", options->without_tail,
         "rings up to where log v bends into a slower decay, the creeping tail; says where, and s with "
         "the tail")
      ->excludes(range);
  app->add_option("--ri", options->ri, "R_i (m), default r_inner of the first ring")->check(positive());
  app->add_option("--omega", options->omega, "rate of rotation of the wheel (rad/s), for v0/(Omega R_i)");
  app->add_flag("--json", options->json, "print JSON");
  app->callback([=] {
    options->said = {range->count() > 0 || options->without_tail, weights->count() + log->count() > 0};
    fit_files(*options);
  });
}

}  // namespace mikromakro
