// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/report_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "app/command_text.h"
#include "app/report_profiles.h"
#include "io/snapshot/snapshot_parameters.h"
#include "options/error_report.h"

namespace mikromakro {
namespace {

std::string kind_of(const VolumeOptions& options) {
  if (!options.box.empty()) return "box";
  if (!options.grid.empty()) return "grid";
  return options.sectors > 0 ? "sectors" : "rings";
}

Json lines_json(const Preamble& lines) {
  Json list = Json::array();
  for (const auto& [name, text] : lines) list.push_back({name, text});
  return list;
}

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Which frames are read is said by the commands of the page themselves.
bool of_input(const CLI::App& app, std::string_view name) {
  const CLI::Option* option = app.get_option(std::string(name));
  return option->get_group() == "Input" && !is_one_of(name, {"--frames", "--steps"});
}

}  // namespace

std::string title_of(const FrameSource& source) {
  std::vector<std::string> files = source.files();
  std::string title = std::filesystem::path(files.front()).filename();
  if (files.size() > 1) title += fmt::format(" and {} more files", files.size() - 1);
  return title;
}

Json volumes_json(const Averager& averager, const VolumeOptions& options) {
  const Table table = averager.solve(Rows::Zero(averager.volume_count(), averager.sum_count()));
  const auto count = static_cast<Eigen::Index>(table.columns.size() - averager.columns().size());
  Json names = Json::array(), rows = Json::array();
  for (Eigen::Index i = 0; i < count; ++i) {
    const Column& column = table.columns[static_cast<std::size_t>(i)];
    names.push_back({{"name", column.name}, {"unit", column.unit}});
  }
  for (Eigen::Index row = 0; row < table.rows.rows(); ++row) {
    Json numbers = Json::array();
    for (Eigen::Index i = 0; i < count; ++i) numbers.push_back(six_digits(table.rows(row, i)));
    rows.push_back(std::move(numbers));
  }
  return {{"kind", kind_of(options)}, {"columns", names}, {"rows", rows}};
}

Json parameters_json(const AverageOptions& options, const Averager& averager, const Averaged& averaged,
                     const BlockErrors& errors, Preamble lines) {
  describe_fields(options.fields, lines);
  describe_frames(averaged, lines);
  describe_volumes(options.volumes, lines, true, averager.uses_height());
  describe_numbers(options.fields, lines);
  for (const std::string& note : averager.notes(averaged.sums.mean())) lines.emplace_back("note", note);
  describe_errors(errors, averaged.sums, lines);
  return lines_json(lines);
}

Json constants_json(const FrameSource& source) {
  std::set<std::string> seen;
  Preamble lines;
  const auto add = [&](const std::string& name, const std::string& text) {
    if (!text.empty() && seen.insert(name + text).second) lines.emplace_back(name, text);
  };
  for (const Run& run : source.runs()) {
    for (const std::string& file : run.snapshot_files) {
      const RunConstants constants = read_constants(Hdf5File::open(file), file);
      add("law", constants.law);
      if (constants.height > 0) add("height", fmt::format("{} m", constants.height));
      for (const double kn : std::set(constants.normal_stiffness.begin(), constants.normal_stiffness.end()))
        add("kn", fmt::format("{} {}", kn, constants.unit_of_stiffness));
      for (const double mu : std::set(constants.friction.begin(), constants.friction.end()))
        add("mu", fmt::format("{}", mu));
      add("walls without contact rows", constants.unrecorded_walls);
    }
  }
  return lines_json(lines);
}

Json commands_json(const CLI::App& app, const AuditOptions& audit, std::int64_t stride) {
  const auto words = [&](auto&&... names) {
    return given_options(
        app, [&](std::string_view name) { return of_input(app, name) || is_one_of(name, {names...}); });
  };
  const auto averaged = [&](std::string_view name) {
    return of_input(app, name) || app.get_option(std::string(name))->get_group() == "Volumes" ||
           is_one_of(name, {"--weight", "--fields", "--kn", "--mu", "--histogram"});
  };
  const std::string volumes = given_options(app, averaged);
  const std::string audited = given_options(app, [&](std::string_view name) {
    if (name == "--weight") return !audit.volumes.weight.empty();
    if (name == "--branch") return !audit.volumes.branch.empty();
    return name != "--sectors" && name != "--fields" && name != "--mu" && name != "--histogram" &&
           (averaged(name) || is_one_of(name, {"--frames", "--steps", "--wheel-types", "--margin"}));
  });
  const std::string frames = given_options(app, [](std::string_view name) {
    return is_one_of(name, {"--frames", "--steps"});
  });
  return {{"draw", "mikromakro draw" + words("--bulk-types", "--timestep")},
          {"draw_height", given_options(app, [](std::string_view name) { return name == "--height"; })},
          {"average", "mikromakro average" + volumes},
          {"audit", "mikromakro audit" + audited},
          {"frames", frames},
          {"timestep", given_options(app, [](std::string_view name) { return name == "--timestep"; })},
          {"stride", stride},
          {"report", "mikromakro report" + given_options(app, [](std::string_view) { return true; })}};
}

}  // namespace mikromakro
