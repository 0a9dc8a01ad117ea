#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>

#include "app/commands.h"
#include "app/input_options.h"
#include "app/progress.h"
#include "app/table_outputs.h"
#include "app/volume_options.h"
#include "averaging/block_errors.h"
#include "averaging/ordered_sums.h"
#include "averaging/ranks.h"
#include "averaging/time_average.h"
#include "io/error.h"
#include "io/file_list.h"

namespace mikromakro {
namespace {

struct AverageOptions {
  InputOptions input;
  VolumeOptions volumes;
  std::vector<std::string> fields, out;
  FieldOptions numbers;
  std::size_t error_blocks = 64;
  int threads = 0;  // 0: as many as the machine has
  bool quiet = false;
};

void add_options(CLI::App& app, AverageOptions& options) {
  add_input_options(app, options.input);
  add_volume_options(app, options.volumes);
  app.add_option("--kn", options.numbers.normal_stiffness,
                 "normal stiffness k_n (N/m): E and G in units of k_n/h, curvature without springs")
      ->check(CLI::PositiveNumber);
  app.add_option("--mu", options.numbers.friction_coefficient,
                 "coefficient of friction, for sliding_fraction")
      ->check(CLI::PositiveNumber);
  app.add_option("--histogram", options.numbers.histogram_bins,
                 "BINS: adds contact_angle_histogram with so many bins")
      ->check(CLI::Range(1, 3600));
  app.add_option("--fields", options.fields,
                 fmt::format("all, or names of {}; default {}", fmt::join(field_names(), ","),
                             fmt::join(default_field_names(), ",")))
      ->delimiter(',');
  app.add_option("--error-blocks", options.error_blocks,
                 "blocks of frames that are kept for standard errors, default 64; 0 for no errors")
      ->check(CLI::Range(0, 100000));
  app.add_option(
         "--out", options.out,
         "FILE.csv, .h5 or .vtkhdf (ParaView), or - for CSV on standard output (default); may be given "
         "more than once")
      ->allow_extra_args(false);
  app.add_option("--threads", options.threads,
                 "threads, default all of the machine; 1 for each rank under mpirun")
      ->check(CLI::Range(1, 1024));
  app.add_flag("--quiet", options.quiet, "no progress bar");
}

FieldList fields_of(const AverageOptions& options) {
  std::vector<std::string> names = options.fields;
  if (options.numbers.histogram_bins > 0) {
    if (names.empty()) {
      for (const std::string_view name : default_field_names()) names.emplace_back(name);
    }
    names.emplace_back("contact_angle_histogram");
  }
  FieldOptions numbers = options.numbers;
  numbers.rings = are_rings(options.volumes);
  return make_fields(names, numbers);
}

int threads_of(const AverageOptions& options, const Ranks& ranks) {
  if (options.threads > 0) return options.threads;
  return ranks.size() > 1 ? 1 : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// The averager, and what it is to read.
struct Task {
  std::unique_ptr<const Averager> averager;
  FrameSource source;
  std::int64_t bytes = 0;                 // of all its files
  std::unique_ptr<TableOutputs> outputs;  // on rank 0
};

Task task_of(const AverageOptions& options, const Ranks& ranks) {
  Task task;
  task.averager = make_averager(options.volumes, fields_of(options));
  task.source = source_of(options.input, *task.averager);
  task.bytes = total_size(task.source.files());
  if (ranks.first()) task.outputs = std::make_unique<TableOutputs>(options.out);
  return task;
}

struct Averaged {
  TimeAverage sums;
  FrameRange range;
};

// The sums of all frames, on rank 0; the others give their part.
Averaged sum_frames(const Task& task, const AverageOptions& options, const Ranks& ranks) {
  Progress progress(task.bytes, options.quiet || !ranks.first());
  Averaged averaged{TimeAverage(options.error_blocks), {}};
  std::atomic<std::int64_t> bytes = 0;
  const auto read_and_sum = [&](const TakeSums& take) {
    FrameSource own = task.source;
    own.selection = ranks.own_part(own.selection);
    FrameStream stream(own);
    const auto next = [&](Frame& frame) {
      const bool some = stream.next(frame);
      bytes = stream.bytes_read();
      return some;
    };
    sum_in_order(next, *task.averager, threads_of(options, ranks), take);
  };
  ranks.gather_in_order(read_and_sum, [&](const FrameSums& frame) {
    if (averaged.sums.frames() == 0) averaged.range.first_step = frame.step;
    averaged.range.last_step = frame.step;
    averaged.sums.add(frame.sums);
    progress.update(bytes, averaged.sums.frames());
  });
  return averaged;
}

Preamble preamble_of(const AverageOptions& options, const FrameSource& source, const Averaged& averaged) {
  Preamble lines = {{"program", "mikromakro " MIKROMAKRO_VERSION " average"}};
  describe_input(options.input, source, lines);
  if (!options.fields.empty())
    lines.emplace_back("fields", fmt::format("{}", fmt::join(options.fields, ",")));
  lines.emplace_back("frames", fmt::format("{}, steps {} to {}", averaged.sums.frames(),
                                           averaged.range.first_step, averaged.range.last_step));
  describe_volumes(options.volumes, lines);
  if (options.numbers.normal_stiffness > 0)
    lines.emplace_back("kn", fmt::format("{} N/m", options.numbers.normal_stiffness));
  if (options.numbers.friction_coefficient > 0)
    lines.emplace_back("mu", fmt::format("{}", options.numbers.friction_coefficient));
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
  if (averaged.sums.frames() == 0)
    throw bad_input({task.source.files().front()}, "no frame is selected",
                    "frames that --frames and --steps select", "0");
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
  const Averaged averaged = sum_frames(task, options, ranks);
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
