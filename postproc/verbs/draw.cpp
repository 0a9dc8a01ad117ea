// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/draw.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "io/files/file_list.h"
#include "io/files/output_file.h"
#include "model/error.h"
#include "model/numbered_name.h"
#include "options/plausible_options.h"
#include "options/value_checks.h"
#include "verbs/coverage.h"
#include "verbs/listener.h"
#include "verbs/progress.h"
#include "verbs/run_constants.h"
#include "verbs/runs_used.h"
#include "verbs/warnings.h"

namespace mikromakro {
namespace {

Canvas::Kind kind_of(const std::string& file) {
  if (file.ends_with(".png")) return Canvas::Kind::png;
  if (file.ends_with(".svg")) return Canvas::Kind::svg;
  throw bad_input({"--out"}, "unknown kind of picture", "a name ending in .png or .svg", in_quotes(file));
}

void set_quantity(DrawOptions& options) {
  PictureStyle& style = options.style;
  if (options.color.empty() && !style.network && !style.chains) options.color = "velocity";
  if (!options.color.empty()) style.quantity = &disc_quantity(options.color);
  if (style.quantity == nullptr && !options.range.empty())
    throw bad_input({"--range"}, "the discs have no colours", "--color as well", "none");
  const bool pressure = style.quantity != nullptr && style.quantity->quantity == DiscQuantity::pressure;
  if (options.height > 0 && !pressure)
    throw bad_input({"--height"}, "it applies to the pressure only", "--color pressure",
                    options.color.empty() ? "none" : options.color);
}

std::string numbers_text(const std::vector<double>& numbers) {
  return fmt::format("{}", fmt::join(numbers, " "));
}

// Call before --box and --range replace the limits found from the discs.
void check_scales(const DrawOptions& options, const PictureScales& scales, Notes& notes) {
  if (!options.box.empty() && scales.window) {
    const Box& discs = *scales.window;
    const auto& box = options.box;
    if (box[1] < discs.low[0] || box[0] > discs.high[0] || box[3] < discs.low[1] || box[2] > discs.high[1])
      throw bad_input({"--box"}, "no disc lies in it",
                      fmt::format("the region of the discs, x = {:.6g} to {:.6g}, y = {:.6g} to {:.6g} m",
                                  discs.low[0], discs.high[0], discs.low[1], discs.high[1]),
                      numbers_text(box));
  }
  const Limits& values = scales.values;
  if (!options.range.empty() && !values.empty() &&
      (options.range[1] < values.low || options.range[0] > values.high))
    notes.add(
        fmt::format("--range: all discs get the colour of one end, since their values are {:.6g} to {:.6g}",
                    values.low, values.high));
}

FrameSource source_of(const DrawOptions& options) {
  const PictureStyle& style = options.style;
  FrameSource source = frame_source(options.input);
  if (options.input.frames.empty() && options.input.steps.empty()) select_frames("0:0", source.selection);
  if (!style.bulk_types.empty()) source.particles_needed |= column_set(ParticleColumn::type);
  source.averaged_types = style.bulk_types;
  if (style.quantity != nullptr) {
    source.particles_needed |= style.quantity->particles_needed;
    source.contacts_needed |= style.quantity->contacts_needed;
  }
  if (style.network) source.contacts_needed |= column_set(ContactColumn::overlap);
  if (style.chains)
    source.contacts_needed |= column_set(ContactColumn::fx, ContactColumn::fy, ContactColumn::overlap);
  source.contacts_required = source.contacts_needed != 0;
  if (source.contacts_required) require_contacts(options.input, "the picture needs");
  return source;
}

void apply_options(const DrawOptions& options, PictureScales& scales) {
  if (!options.box.empty()) {
    const auto& box = options.box;
    if (box[0] >= box[1] || box[2] >= box[3])
      throw bad_input({"--box"}, "not a box", "XMIN < XMAX, YMIN < YMAX", numbers_text(box));
    scales.window = Box{{box[0], box[2]}, {box[1], box[3]}, {}};
  }
  if (!options.range.empty()) {
    const auto& range = options.range;
    if (range[0] >= range[1])
      throw bad_input({"--range"}, "the range is empty", "LOW < HIGH", numbers_text(range));
    scales.colours = {range[0], range[1]};
  }
}

// First pass: reads all frames to find scales that fit the whole sequence; a second pass draws them.
std::int64_t add_frames(const FrameSource& source, const DrawOptions& options, PictureScales& scales) {
  FrameStream stream(source);
  Frame frame;
  std::int64_t frames = 0;
  TypesSeen types("--bulk-types", options.style.bulk_types);
  RunsUsed runs(1 + source.further_runs.size());
  for (; stream.next(frame); ++frames) {
    check_time(frame, stream.raw().particle_file, options.style.time_step);
    scales.add(frame, options.style);
    note_height(frame, options.height, *source.notes);
    if (source.contacts_required) note_walls(frame, options.input, *source.notes);
    types.look(frame);
    runs.add(frame.run);
    if (Listener* listener = Listener::of_this_thread()) listener->pause();
  }
  if (frames == 0) throw source.no_frame_selected();
  note_unused_runs(source, runs);
  check_types(source, types);
  check_scales(options, scales, *source.notes);
  tell(*source.notes);
  return frames;
}

// Without a thickness, pressure is force per length.
void set_height(const FrameSource& source, DrawOptions& options) {
  take_height(source, options.height);
  PictureStyle& style = options.style;
  style.height = options.height > 0 ? options.height : 1;
  if (style.quantity == nullptr || style.quantity->quantity != DiscQuantity::pressure || options.height > 0)
    return;
  options.quantity = *style.quantity;
  options.quantity.unit = "N/m";
  style.quantity = &options.quantity;
}

std::vector<std::string> picture_names(const DrawOptions& options, std::int64_t frames) {
  std::vector<std::string> names;
  for (std::int64_t i = 0; i < frames; ++i) names.push_back(numbered_name(options.out, i, frames));
  return names;
}

std::vector<std::string> draw_once(DrawOptions& options) {
  const Canvas::Kind kind = kind_of(options.out);
  set_quantity(options);
  options.style.border = !options.box.empty();
  PictureScales scales;
  apply_options(options, scales);
  const FrameSource source = source_of(options);
  check_outputs({options.out}, source.files());
  set_height(source, options);
  scales = {};
  const std::int64_t frames = add_frames(source, options, scales);
  apply_options(options, scales);
  std::vector<std::string> names = picture_names(options, frames);
  check_outputs(names, source.files());
  Progress progress(total_size(source.files()), options.quiet);
  FrameStream stream(source);
  Frame frame;
  for (std::int64_t i = 0; stream.next(frame); ++i) {
    OutputFile file(names[static_cast<std::size_t>(i)]);
    file.commit(draw_picture(frame, options.style, scales, kind));
    progress.update(stream.bytes_read(), i + 1);
  }
  return names;
}

}  // namespace

void add_draw_options(CLI::App& app, DrawOptions& options) {
  add_input_options(app, options.input);
  app.add_option(
         "--out", options.out,
         "FILE.png or FILE.svg; of several frames FILE_0000.png, ... or numbered by a %d (%04d) in the name")
      ->required();
  app.add_option("--color", options.color,
                 fmt::format("{}; default velocity, or plain discs under a network or chains",
                             fmt::join(disc_quantity_names(), ", ")));
  app.add_option("--range", options.range, "LOW HIGH: ends of the colour scale (SI), default from the discs")
      ->expected(2)
      ->allow_extra_args(false);
  app.add_flag("--network", options.style.network, "a thin line for each contact");
  app.add_flag("--chains", options.style.chains,
               "lines as wide as the normal force: compression black, tension red");
  app.add_option("--box", options.box, "XMIN XMAX YMIN YMAX: region to draw (m), default all discs")
      ->expected(4)
      ->allow_extra_args(false);
  app.add_option("--bulk-types", options.style.bulk_types, "types to colour, others are grey; default all")
      ->delimiter(',');
  app.add_option("--height", options.height,
                 "thickness of the discs (m), for --color pressure; default that of the snapshots, or none")
      ->check(positive());
  app.add_option("--width", options.style.width, "of the picture in pixels, default 1600")
      ->transform(whole_number(100, 20000));
  app.add_option(
         "--timestep", options.style.time_step,
         "DT (s): the stamp shows the time instead of the step; default the times of the files, if any")
      ->check(positive());
  app.add_flag("--quiet", options.quiet, "no progress bar");
}

std::vector<std::string> draw(DrawOptions options) {
  std::vector<std::string> files;
  reading_again(options.input, [&] { files = draw_once(options); });
  return files;
}

}  // namespace mikromakro
