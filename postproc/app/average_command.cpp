#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <memory>

#include "app/commands.h"
#include "app/input_options.h"
#include "app/progress.h"
#include "app/table_outputs.h"
#include "averaging/averager.h"
#include "averaging/ring_volumes.h"
#include "averaging/time_average.h"
#include "io/error.h"
#include "io/file_list.h"
#include "io/frame_stream.h"

namespace mikromakro {
namespace {

struct AverageOptions {
  InputOptions input;
  std::vector<std::string> fields;
  std::vector<double> rings, center = {0, 0}, edges;
  std::string weight = "sliced", branch = "radius";
  std::vector<std::string> out;
  double height = 1;
  double kn = 0;
  std::vector<int> bulk_types;
  bool quiet = false;
};

void add_options(CLI::App& app, AverageOptions& options) {
  add_input_options(app, options.input);
  app.add_option("--rings", options.rings, "RMIN RMAX N: N equal rings (m)")->expected(3);
  app.add_option("--center", options.center, "X Y: centre of the rings (m), default 0 0")->expected(2);
  app.add_option("--edges", options.edges, "R0,R1,...: own radii of the rings (m)")->delimiter(',');
  app.add_option("--weight", options.weight, "sliced (area of the disc in the volume, default) or centre");
  app.add_option("--height", options.height, "thickness of the discs (m), default 1");
  app.add_option("--bulk-types", options.bulk_types, "types that are averaged, default all")->delimiter(',');
  app.add_option("--kn", options.kn, "normal stiffness k_n (N/m), noted in the output")
      ->check(CLI::PositiveNumber);
  app.add_option("--branch", options.branch,
                 "branch vector: radius (a_p n, default) or contact (to the contact point)");
  app.add_option("--fields", options.fields, fmt::format("{}; default all", fmt::join(field_names(), ",")))
      ->delimiter(',');
  app.add_option(
         "--out", options.out,
         "FILE.csv, .h5 or .vtkhdf (ParaView), or - for CSV on standard output (default); may be given more "
         "than once")
      ->allow_extra_args(false);
  app.add_flag("--quiet", options.quiet, "no progress bar");
}

Branch branch_of(const std::string& name) {
  if (name == "radius") return Branch::radius;
  if (name == "contact") return Branch::contact;
  throw bad_input({"--branch"}, "unknown branch vector", "radius or contact", in_quotes(name));
}

std::unique_ptr<const Volumes> volumes_of(const AverageOptions& options) {
  if (options.rings.empty() == options.edges.empty()) {
    throw bad_input({"--rings"}, "the volumes are not clear", "either --rings or --edges",
                    options.rings.empty() ? "none" : "both");
  }
  std::vector<double> edges = options.edges;
  if (edges.empty()) {
    constexpr double most_rings = 1e6;
    const double count = options.rings[2];
    if (count != std::floor(count) || count < 1 || count > most_rings)
      throw bad_input({"--rings"}, "not a number of rings", "a whole number N, 1 to 1000000",
                      fmt::format("{}", count));
    edges = equal_ring_edges(options.rings[0], options.rings[1], static_cast<int>(count));
  }
  const Eigen::Vector2d center{options.center[0], options.center[1]};
  if (!center.allFinite()) throw bad_input({"--center"}, "not a point", "finite numbers", "others");
  return std::make_unique<const RingVolumes>(center, std::move(edges), options.height);
}

FrameSource source_of(const AverageOptions& options, const Averager& averager) {
  if (options.input.contacts.empty() && options.input.snapshots.empty() && averager.needs_contacts()) {
    throw bad_input({"--contacts"}, "the fields need contacts",
                    "files of contacts, or --fields that need none", "none");
  }
  FrameSource source = frame_source(options.input);
  source.particles_needed = averager.particles_needed();
  source.contacts_needed = averager.contacts_needed();
  return source;
}

struct FrameRange {
  std::int64_t first_step = 0;
  std::int64_t last_step = 0;
};

TimeAverage sum_frames(const FrameSource& source, const Averager& averager, bool quiet, FrameRange& range) {
  Progress progress(total_size(source.files()), quiet);
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
    throw bad_input({source.files().front()}, "no frame is selected",
                    "frames that --frames and --steps select", "0");
  return average;
}

Preamble preamble_of(const AverageOptions& options, const FrameSource& source, const FrameRange& range,
                     std::int64_t frames) {
  Preamble lines = {{"program", "mikromakro " MIKROMAKRO_VERSION " average"}};
  for (const std::string& file : source.snapshot_files) lines.emplace_back("snapshots", file);
  for (const std::string& file : source.particle_files) lines.emplace_back("particles", file);
  for (const std::string& file : source.contact_files) lines.emplace_back("contacts", file);
  if (!options.fields.empty())
    lines.emplace_back("fields", fmt::format("{}", fmt::join(options.fields, ",")));
  if (!options.input.particle_columns.empty())
    lines.emplace_back("particle columns", fmt::format("{}", fmt::join(options.input.particle_columns, ",")));
  if (!options.input.contact_columns.empty())
    lines.emplace_back("contact columns", fmt::format("{}", fmt::join(options.input.contact_columns, ",")));
  lines.emplace_back("frames", fmt::format("{}, steps {} to {}", frames, range.first_step, range.last_step));
  if (options.edges.empty()) {
    lines.emplace_back("rings",
                       fmt::format("{} {} {}", options.rings[0], options.rings[1], options.rings[2]));
  } else {
    lines.emplace_back("edges", fmt::format("{}", fmt::join(options.edges, ",")));
  }
  lines.emplace_back("center", fmt::format("{} {}", options.center[0], options.center[1]));
  lines.emplace_back("weight", options.weight);
  lines.emplace_back("branch", options.branch);
  lines.emplace_back("height", fmt::format("{} m", options.height));
  lines.emplace_back("bulk types", options.bulk_types.empty()
                                       ? "all"
                                       : fmt::format("{}", fmt::join(options.bulk_types, ",")));
  if (options.kn > 0) lines.emplace_back("kn", fmt::format("{} N/m", options.kn));
  return lines;
}

void average(const AverageOptions& options) {
  const AveragingOptions averaging{options.bulk_types, branch_of(options.branch)};
  const Averager averager(volumes_of(options), make_weight(options.weight), make_fields(options.fields),
                          averaging);
  const FrameSource source = source_of(options, averager);
  TableOutputs outputs(options.out);
  FrameRange range;
  const TimeAverage sums = sum_frames(source, averager, options.quiet, range);
  const Table table = averager.solve(sums.mean());
  outputs.commit(preamble_of(options, source, range, sums.frames()), table,
                 {options.center[0], options.center[1]});
}

}  // namespace

void add_average_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("average", "fields over rings from particle and contact dumps");
  auto options = std::make_shared<AverageOptions>();
  add_options(*app, *options);
  app->callback([options] { average(*options); });
}

}  // namespace mikromakro
