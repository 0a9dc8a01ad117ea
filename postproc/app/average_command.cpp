// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/averaging_run.h"
#include "app/commands.h"
#include "app/input_options.h"
#include "app/memory_need.h"
#include "app/run_constants.h"
#include "app/steady_part.h"
#include "app/warnings.h"
#include "app/window_averages.h"
#include "averaging/block_table.h"
#include "io/snapshot/wall_series.h"
#include "model/error.h"
#include "options/average_options.h"
#include "options/error_report.h"
#include "options/plausible_options.h"

namespace mikromakro {
namespace {

struct CommandOptions {
  InputOptions input;
  AverageOptions average;
  RunOptions run;
  WindowOptions windows;
  std::string steady;  // column that must not drift
  std::string blocks;  // output file for the table with each block of frames left out
  bool json = false;
};

void add_options(CLI::App& app, CommandOptions& options) {
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

// The averager, and its input.
struct Task {
  AverageOptions options;  // completed with the constants from the files
  std::unique_ptr<const Averager> averager;
  FrameSource source;
  std::string steady;                       // why it begins where it does, if it was cut
  std::unique_ptr<TableOutputs> outputs;    // on rank 0, as are those below
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
void check_windows(const CommandOptions& options) {
  check_windows(options.windows);
  if (!options.windows.any()) return;
  for (const auto& [name, given] :
       {std::pair("--json", options.json), std::pair("--blocks", !options.blocks.empty())})
    if (given)
      throw bad_input({name}, "tells of the errors of one table", "no windows beside it",
                      std::string(window_option(options.windows)));
}

// Blocks of frames held at the same time, for all frames and for the present window.
double blocks_held(const CommandOptions& options, const Averager& averager) {
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
std::unique_ptr<OutputFile> block_file(const CommandOptions& options,
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

Task task_of(const CommandOptions& options, const Ranks& ranks) {
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
  if (!ranks.first()) return task;
  if (options.windows.any()) return task;  // created once the task has its place
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

void write(const CommandOptions& options, const Task& task, const Averaged& averaged) {
  Preamble lines = {{"program", "mikromakro " MIKROMAKRO_VERSION " average"}};
  describe_input(options.input, task.source, averaged.runs.size(), lines);
  if (!task.steady.empty()) lines.emplace_back("steady", task.steady);
  if (task.windows) {
    task.windows->write(averaged, std::move(lines));
    return note_crowded(task, averaged);
  }
  if (task.blocks) task.blocks->commit(csv_text(lines, block_table(*task.averager, averaged.sums)));
  const BlockErrors errors =
      write_averages(task.options, *task.averager, averaged, std::move(lines), *task.outputs);
  note_crowded(task, averaged);
  if (const std::string doubt = doubt_of(errors); !doubt.empty()) tell(doubt);
  if (options.json) fmt::print("{}\n", text_of(error_json(errors, averaged.sums)));
}

void average(const CommandOptions& options, const Ranks& ranks) {
  Task task;
  ranks.agree([&] {
    task = task_of(options, ranks);
    if (options.windows.any() && ranks.first())
      task.windows =
          std::make_unique<WindowAverages>(task.options, options.windows, *task.averager, task.source);
  });
  if (!options.steady.empty())
    task.steady = cut_to_steady_part(options.steady, *task.averager, options.run, ranks, task.source);
  const double stiffness = options.average.fields.numbers.normal_stiffness;  // as given
  const bool with_forces = needs_forces(*task.averager);
  const SumFrame sum = [&](const Frame& frame) {
    check_time(frame, task.source.files().front(), options.windows.time_step);
    note_density(frame, task.source.density, options.average.volumes.height, *task.source.notes);
    note_stiffness(frame, stiffness, *task.source.notes);
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
  ranks.agree([&] {
    if (ranks.first()) write(options, task, averaged);
  });
}

}  // namespace

void add_average_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "average", "fields over rings, sectors or rectangles from particle and contact dumps");
  auto options = std::make_shared<CommandOptions>();
  add_options(*app, *options);
  app->callback([options] {
    const Ranks ranks;
    reading_again(options->input, [&] { average(*options, ranks); });
  });
}

}  // namespace mikromakro
