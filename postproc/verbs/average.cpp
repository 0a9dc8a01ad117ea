// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/average.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "averaging/block_table.h"
#include "averaging/window_rows.h"
#include "io/snapshot/wall_series.h"
#include "model/error.h"
#include "options/error_report.h"
#include "options/plausible_options.h"
#include "verbs/memory_need.h"
#include "verbs/run_constants.h"
#include "verbs/steady_part.h"
#include "verbs/warnings.h"
#include "verbs/window_averages.h"

namespace mikromakro {
namespace {

// The averager, and its input.
struct Task {
  AverageOptions options;  // completed with the constants from the files
  std::unique_ptr<const Averager> averager;
  FrameSource source;
  std::string steady;                       // why it begins where it does, if it was cut
  std::unique_ptr<TableOutputs> outputs;    // on rank 0, as are those below; if requested
  std::unique_ptr<WindowAverages> windows;  // in place of it, if requested
  std::unique_ptr<OutputFile> blocks;       // if requested
};

// --json requires that the table goes elsewhere and that there are errors.
void check_json(const AverageOptions& options) {
  const bool table_on_stdout =
      options.out.empty() || std::find(options.out.begin(), options.out.end(), "-") != options.out.end();
  if (table_on_stdout)
    throw bad_input({"--json"}, "the table would go to standard output as well", "--out FILE",
                    options.out.empty() ? "no --out" : "--out -");
  if (options.error_blocks == 0)
    throw bad_input({"--json"}, "no standard errors are computed", "--error-blocks above 0", "0");
}

// Both are of one table.
void check_windows(const AverageCommand& options) {
  check_windows(options.windows);
  if (!options.windows.any()) return;
  for (const auto& [name, given] :
       {std::pair("--json", options.json), std::pair("--blocks", !options.blocks.empty())})
    if (given)
      throw bad_input({name}, "tells of the errors of one table", "no windows beside it",
                      std::string(window_option(options.windows)));
}

// Blocks of frames held at the same time, for all frames and for the present window.
double blocks_held(const AverageCommand& options, const Averager& averager) {
  const auto blocks = static_cast<double>(error_blocks(options.average, averager));
  if (options.windows.any()) {
    const WindowRule rule = rule_of(options.windows);
    const auto frames = static_cast<double>(rule.frames);
    return std::min(blocks, frames) + (rule.moving ? frames : 0);
  }
  // The block table holds the numbers again, both as values and as text.
  return (options.blocks.empty() ? 1 : 5) * blocks;
}

// Created at once, like the outputs of the table.
std::unique_ptr<OutputFile> block_file(const AverageCommand& options,
                                       const std::vector<std::string>& inputs) {
  if (options.blocks.empty()) return nullptr;
  if (!options.blocks.ends_with(".csv"))
    throw bad_input({"--blocks"}, "unknown kind of output file", "a name ending in .csv",
                    in_quotes(options.blocks));
  if (options.average.error_blocks == 0)
    throw bad_input({"--blocks"}, "no blocks of frames are kept", "--error-blocks above 0", "0");
  std::vector<std::string> outputs = options.average.out;
  outputs.push_back(options.blocks);
  check_outputs(outputs, inputs);
  return std::make_unique<OutputFile>(options.blocks);
}

std::vector<std::string> snapshot_files(const FrameSource& source) {
  std::vector<std::string> files;
  for (const Run& run : source.runs())
    files.insert(files.end(), run.snapshot_files.begin(), run.snapshot_files.end());
  return files;
}

bool needs_forces(const Averager& averager) {
  return (averager.contacts_needed() & column_set(ContactColumn::fx)) != 0;
}

// The caller's own columns may have the names of others: of fields, volumes, errors, windows or walls.
void check_columns(const AverageCommand& options, const Task& task) {
  const FrameSource& source = task.source;
  SeriesColumns columns = WindowRows(*task.averager, {options.average.error_blocks != 0,
                                                      !source.further_runs.empty(), source.walls})
                              .columns();
  if (!options.windows.any()) columns.of_window.clear();
  std::set<std::string> names;
  for (const Column& column : columns.all())
    if (!names.insert(column.name).second)
      throw bad_input({"--fields"}, "two columns of one name",
                      "other names for the columns of your own fields", in_quotes(column.name));
}

Task task_of(const AverageCommand& options, const Ranks& ranks) {
  check_windows(options);
  if (options.json) check_json(options.average);
  Task task;
  task.options = options.average;
  VolumeOptions& volumes = task.options.volumes;
  const FrameSource files = frame_source(options.input);
  take_height(files, volumes.height);
  take_stiffness(files, volumes.bulk_types, task.options.fields);
  take_friction(files, task.options.fields);
  note_other_runs(files);
  task.averager = make_averager(task.options);
  check_use(options.average.volumes, *task.averager);
  check_memory({static_cast<double>(task.averager->volume_count() * task.averager->sum_count()),
                threads_of(options.run, ranks), blocks_held(options, *task.averager)},
               volume_option(volumes));
  task.source = source_of(options.input, *task.averager);
  task.source.notes = files.notes;
  if (needs_forces(*task.averager)) note_unrecorded_walls(files);
  if (options.windows.any()) task.source.walls = wall_numbers(snapshot_files(files));
  check_columns(options, task);
  if (!ranks.first()) return task;
  if (options.windows.any()) return task;  // created once the task has its place
  if (!options.returns_table || !task.options.out.empty())
    task.outputs = std::make_unique<TableOutputs>(task.options.out, files.files());
  task.blocks = block_file(options, files.files());
  return task;
}

// Weights by centres may crowd volumes.
void note_crowded(const Task& task, const Averaged& averaged) {
  const Table table = task.averager->solve(averaged.sums.mean());
  const auto nu = std::find_if(table.columns.begin(), table.columns.end(),
                               [](const Column& one) { return one.name == "nu"; });
  if (nu == table.columns.end()) return;
  if (task.options.volumes.weight == "centre") return;
  constexpr double overlaps = 0.05;
  if (2 * (table.rows.col(nu - table.columns.begin()) > 1 + overlaps).count() > table.rows.rows())
    tell(
        "nu is above 1 in most volumes: discs are larger than the volume that they are in (radii in another "
        "unit, or diameters?)");
}

AverageResult result_of(const AverageCommand& options, const Task& task, const Averaged& averaged) {
  Preamble lines = {{"program", "mikromakro " MIKROMAKRO_VERSION " average"}};
  describe_input(options.input, task.source, averaged.runs.size(), lines);
  if (!task.steady.empty()) lines.emplace_back("steady", task.steady);
  if (task.windows) {
    AverageResult result{task.windows->write(averaged, std::move(lines)), {}};
    note_crowded(task, averaged);
    return result;
  }
  if (task.blocks) task.blocks->commit(csv_text(lines, block_table(*task.averager, averaged.sums)));
  AverageResult result;
  result.table = averaged_table(task.options, *task.averager, averaged, std::move(lines));
  if (task.outputs) write_averages(task.options, result.table, *task.outputs);
  note_crowded(task, averaged);
  if (const std::string doubt = doubt_of(result.table.errors); !doubt.empty()) tell(doubt);
  if (task.options.error_blocks != 0) result.error_report = error_json(result.table.errors, averaged.sums);
  return result;
}

AverageResult average_once(const AverageCommand& options, const Ranks& ranks) {
  Task task;
  ranks.agree([&] {
    task = task_of(options, ranks);
    if (options.windows.any() && ranks.first())
      task.windows = std::make_unique<WindowAverages>(task.options, options.windows, *task.averager,
                                                      task.source, options.returns_table);
  });
  if (!options.steady.empty())
    task.steady = cut_to_steady_part(options.steady, *task.averager, options.run, ranks, task.source);
  const bool given = options.average.fields.numbers.normal_stiffness > 0;
  const double stiffness = task.options.fields.stiffness_of_run;
  const bool with_forces = needs_forces(*task.averager);
  const SumFrame sum = [&](const Frame& frame) {
    check_time(frame, task.source.files().front(), options.windows.time_step);
    note_density(frame, task.source.density, options.average.volumes.height, *task.source.notes);
    note_stiffness(frame, stiffness, given, *task.source.notes);
    note_friction(frame, task.options.fields.numbers.friction_coefficient, *task.source.notes);
    if (with_forces) {
      note_branch(frame, task.options.volumes, *task.source.notes);
      note_walls(frame, options.input, *task.source.notes);
    }
    return task.averager->frame_sums(frame);
  };
  TakeSums also;
  if (task.windows) also = [&](const FrameSums& frame) { task.windows->add(frame); };
  const bool keeps_blocks = !options.windows.any();  // of all frames
  const Averaged averaged = average_frames(
      task.source, task.options.volumes, sum,
      keeps_blocks ? no_sums(task.options, *task.averager) : TimeAverage(0), options.run, ranks, also);
  AverageResult result;
  ranks.agree([&] {
    if (ranks.first()) result = result_of(options, task, averaged);
  });
  return result;
}

}  // namespace

void add_average_command_options(CLI::App& app, AverageCommand& options) {
  add_input_options(app, options.input);
  add_average_options(app, options.average);
  add_window_options(app, options.windows);
  app.add_option("--steady", options.steady,
                 "COLUMN: averages only from the frame on from which this column does not drift any more");
  add_run_options(app, options.run);
  app.add_option("--blocks", options.blocks,
                 "FILE.csv: the table without each block of frames, for `fit TABLE.csv --blocks FILE.csv`");
  app.add_flag("--json", options.json,
               "how the standard errors were made, as JSON on standard output; with --out");
}

AverageResult average(AverageCommand& options, const Ranks& ranks) {
  AverageResult result;
  reading_again(options.input, [&] { result = average_once(options, ranks); });
  return result;
}

}  // namespace mikromakro
