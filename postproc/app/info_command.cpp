// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

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
  bool json = false;
};

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

void info(const InfoOptions& options) {
  std::vector<std::string> objects;
  Notes notes;
  bool of_particles = false;
  for (const std::string& file : expand_files(options.files)) {
    if (Hdf5File::recognises(file)) {
      const SnapshotSummary summary = summarise_snapshots(Hdf5File::open(file), file);
      options.json ? objects.push_back(text_of(snapshots_json(file, summary)))
                   : print_snapshots(file, summary);
    } else if (is_mercury_file(file)) {
      options.json ? objects.push_back(text_of(mercury_json(file, notes))) : print_mercury(file, notes);
    } else if (is_table(file)) {
      const CsvTable table(file);
      options.json ? objects.push_back(text_of(table_json(table))) : print_table(table);
    } else {
      const DumpSummary summary = summarise_dump(file, options.particle_columns, notes);
      of_particles |= summary.last.of_particles();
      options.json ? objects.push_back(text_of(dump_json(file, summary))) : print_dump(file, summary);
    }
  }
  if (!options.particle_columns.empty() && !of_particles)
    throw bad_input({"--particle-columns"}, "none of the files is a text dump of particles",
                    "such a file, or no --particle-columns", "others");
  tell(notes);
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
