#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "app/commands.h"
#include "app/progress.h"
#include "app/volume_options.h"
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

TimeAverage sum_frames(const FrameSource& source, const Averager& averager, bool quiet, FrameRange& range) {
  Progress progress(total_size(source.particle_files) + total_size(source.contact_files), quiet);
  FrameStream stream(source);
  TimeAverage average;
  Frame frame;
  while (stream.next(frame)) {
    if (average.frames() == 0) range.first_step = frame.step;
    range.last_step = frame.step;
    average.add(averager.frame_sums(frame));
    progress.update(stream.bytes_read(), average.frames());
  }
  if (average.frames() == 0)
    throw bad_input({source.particle_files.front()}, "no frame is selected",
                    "frames that --frames and --steps select", "0");
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

void average(const AverageOptions& options) {
  FieldOptions numbers;
  numbers.rings = are_rings(options.volumes);
  const auto averager = make_averager(options.volumes, make_fields(options.fields, numbers));
  const FrameSource source = source_of(options, *averager);
  Outputs outputs(options.out);
  FrameRange range;
  const TimeAverage sums = sum_frames(source, *averager, options.quiet, range);
  const Table table = averager->solve(sums.mean());
  outputs.commit(csv_text(preamble_of(options, source, range, sums.frames()), table));
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
