#include <fmt/format.h>

#include <memory>

#include "app/averaging_run.h"
#include "app/commands.h"
#include "app/field_options.h"
#include "app/input_options.h"
#include "app/table_outputs.h"
#include "app/volume_options.h"
#include "averaging/block_errors.h"

namespace mikromakro {
namespace {

struct AverageOptions {
  InputOptions input;
  VolumeOptions volumes;
  FieldChoice fields;
  std::vector<std::string> out;
  std::size_t error_blocks = 64;
  RunOptions run;
};

void add_options(CLI::App& app, AverageOptions& options) {
  add_input_options(app, options.input);
  add_volume_options(app, options.volumes);
  add_weight_option(app, options.volumes);
  add_field_options(app, options.fields);
  app.add_option("--error-blocks", options.error_blocks,
                 "blocks of frames that are kept for standard errors, default 64; 0 for no errors")
      ->check(CLI::Range(0, 100000));
  app.add_option(
         "--out", options.out,
         "FILE.csv, .h5 or .vtkhdf (ParaView), or - for CSV on standard output (default); may be given "
         "more than once")
      ->allow_extra_args(false);
  add_run_options(app, options.run);
}

// The averager, and what it is to read.
struct Task {
  std::unique_ptr<const Averager> averager;
  FrameSource source;
  std::unique_ptr<TableOutputs> outputs;  // on rank 0
};

Task task_of(const AverageOptions& options, const Ranks& ranks) {
  Task task;
  task.averager = make_averager(options.volumes, fields_of(options.fields, options.volumes));
  task.source = source_of(options.input, *task.averager);
  if (ranks.first()) task.outputs = std::make_unique<TableOutputs>(options.out);
  return task;
}

Preamble preamble_of(const AverageOptions& options, const FrameSource& source, const Averaged& averaged) {
  Preamble lines = {{"program", "mikromakro " MIKROMAKRO_VERSION " average"}};
  describe_input(options.input, source, lines);
  describe_fields(options.fields, lines);
  describe_frames(averaged, lines);
  describe_volumes(options.volumes, lines);
  describe_numbers(options.fields, lines);
  return lines;
}

// Adds the errors to the table, and to the lines above it what they rest on.
void add_errors(const Averager& averager, const TimeAverage& sums, Table& table, Preamble& lines) {
  const BlockErrors errors = block_errors(sums, [&](const Rows& mean) { return averager.values(mean); });
  append_errors(errors, averager.columns(), table);
  const std::string blocks = fmt::format("{} blocks of {} frames", sums.blocks().size(), sums.block_length());
  lines.emplace_back("errors",
                     errors.any() ? fmt::format("standard errors from {}, nan where they are too few", blocks)
                                  : fmt::format("nan: {} are too few for standard errors", blocks));
}

void write(const AverageOptions& options, const Task& task, const Averaged& averaged) {
  require_frames(averaged, task.source);
  const Rows mean = averaged.sums.mean();
  Table table = task.averager->solve(mean);
  Preamble lines = preamble_of(options, task.source, averaged);
  for (const std::string& note : task.averager->notes(mean)) lines.emplace_back("note", note);
  if (options.error_blocks > 0) add_errors(*task.averager, averaged.sums, table, lines);
  task.outputs->commit(lines, table, ring_centre(options.volumes));
}

void average(const AverageOptions& options) {
  const Ranks ranks;
  Task task;
  ranks.agree([&] { task = task_of(options, ranks); });
  const SumFrame sum = [&](const Frame& frame) { return task.averager->frame_sums(frame); };
  const Averaged averaged =
      average_frames(task.source, sum, TimeAverage(options.error_blocks), options.run, ranks);
  ranks.agree([&] {
    if (ranks.first()) write(options, task, averaged);
  });
}

}  // namespace

void add_average_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "average", "fields over rings, sectors or rectangles from particle and contact dumps");
  auto options = std::make_shared<AverageOptions>();
  add_options(*app, *options);
  app->callback([options] { average(*options); });
}

}  // namespace mikromakro
