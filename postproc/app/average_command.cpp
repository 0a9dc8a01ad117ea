#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>

#include "app/commands.h"
#include "app/progress.h"
#include "app/volume_options.h"
#include "averaging/ordered_sums.h"
#include "averaging/ranks.h"
#include "averaging/time_average.h"
#include "io/csv_writer.h"
#include "io/error.h"
#include "io/file_list.h"
#include "io/frame_stream.h"
#include "io/output_file.h"

namespace mikromakro {
namespace {

struct AverageOptions {
  std::vector<std::string> particles, contacts, particle_columns, contact_columns, fields;
  VolumeOptions volumes;
  std::string frames, steps;
  std::vector<std::string> out;
  double kn = 0;
  int threads = 0;  // 0: as many as the machine has
  bool quiet = false;
};

void add_options(CLI::App& app, AverageOptions& options) {
  app.add_option("--particles", options.particles,
                 "text dumps of particles (names or patterns, plain or gzip)")
      ->required();
  app.add_option("--contacts", options.contacts, "text dumps of contacts");
  add_volume_options(app, options.volumes);
  app.add_option("--kn", options.kn, "normal stiffness k_n (N/m), noted in the output")
      ->check(CLI::PositiveNumber);
  app.add_option("--frames", options.frames, "FIRST:LAST[:STEP]: frames by index from 0");
  app.add_option("--steps", options.steps, "A:B: frames by time step");
  app.add_option("--particle-columns", options.particle_columns, "names of all columns, - to skip one")
      ->delimiter(',');
  app.add_option("--contact-columns", options.contact_columns, "names of all columns, - to skip one")
      ->delimiter(',');
  app.add_option("--fields", options.fields,
                 fmt::format("all, or names of {}; default {}", fmt::join(field_names(), ","),
                             fmt::join(default_field_names(), ",")))
      ->delimiter(',');
  app.add_option("--out", options.out,
                 "FILE.csv, or - for standard output (default); may be given more than once")
      ->allow_extra_args(false);
  app.add_option("--threads", options.threads,
                 "threads, default all of the machine; 1 for each rank under mpirun")
      ->check(CLI::Range(1, 1024));
  app.add_flag("--quiet", options.quiet, "no progress bar");
}

// Where the table goes to: every file is made at once, and filled when all frames are read.
class Outputs {
 public:
  explicit Outputs(const std::vector<std::string>& names) : to_stdout_(names.empty()) {
    for (const std::string& name : names) {
      if (name != "-" && !name.ends_with(".csv"))
        throw bad_input({"--out"}, "unknown kind of output file", "a name ending in .csv, or -",
                        in_quotes(name));
    }
    for (const std::string& name : names) {
      if (name == "-") {
        to_stdout_ = true;
      } else {
        files_.push_back(std::make_unique<OutputFile>(name));
      }
    }
  }

  void commit(const std::string& text) {
    for (const auto& file : files_) file->commit(text);
    if (to_stdout_) fmt::print("{}", text);
  }

 private:
  bool to_stdout_;
  std::vector<std::unique_ptr<OutputFile>> files_;
};

FrameSource source_of(const AverageOptions& options, const Averager& averager) {
  if (options.contacts.empty() && averager.needs_contacts()) {
    throw bad_input({"--contacts"}, "the fields need contacts",
                    "files of contacts, or --fields that need none", "none");
  }
  FrameSource source;
  source.particle_files = expand_files(options.particles);
  source.contact_files = expand_files(options.contacts);
  source.particle_columns = options.particle_columns;
  source.contact_columns = options.contact_columns;
  source.particles_needed = averager.particles_needed();
  source.contacts_needed = averager.contacts_needed();
  if (!options.frames.empty()) select_frames(options.frames, source.selection);
  if (!options.steps.empty()) select_steps(options.steps, source.selection);
  return source;
}

struct FrameRange {
  std::int64_t first_step = 0;
  std::int64_t last_step = 0;
};

int threads_of(const AverageOptions& options, const Ranks& ranks) {
  if (options.threads > 0) return options.threads;
  return ranks.size() > 1 ? 1 : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// The averager, and what it is to read.
struct Task {
  std::unique_ptr<const Averager> averager;
  FrameSource source;
  std::int64_t bytes = 0;            // of all its files
  std::unique_ptr<Outputs> outputs;  // on rank 0
};

// The mean of all frames, on rank 0; the others give their part.
TimeAverage sum_frames(const Task& task, const AverageOptions& options, const Ranks& ranks,
                       FrameRange& range) {
  Progress progress(task.bytes, options.quiet || !ranks.first());
  TimeAverage average;
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
    if (average.frames() == 0) range.first_step = frame.step;
    range.last_step = frame.step;
    average.add(frame.sums);
    progress.update(bytes, average.frames());
  });
  return average;
}

Preamble preamble_of(const AverageOptions& options, const FrameSource& source, const FrameRange& range,
                     std::int64_t frames) {
  Preamble lines = {{"program", "mikromakro " MIKROMAKRO_VERSION " average"}};
  for (const std::string& file : source.particle_files) lines.emplace_back("particles", file);
  for (const std::string& file : source.contact_files) lines.emplace_back("contacts", file);
  if (!options.fields.empty())
    lines.emplace_back("fields", fmt::format("{}", fmt::join(options.fields, ",")));
  if (!options.particle_columns.empty())
    lines.emplace_back("particle columns", fmt::format("{}", fmt::join(options.particle_columns, ",")));
  if (!options.contact_columns.empty())
    lines.emplace_back("contact columns", fmt::format("{}", fmt::join(options.contact_columns, ",")));
  lines.emplace_back("frames", fmt::format("{}, steps {} to {}", frames, range.first_step, range.last_step));
  describe_volumes(options.volumes, lines);
  if (options.kn > 0) lines.emplace_back("kn", fmt::format("{} N/m", options.kn));
  return lines;
}

Task task_of(const AverageOptions& options, const Ranks& ranks) {
  FieldOptions numbers;
  numbers.rings = are_rings(options.volumes);
  Task task;
  task.averager = make_averager(options.volumes, make_fields(options.fields, numbers));
  task.source = source_of(options, *task.averager);
  task.bytes = total_size(task.source.particle_files) + total_size(task.source.contact_files);
  if (ranks.first()) task.outputs = std::make_unique<Outputs>(options.out);
  return task;
}

void write(const AverageOptions& options, const Task& task, const TimeAverage& sums,
           const FrameRange& range) {
  if (sums.frames() == 0)
    throw bad_input({task.source.particle_files.front()}, "no frame is selected",
                    "frames that --frames and --steps select", "0");
  const Table table = task.averager->solve(sums.mean());
  task.outputs->commit(csv_text(preamble_of(options, task.source, range, sums.frames()), table));
}

void average(const AverageOptions& options) {
  const Ranks ranks;
  Task task;
  ranks.agree([&] { task = task_of(options, ranks); });
  FrameRange range;
  const TimeAverage sums = sum_frames(task, options, ranks, range);
  ranks.agree([&] {
    if (ranks.first()) write(options, task, sums, range);
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
