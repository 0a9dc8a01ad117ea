// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/input_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "io/files/file_list.h"
#include "io/hdf5/hdf5_file.h"
#include "io/snapshot/snapshot_summary.h"
#include "model/error.h"
#include "options/value_checks.h"
#include "verbs/warnings.h"

namespace mikromakro {

void add_input_options(CLI::App& app, InputOptions& options) {
  app.option_defaults()->group("Input");
  app.add_option("input", options.snapshots, "HDF5 snapshots (names or patterns), instead of text dumps");
  app.add_option("--snapshots", options.snapshot_runs,
                 "the same as an option; repeated for each further run");
  app.add_option("--particles", options.particles,
                 "text dumps of particles, or .data of MercuryDPM (names or patterns; plain or compressed by "
                 "gzip or zstd); repeated for each further run");
  app.add_option("--contacts", options.contacts,
                 "text dumps of contacts, or .fstat; as often as --particles");
  app.add_option("--wall-contacts", options.walls,
                 "text dumps of contacts with walls, from LIGGGHTS's compute wall/gran/local for example; as "
                 "often as --particles");
  app.add_option("--density", options.density, "areal density rho h (kg/m^2) for files that give no masses")
      ->check(positive());
  app.add_option(
      "--frames", options.frames,
      "FIRST:LAST[:STEP] or one: frames by index from 0, negative from the end (-1: the last one)");
  app.add_option("--steps", options.steps, "A:B or one: frames by time step");
  app.add_option("--particle-columns", options.particle_columns, "names of all columns, - to skip one")
      ->delimiter(',');
  app.add_option(
         "--contact-columns", options.contact_columns,
         "names of all columns, - to skip one; or liggghts (compute pair/gran/local), lammps (compute "
         "property/local patom1 patom2 and pair/local dist fx fy, or dist force fx fy fz p1 ...)")
      ->delimiter(',');
  app.add_option("--wall-contact-columns", options.wall_columns,
                 "the same for --wall-contacts; default liggghts (compute wall/gran/local)")
      ->delimiter(',');
  app.add_flag("--distant-contacts", options.distant_contacts,
               "discs that do not touch may exert forces (cohesion, liquid bridges); otherwise an error");
  app.option_defaults()->group("Options");
}

namespace {

// Pieces of a run by their first steps.
std::vector<std::string> in_order(std::vector<std::string> files) {
  if (files.size() < 2) return files;
  std::vector<std::pair<std::int64_t, std::string>> by_step;
  for (std::string& file : files) {
    const std::vector<std::int64_t> steps = summarise_snapshots(Hdf5File::open(file), file).steps;
    by_step.emplace_back(steps.empty() ? 0 : steps.front(), std::move(file));
  }
  std::stable_sort(by_step.begin(), by_step.end(),
                   [](const auto& one, const auto& other) { return one.first < other.first; });
  std::transform(by_step.begin(), by_step.end(), files.begin(),
                 [](auto& piece) { return std::move(piece.second); });
  return files;
}

std::vector<Run> snapshot_runs(const InputOptions& options) {
  std::vector<Run> runs;
  if (!options.snapshots.empty()) runs.push_back({{}, {}, in_order(expand_files(options.snapshots))});
  for (const auto& files : options.snapshot_runs) runs.push_back({{}, {}, in_order(expand_files(files))});
  return runs;
}

void check_as_often(std::string_view option, std::size_t times, std::size_t runs) {
  if (times != 0 && times != runs)
    throw bad_input({option}, "runs do not match", fmt::format("{} times", runs), fmt::format("{}", times));
}

std::vector<Run> dump_runs(const InputOptions& options) {
  check_as_often("--contacts", options.contacts.size(), options.particles.size());
  check_as_often("--wall-contacts", options.walls.size(), options.particles.size());
  std::vector<Run> runs;
  for (std::size_t i = 0; i < options.particles.size(); ++i) {
    runs.push_back({expand_files(options.particles[i]), {}, {}});
    if (!options.contacts.empty()) runs.back().contact_files = expand_files(options.contacts[i]);
    if (!options.walls.empty()) runs.back().wall_files = expand_files(options.walls[i]);
  }
  return runs;
}

bool has_snapshots(const InputOptions& options) {
  return !options.snapshots.empty() || !options.snapshot_runs.empty();
}

// Rejects column lists that apply to no file.
void check_columns(const InputOptions& options) {
  if (!options.particle_columns.empty() && has_snapshots(options))
    throw bad_input({"--particle-columns"}, "HDF5 snapshots name their columns", "--particles", "snapshots");
  if (!options.contact_columns.empty() && options.contacts.empty())
    throw bad_input({"--contact-columns"}, "there is no dump of contacts", "--contacts",
                    has_snapshots(options) ? "snapshots" : "none");
}

}  // namespace

FrameSource frame_source(const InputOptions& options) {
  if (has_snapshots(options) != options.particles.empty())
    throw bad_input({"--particles"}, "the input is ambiguous", "either HDF5 snapshots or --particles",
                    options.particles.empty() ? "none" : "both");
  if (has_snapshots(options) && options.any_contacts())
    throw bad_input({options.contacts.empty() ? "--wall-contacts" : "--contacts"},
                    "HDF5 snapshots contain their contacts", "--contacts with --particles only", "both");
  if (options.walls.empty() && !options.wall_columns.empty())
    throw bad_input({"--wall-contact-columns"}, "columns without a file", "--wall-contacts as well", "none");
  if (options.distant_contacts && !has_snapshots(options) && !options.any_contacts())
    throw bad_input({"--distant-contacts"}, "there is no dump of contacts", "--contacts", "none");
  check_columns(options);
  FrameSource source;
  std::vector<Run> runs = has_snapshots(options) ? snapshot_runs(options) : dump_runs(options);
  std::vector<std::vector<std::string>> files;
  files.reserve(runs.size());
  for (const Run& run : runs)
    files.push_back(has_snapshots(options) ? run.snapshot_files : run.particle_files);
  check_runs_differ(files);
  source.particle_files = std::move(runs.front().particle_files);
  source.contact_files = std::move(runs.front().contact_files);
  source.snapshot_files = std::move(runs.front().snapshot_files);
  source.wall_files = std::move(runs.front().wall_files);
  source.further_runs.assign(std::next(runs.begin()), runs.end());
  source.density = options.density;
  source.look_through = options.look_through;
  source.particle_columns = options.particle_columns;
  source.contact_columns = options.contact_columns;
  source.wall_columns = options.wall_columns;
  source.distant_contacts = options.distant_contacts;
  if (!options.frames.empty()) select_frames(options.frames, source.selection);
  if (!options.steps.empty()) select_steps(options.steps, source.selection);
  return source;
}

void require_contacts(const InputOptions& options, std::string_view what) {
  if (options.any_contacts() || has_snapshots(options)) return;
  throw bad_input({"--contacts"}, fmt::format("{} contacts", what), "files of contacts", "none");
}

FrameSource source_of(const InputOptions& options, const Averager& averager) {
  if (!options.any_contacts() && !has_snapshots(options) && averager.needs_contacts()) {
    throw bad_input(
        {"--contacts"}, "the fields need contacts",
        fmt::format("files of contacts, or --fields of {}", fmt::join(field_names_without_contacts(), ",")),
        "none");
  }
  FrameSource source = frame_source(options);
  source.particles_needed = averager.particles_needed();
  source.contacts_needed = averager.contacts_needed();
  source.contacts_required = averager.needs_contacts();
  source.averaged_types = averager.bulk_types();
  return source;
}

void reading_again(InputOptions& options, const std::function<void()>& read) {
  try {
    return read();
  } catch (const Error& error) {
    if (error.kind() != Error::Kind::steps_come_again || options.look_through) throw;
  }
  options.look_through = true;
  read();
}

void describe_input(const InputOptions& options, const FrameSource& source, std::size_t used_runs,
                    Preamble& lines) {
  const std::vector<Run> runs = source.runs();
  const std::string of_these = used_runs < runs.size() ? fmt::format(", frames of {}", used_runs) : "";
  if (runs.size() > 1)
    lines.emplace_back("runs", fmt::format("{}, one after the other{}", runs.size(), of_these));
  for (const Run& run : runs) {
    for (const std::string& file : run.snapshot_files) lines.emplace_back("snapshots", file);
    for (const std::string& file : run.particle_files) lines.emplace_back("particles", file);
    for (const std::string& file : run.contact_files) lines.emplace_back("contacts", file);
    for (const std::string& file : run.wall_files) lines.emplace_back("wall contacts", file);
  }
  if (source.density > 0) lines.emplace_back("density", fmt::format("{} kg/m^2", source.density));
  if (!options.particle_columns.empty())
    lines.emplace_back("particle columns", fmt::format("{}", fmt::join(options.particle_columns, ",")));
  if (!options.contact_columns.empty())
    lines.emplace_back("contact columns", fmt::format("{}", fmt::join(options.contact_columns, ",")));
  if (!options.wall_columns.empty())
    lines.emplace_back("wall contact columns", fmt::format("{}", fmt::join(options.wall_columns, ",")));
  if (options.distant_contacts) lines.emplace_back("distant contacts", "allowed");
  describe_notes(*source.notes, lines);
}

bool lack_walls(const Frame& frame, const InputOptions& input) {
  const bool preset = input.contact_columns.size() == 1;
  const bool closed = frame.box.boundaries_known && frame.box.periodic[0] && frame.box.periodic[1];
  return preset && input.walls.empty() && !closed;
}

void note_walls(const Frame& frame, const InputOptions& input, Notes& notes) {
  constexpr std::size_t enough = 5;
  if (lack_walls(frame, input) && frame.box.boundaries_known && frame.contacts.size() >= enough)
    notes.add(
        fmt::format("--contact-columns {}: these rows lack contacts with walls that are not discs, and "
                    "stresses near such walls lack them (--wall-contacts adds those of meshes)",
                    input.contact_columns.front()));
}

}  // namespace mikromakro
