// SPDX-License-Identifier: GPL-2.0-or-later
#include "options/average_options.h"

#include <fmt/format.h>

#include "model/error.h"
#include "options/error_report.h"
#include "options/value_checks.h"

namespace mikromakro {
namespace {

// Appends the errors to the table, and how they were obtained to its header.
BlockErrors add_errors(const Averager& averager, const TimeAverage& sums, Table& table, Preamble& lines) {
  BlockErrors errors = block_errors(
      sums, [&](const Rows& mean) { return averager.values(mean); }, averager.columns_of_fields());
  append_errors(errors, averager.columns(), table);
  describe_errors(errors, sums, lines);
  return errors;
}

}  // namespace

void add_average_options(CLI::App& app, AverageOptions& options) {
  add_volume_options(app, options.volumes);
  add_weight_option(app, options.volumes);
  add_components_option(app, options.volumes);
  add_field_options(app, options.fields);
  app.add_option("--error-blocks", options.error_blocks,
                 "blocks of frames that are kept for standard errors, default 64, or up to 1024 where they "
                 "take less than 4 MB; 0 for no errors")
      ->transform(whole_number(0, 100000));
  app.add_option("--out", options.out,
                 "FILE.csv, .h5, .vtkhdf or .hdf (both ParaView), or - for CSV on standard output (default); "
                 "may be given "
                 "more than once")
      ->allow_extra_args(false);
}

std::unique_ptr<const Averager> make_averager(const AverageOptions& options) {
  return make_averager(options.volumes, fields_of(options.fields, options.volumes), options.given);
}

void check_use(const VolumeOptions& given, const Averager& averager) {
  if (!given.branch.empty() && !averager.uses_branches())
    throw bad_input(
        {"--branch"}, "none of the fields uses it",
        "stress, elastic_strain, couple_stress, curvature or a field derived from them in --fields",
        in_quotes(given.branch));
  if (given.height > 0 && !averager.uses_height())
    throw bad_input({"--height"}, "none of the fields uses it",
                    "stresses or a field derived from them in --fields", fmt::format("{}", given.height));
}

std::size_t error_blocks(const AverageOptions& options, const Averager& averager) {
  return options.error_blocks.value_or(
      suitable_blocks(static_cast<std::size_t>(averager.volume_count() * averager.sum_count())));
}

TimeAverage no_sums(const AverageOptions& options, const Averager& averager) {
  return TimeAverage(error_blocks(options, averager));
}

void Averaged::add(std::int64_t step, const Rows& frame_sums, std::int64_t run) {
  if (sums.frames() == 0) range.first_step = step;
  range.last_step = step;
  runs.insert(run);
  sums.add(frame_sums, run);
}

void describe_frames(const Averaged& averaged, Preamble& lines) {
  lines.emplace_back("frames", fmt::format("{}, steps {} to {}", averaged.sums.frames(),
                                           averaged.range.first_step, averaged.range.last_step));
  if (!averaged.first_frame.empty()) lines.emplace_back("first frame", averaged.first_frame);
}

AveragedTable averaged_table(const AverageOptions& options, const Averager& averager,
                             const Averaged& averaged, Preamble lines) {
  const Rows mean = averaged.sums.mean();
  AveragedTable averages{std::move(lines), averager.solve(mean), {}};
  describe_fields(options.fields, averages.lines);
  describe_frames(averaged, averages.lines);
  describe_volumes(options.volumes, averages.lines, true, averager.uses_height());
  describe_numbers(options.fields, averages.lines);
  for (const std::string& note : averager.notes(mean)) averages.lines.emplace_back("note", note);
  if (options.error_blocks != 0)
    averages.errors = add_errors(averager, averaged.sums, averages.table, averages.lines);
  return averages;
}

void write_averages(const AverageOptions& options, const AveragedTable& averages, TableOutputs& outputs) {
  outputs.commit(averages.lines, averages.table, ring_centre(options.volumes));
}

}  // namespace mikromakro
