// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <memory>

#include "app/commands.h"
#include "io/files/file_list.h"
#include "io/files/output_file.h"
#include "io/snapshot/snapshot_layout.h"
#include "io/snapshot/snapshot_writer.h"
#include "model/error.h"
#include "options/plausible_options.h"
#include "options/value_checks.h"
#include "verbs/input_options.h"
#include "verbs/progress.h"
#include "verbs/run_constants.h"
#include "verbs/warnings.h"

namespace mikromakro {
namespace {

constexpr const char* walls = "/walls";  // exists in files of runs only; frames do not carry it

struct ConvertOptions {
  InputOptions input;
  std::string out;
  double time_step = 0;
  bool quiet = false;
};

void convert(const ConvertOptions& options) {
  if (!options.out.ends_with(".h5"))
    throw bad_input({"--out"}, "unknown kind of output file", "a name ending in .h5", in_quotes(options.out));
  FrameSource source = frame_source(options.input);
  if (!source.further_runs.empty())
    throw bad_input({"--out"}, "a file holds one run", "the files of one run",
                    fmt::format("{} runs", source.runs().size()));
  source.particles_needed = column_set(ParticleColumn::id);
  check_outputs({options.out}, source.files());
  OutputFile file(options.out);
  file.require_regular();
  Progress progress(total_size(source.files()), options.quiet);
  SnapshotWriter writer(file.temporary(), "mikromakro " MIKROMAKRO_VERSION, options.time_step);
  // Constants are stored once for all frames.
  double height = 0;
  take_height(source, height);
  if (!source.snapshot_files.empty()) {
    const Hdf5File first = Hdf5File::open(source.snapshot_files.front());
    writer.copy_parameters(first);
    if (first.has(walls))
      source.notes->add(
          fmt::format("{}: the numbers of walls ({}) are not copied", source.snapshot_files.front(), walls));
  }
  FrameStream stream(source);
  Frame frame;
  std::int64_t frames = 0;
  double last_time = not_given;
  while (stream.next(frame)) {
    if (frames == 0 && lack_walls(frame, options.input))
      writer.add_parameters({{{snapshot::unrecorded_walls, {"walls that are not discs"}}}, {}});
    note_walls(frame, options.input, *source.notes);
    note_time(frame, last_time, *source.notes);
    check_time(frame, stream.raw().particle_file, options.time_step);
    writer.add(stream.raw(), frame.particles);
    progress.update(stream.bytes_read(), ++frames);
  }
  tell(*source.notes);
  if (frames == 0) throw source.no_frame_selected();
  writer.close();
  file.publish();
}

}  // namespace

void add_convert_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("convert", "text dumps to HDF5 snapshots");
  auto options = std::make_shared<ConvertOptions>();
  add_input_options(*app, options->input);
  app->add_option("--out", options->out, "FILE.h5")->required();
  app->add_option("--timestep", options->time_step,
                  "DT (s): times are written as well as steps; default those of the files")
      ->check(positive());
  app->add_flag("--quiet", options->quiet, "no progress bar");
  app->callback([options] { reading_again(options->input, [&] { convert(*options); }); });
}

}  // namespace mikromakro
