#include "app/input_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/error.h"
#include "io/file_list.h"

namespace mikromakro {

void add_input_options(CLI::App& app, InputOptions& options) {
  app.add_option("input", options.snapshots, "HDF5 snapshots (names or patterns), instead of text dumps");
  app.add_option("--particles", options.particles,
                 "text dumps of particles (names or patterns; plain or compressed by gzip or zstd)");
  app.add_option("--contacts", options.contacts, "text dumps of contacts");
  app.add_option("--frames", options.frames, "FIRST:LAST[:STEP]: frames by index from 0");
  app.add_option("--steps", options.steps, "A:B: frames by time step");
  app.add_option("--particle-columns", options.particle_columns, "names of all columns, - to skip one")
      ->delimiter(',');
  app.add_option("--contact-columns", options.contact_columns, "names of all columns, - to skip one")
      ->delimiter(',');
}

FrameSource frame_source(const InputOptions& options) {
  if (options.snapshots.empty() == options.particles.empty())
    throw bad_input({"--particles"}, "the input is not clear", "either HDF5 snapshots or --particles",
                    options.particles.empty() ? "none" : "both");
  if (!options.snapshots.empty() && !options.contacts.empty())
    throw bad_input({"--contacts"}, "HDF5 snapshots hold their contacts",
                    "--contacts beside --particles only", "both");
  FrameSource source;
  source.snapshot_files = expand_files(options.snapshots);
  source.particle_files = expand_files(options.particles);
  source.contact_files = expand_files(options.contacts);
  source.particle_columns = options.particle_columns;
  source.contact_columns = options.contact_columns;
  if (!options.frames.empty()) select_frames(options.frames, source.selection);
  if (!options.steps.empty()) select_steps(options.steps, source.selection);
  return source;
}

void require_contacts(const InputOptions& options, std::string_view what) {
  if (!options.contacts.empty() || !options.snapshots.empty()) return;
  throw bad_input({"--contacts"}, fmt::format("{} contacts", what), "files of contacts", "none");
}

FrameSource source_of(const InputOptions& options, const Averager& averager) {
  if (options.contacts.empty() && options.snapshots.empty() && averager.needs_contacts()) {
    throw bad_input({"--contacts"}, "the fields need contacts",
                    "files of contacts, or --fields that need none", "none");
  }
  FrameSource source = frame_source(options);
  source.particles_needed = averager.particles_needed();
  source.contacts_needed = averager.contacts_needed();
  return source;
}

void describe_input(const InputOptions& options, const FrameSource& source, Preamble& lines) {
  for (const std::string& file : source.snapshot_files) lines.emplace_back("snapshots", file);
  for (const std::string& file : source.particle_files) lines.emplace_back("particles", file);
  for (const std::string& file : source.contact_files) lines.emplace_back("contacts", file);
  if (!options.particle_columns.empty())
    lines.emplace_back("particle columns", fmt::format("{}", fmt::join(options.particle_columns, ",")));
  if (!options.contact_columns.empty())
    lines.emplace_back("contact columns", fmt::format("{}", fmt::join(options.contact_columns, ",")));
}

}  // namespace mikromakro
