// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "app/commands.h"
#include "app/dump_summary.h"
#include "app/mercury_summary.h"
#include "io/files/file_list.h"
#include "io/files/line_reader.h"
#include "io/snapshot/snapshot_reader.h"
#include "io/tables/csv_reader.h"
#include "io/tables/json.h"
#include "verbs/warnings.h"

namespace mikromakro {
namespace {

struct InfoOptions {
  std::vector<std::string> files, particle_columns;
  bool json = false, each = false;
};

// Files that are parts of one run: as many as there are, with one summary.
template <typename Summary>
struct Group {
  std::string first, last;
  std::size_t files = 1;
  Summary summary;

  std::string name() const {
    return files == 1 ? first : fmt::format("{} ... {} ({} files)", first, last, files);
  }
};

template <typename Summary>
void add(const std::string& file, Summary summary, bool each, std::vector<Group<Summary>>& groups) {
  for (Group<Summary>& group : groups) {
    if (each || !alike(group.summary, summary)) continue;
    add_part(summary, group.summary);
    group.last = file;
    ++group.files;
    return;
  }
  groups.push_back({file, file, 1, std::move(summary)});
}

// Of one file or of several.
struct SnapshotTotals {
  std::size_t frames = 0;
  std::int64_t first_step = 0, last_step = 0, contacts = -1;  // -1: no contacts in the file
  std::uint64_t most_particles = 0;
  ColumnSet particles_given = 0, contacts_given = 0;
};

SnapshotTotals totals_of(const SnapshotSummary& summary) {
  SnapshotTotals totals{summary.steps.size()};
  if (!summary.steps.empty()) {
    totals.first_step = summary.steps.front();
    totals.last_step = summary.steps.back();
  }
  if (!summary.contact_offsets.empty()) totals.contacts = summary.contact_offsets.back();
  totals.most_particles = summary.most_particles;
  totals.particles_given = summary.particles_given;
  totals.contacts_given = summary.contacts_given;
  return totals;
}

bool alike(const SnapshotTotals& one, const SnapshotTotals& other) {
  return one.particles_given == other.particles_given && one.contacts_given == other.contacts_given &&
         (one.contacts < 0) == (other.contacts < 0);
}

void add_part(const SnapshotTotals& part, SnapshotTotals& whole) {
  if (part.frames > 0) {
    whole.first_step = whole.frames > 0 ? std::min(whole.first_step, part.first_step) : part.first_step;
    whole.last_step = whole.frames > 0 ? std::max(whole.last_step, part.last_step) : part.last_step;
  }
  whole.frames += part.frames;
  whole.most_particles = std::max(whole.most_particles, part.most_particles);
  if (whole.contacts >= 0) whole.contacts += part.contacts;
}

struct TableTotals {
  std::vector<std::string> names;
  Eigen::Index fewest = 0, most = 0;
};

bool alike(const TableTotals& one, const TableTotals& other) {
  return one.names == other.names;
}

void add_part(const TableTotals& part, TableTotals& whole) {
  whole.fewest = std::min(whole.fewest, part.fewest);
  whole.most = std::max(whole.most, part.most);
}

std::vector<std::string> names_of(ColumnSet given, const ColumnNames& names) {
  std::vector<std::string> all;
  for (std::size_t slot = 0; slot < names.known.size(); ++slot)
    if ((given >> slot & 1U) != 0) all.emplace_back(names.known[slot]);
  return all;
}

Json table_json(const CsvTable& table) {
  Json json = Json::object();
  json["file"] = table.file();
  json["kind"] = "table";
  json["rows"] = std::int64_t{table.rows()};
  json["columns"] = table.names();
  return json;
}

void print_table(const std::string& name, const TableTotals& table) {
  fmt::print("{}: table\n  rows     {}\n  columns  {}\n", name,
             table.fewest == table.most ? fmt::format("{}", table.most)
                                        : fmt::format("{} to {}", table.fewest, table.most),
             fmt::join(table.names, " "));
}

void print_snapshots(const std::string& name, const SnapshotTotals& totals) {
  fmt::print("{}: snapshots (HDF5)\n", name);
  if (totals.frames > 0)
    fmt::print("  frames   {} (steps {} to {})\n", totals.frames, totals.first_step, totals.last_step);
  fmt::print("  discs    up to {} per frame\n  columns  {}\n", totals.most_particles,
             fmt::join(names_of(totals.particles_given, particle_names()), " "));
  if (totals.contacts < 0) return;
  fmt::print("  contacts {} in all\n  columns  {}\n", totals.contacts,
             fmt::join(names_of(totals.contacts_given, contact_names()), " "));
}

Json snapshots_json(const std::string& file, const SnapshotSummary& summary) {
  Json json = Json::object();
  json["file"] = file;
  json["kind"] = "snapshots";
  json["frames"] = static_cast<std::int64_t>(summary.steps.size());
  if (!summary.steps.empty()) {
    json["first_step"] = summary.steps.front();
    json["last_step"] = summary.steps.back();
  }
  json["most_discs"] = static_cast<std::int64_t>(summary.most_particles);
  json["columns"] = names_of(summary.particles_given, particle_names());
  if (summary.contact_offsets.empty()) return json;
  json["contacts"] = summary.contact_offsets.back();
  json["contact_columns"] = names_of(summary.contacts_given, contact_names());
  return json;
}

// Our tables begin with '#', dumps never do.
bool is_table(const std::string& file) {
  LineReader lines(file);
  std::string_view line;
  return lines.next(line) && line.starts_with('#');
}

// What files contain, in the order in which each kind was met first.
struct Contents {
  std::vector<Group<SnapshotTotals>> snapshots;
  std::vector<Group<TableTotals>> tables;
  std::vector<Group<DumpSummary>> dumps;
  std::vector<std::string> objects;  // of JSON
  bool of_particles = false;

  void print() const {
    for (const auto& group : dumps) print_dump(group.name(), group.summary);
    for (const auto& group : snapshots) print_snapshots(group.name(), group.summary);
    for (const auto& group : tables) print_table(group.name(), group.summary);
  }
};

void read_file(const std::string& file, const InfoOptions& options, Contents& contents, Notes& notes) {
  if (Hdf5File::recognises(file)) {
    const SnapshotSummary summary = summarise_snapshots(Hdf5File::open(file), file);
    if (options.json) contents.objects.push_back(text_of(snapshots_json(file, summary)));
    add(file, totals_of(summary), options.each, contents.snapshots);
  } else if (is_mercury_file(file)) {
    options.json ? contents.objects.push_back(text_of(mercury_json(file, notes)))
                 : print_mercury(file, notes);
  } else if (is_table(file)) {
    const CsvTable table(file);
    if (options.json) contents.objects.push_back(text_of(table_json(table)));
    add(file, TableTotals{table.names(), table.rows(), table.rows()}, options.each, contents.tables);
  } else {
    const DumpSummary summary = summarise_dump(file, options.particle_columns, notes);
    contents.of_particles |= summary.last.of_particles();
    if (options.json) contents.objects.push_back(text_of(dump_json(file, summary)));
    add(file, summary, options.each, contents.dumps);
  }
}

void info(const InfoOptions& options) {
  Contents contents;
  Notes notes;
  for (const std::string& file : expand_files(options.files)) read_file(file, options, contents, notes);
  if (!options.json) contents.print();
  if (!options.particle_columns.empty() && !contents.of_particles)
    throw bad_input({"--particle-columns"}, "none of the files is a text dump of particles",
                    "such a file, or no --particle-columns", "others");
  tell(notes);
  if (options.json) fmt::print("[{}]\n", fmt::join(contents.objects, ",\n "));
}

}  // namespace

void add_info_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("info", "what files contain");
  auto options = std::make_shared<InfoOptions>();
  app->add_option("files", options->files, "dumps, snapshots or tables (names or patterns)")->required();
  app->add_option("--particle-columns", options->particle_columns, "names of all columns, - to skip one")
      ->delimiter(',');
  CLI::Option* json = app->add_flag("--json", options->json, "print JSON: a list with one object per file");
  app->add_flag("--each", options->each, "one by one; else files of one kind, with the same columns, are one")
      ->excludes(json);
  app->callback([options] { info(*options); });
}

}  // namespace mikromakro
