#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>

#include "app/commands.h"
#include "app/mercury_summary.h"
#include "io/csv_reader.h"
#include "io/dump_reader.h"
#include "io/error.h"
#include "io/file_list.h"
#include "io/json_object.h"
#include "io/line_reader.h"
#include "io/particle_reader.h"
#include "io/snapshot_reader.h"

namespace mikromakro {
namespace {

struct InfoOptions {
  std::vector<std::string> files, particle_columns;
  bool json = false;
};

// What is told of one text dump; types and radii where it is of particles.
struct DumpSummary {
  bool of_particles = false;
  std::int64_t frames = 0;
  std::int64_t first_step = 0;
  std::int64_t fewest_rows = std::numeric_limits<std::int64_t>::max();
  std::int64_t most_rows = 0;
  DumpHeader last;
  std::map<int, std::int64_t> counts_by_type;  // of the last frame
  double smallest_radius = std::numeric_limits<double>::infinity();
  double largest_radius = 0;
};

void add_particles(const std::vector<Particle>& particles, DumpSummary& summary) {
  summary.counts_by_type.clear();
  for (const Particle& particle : particles) {
    ++summary.counts_by_type[particle.type];
    summary.smallest_radius = std::min(summary.smallest_radius, particle.radius);
    summary.largest_radius = std::max(summary.largest_radius, particle.radius);
  }
}

DumpSummary summarise(const std::string& file, const std::vector<std::string>& particle_columns) {
  DumpReader dump(file);
  ColumnSet given = 0;
  DumpSummary summary;
  while (dump.next_header(summary.last)) {
    const DumpHeader& header = summary.last;
    if (summary.frames++ == 0) summary.first_step = header.step;
    summary.of_particles = header.of_particles();
    summary.fewest_rows = std::min(summary.fewest_rows, header.rows);
    summary.most_rows = std::max(summary.most_rows, header.rows);
    if (summary.of_particles)
      add_particles(read_particles(dump.take_rows(header), particle_columns, 0, given), summary);
  }
  return summary;
}

std::vector<std::string> names_of(ColumnSet given, const ColumnNames& names) {
  std::vector<std::string> all;
  for (std::size_t slot = 0; slot < names.known.size(); ++slot)
    if ((given >> slot & 1U) != 0) all.emplace_back(names.known[slot]);
  return all;
}

std::string periodic_text(const Box& box) {
  return std::string(box.periodic[0] ? "x" : "") + (box.periodic[1] ? "y" : "");
}

JsonObject dump_json(const std::string& file, const DumpSummary& summary) {
  const DumpHeader& last = summary.last;
  JsonObject json;
  json.add("file", file);
  json.add("kind", summary.of_particles ? "particles" : "contacts");
  json.add("frames", summary.frames);
  json.add("first_step", summary.first_step);
  json.add("last_step", last.step);
  json.add("fewest_rows", summary.fewest_rows);
  json.add("most_rows", summary.most_rows);
  json.add("columns", last.columns);
  json.add("box", std::vector<double>{last.box.low[0], last.box.high[0], last.box.low[1], last.box.high[1]});
  json.add("periodic", periodic_text(last.box));
  if (!summary.of_particles || summary.largest_radius == 0) return json;
  JsonObject types;
  for (const auto& [type, count] : summary.counts_by_type) types.add(fmt::format("{}", type), count);
  json.add("types", types);
  json.add("radius", std::vector<double>{summary.smallest_radius, summary.largest_radius});
  return json;
}

void print_dump(const std::string& file, const DumpSummary& summary) {
  const DumpHeader& last = summary.last;
  fmt::print("{}: {} (text dump)\n", file, summary.of_particles ? "particles" : "contacts");
  fmt::print("  frames   {} (steps {} to {})\n", summary.frames, summary.first_step, last.step);
  fmt::print("  rows     {} to {} per frame\n", summary.fewest_rows, summary.most_rows);
  fmt::print("  columns  {}\n", fmt::join(last.columns, " "));
  fmt::print("  box      x {} to {} m, y {} to {} m, periodic: {}\n", last.box.low[0], last.box.high[0],
             last.box.low[1], last.box.high[1],
             periodic_text(last.box).empty() ? "no" : periodic_text(last.box));
  for (const auto& [type, count] : summary.counts_by_type) fmt::print("  type {}   {} discs\n", type, count);
  if (summary.largest_radius > 0)
    fmt::print("  radius   {} to {} m\n", summary.smallest_radius, summary.largest_radius);
}

JsonObject table_json(const CsvTable& table) {
  JsonObject json;
  json.add("file", table.file());
  json.add("kind", "table");
  json.add("rows", std::int64_t{table.rows()});
  json.add("columns", table.names());
  return json;
}

void print_table(const CsvTable& table) {
  fmt::print("{}: table\n  rows     {}\n  columns  {}\n", table.file(), table.rows(),
             fmt::join(table.names(), " "));
}

void print_snapshots(const std::string& file, const SnapshotSummary& summary) {
  fmt::print("{}: snapshots (HDF5)\n", file);
  if (!summary.steps.empty())
    fmt::print("  frames   {} (steps {} to {})\n", summary.steps.size(), summary.steps.front(),
               summary.steps.back());
  fmt::print("  discs    up to {} per frame\n  columns  {}\n", summary.most_particles,
             fmt::join(names_of(summary.particles_given, particle_names()), " "));
  if (summary.contact_offsets.empty()) return;
  fmt::print("  contacts {} in all\n  columns  {}\n", summary.contact_offsets.back(),
             fmt::join(names_of(summary.contacts_given, contact_names()), " "));
}

JsonObject snapshots_json(const std::string& file, const SnapshotSummary& summary) {
  JsonObject json;
  json.add("file", file);
  json.add("kind", "snapshots");
  json.add("frames", static_cast<std::int64_t>(summary.steps.size()));
  if (!summary.steps.empty()) {
    json.add("first_step", summary.steps.front());
    json.add("last_step", summary.steps.back());
  }
  json.add("most_discs", static_cast<std::int64_t>(summary.most_particles));
  json.add("columns", names_of(summary.particles_given, particle_names()));
  if (summary.contact_offsets.empty()) return json;
  json.add("contacts", summary.contact_offsets.back());
  json.add("contact_columns", names_of(summary.contacts_given, contact_names()));
  return json;
}

// Our tables begin with '#', dumps never do.
bool is_table(const std::string& file) {
  LineReader lines(file);
  std::string_view line;
  return lines.next(line) && line.starts_with('#');
}

void info(const InfoOptions& options) {
  std::vector<std::string> objects;
  bool of_particles = false;
  for (const std::string& file : expand_files(options.files)) {
    if (Hdf5File::recognises(file)) {
      const SnapshotSummary summary = summarise_snapshots(Hdf5File::open(file), file);
      options.json ? objects.push_back(snapshots_json(file, summary).text()) : print_snapshots(file, summary);
    } else if (is_mercury_file(file)) {
      options.json ? objects.push_back(mercury_json(file).text()) : print_mercury(file);
    } else if (is_table(file)) {
      const CsvTable table(file);
      options.json ? objects.push_back(table_json(table).text()) : print_table(table);
    } else {
      const DumpSummary summary = summarise(file, options.particle_columns);
      of_particles |= summary.of_particles;
      options.json ? objects.push_back(dump_json(file, summary).text()) : print_dump(file, summary);
    }
  }
  if (!options.particle_columns.empty() && !of_particles)
    throw bad_input({"--particle-columns"}, "none of the files is a text dump of particles",
                    "such a file, or no --particle-columns", "others");
  if (options.json) fmt::print("[{}]\n", fmt::join(objects, ",\n "));
}

}  // namespace

void add_info_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("info", "what a file contains");
  auto options = std::make_shared<InfoOptions>();
  app->add_option("files", options->files, "dumps, snapshots or tables (names or patterns)")->required();
  app->add_option("--particle-columns", options->particle_columns, "names of all columns, - to skip one")
      ->delimiter(',');
  app->add_flag("--json", options->json, "print JSON: a list with one object per file");
  app->callback([options] { info(*options); });
}

}  // namespace mikromakro
