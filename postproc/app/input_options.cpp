#include "app/input_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/error.h"
#include "io/file_list.h"

namespace mikromakro {

void add_input_options(CLI::App& app, InputOptions& options) {
  app.add_option("--particles", options.particles,
                 "text dumps of particles (names or patterns, plain or gzip)")
      ->required();
  app.add_option("--contacts", options.contacts, "text dumps of contacts");
  app.add_option("--frames", options.frames, "FIRST:LAST[:STEP]: frames by index from 0");
  app.add_option("--steps", options.steps, "A:B: frames by time step");
  app.add_option("--particle-columns", options.particle_columns, "names of all columns, - to skip one")
      ->delimiter(',');
  app.add_option("--contact-columns", options.contact_columns, "names of all columns, - to skip one")
      ->delimiter(',');
}

FrameSource source_of(const InputOptions& options, const Averager& averager) {
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

void describe_input(const InputOptions& options, const FrameSource& source, Preamble& lines) {
  for (const std::string& file : source.particle_files) lines.emplace_back("particles", file);
  for (const std::string& file : source.contact_files) lines.emplace_back("contacts", file);
  if (!options.particle_columns.empty())
    lines.emplace_back("particle columns", fmt::format("{}", fmt::join(options.particle_columns, ",")));
  if (!options.contact_columns.empty())
    lines.emplace_back("contact columns", fmt::format("{}", fmt::join(options.contact_columns, ",")));
}

}  // namespace mikromakro
