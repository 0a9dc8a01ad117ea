#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/commands.h"
#include "app/input_options.h"
#include "app/progress.h"
#include "app/warnings.h"
#include "drawing/picture.h"
#include "io/error.h"
#include "io/file_list.h"
#include "io/numbered_name.h"
#include "io/output_file.h"

namespace mikromakro {
namespace {

struct DrawOptions {
  InputOptions input;
  std::string out, color;
  std::vector<double> box, range;
  PictureStyle style;
  bool quiet = false;
};

void add_options(CLI::App& app, DrawOptions& options) {
  add_input_options(app, options.input);
  app.add_option("--out", options.out,
                 "FILE.png or FILE.svg; of several frames FILE_0000.png, ... or where %d (%04d) stands")
      ->required();
  app.add_option("--color", options.color,
                 fmt::format("{}; default velocity, or plain discs under a network or chains",
                             fmt::join(disc_quantity_names(), ", ")));
  app.add_option("--range", options.range, "LOW HIGH: ends of the colours (SI), default from the discs")
      ->expected(2);
  app.add_flag("--network", options.style.network, "a thin line for each contact");
  app.add_flag("--chains", options.style.chains,
               "lines as wide as the normal force: compression black, tension red");
  app.add_option("--box", options.box, "XMIN XMAX YMIN YMAX: what is shown (m), default all discs")
      ->expected(4);
  app.add_option("--bulk-types", options.style.bulk_types,
                 "types that are coloured, others are grey; default all")
      ->delimiter(',');
  app.add_option("--height", options.style.height, "thickness of the discs (m), for the pressure; default 1")
      ->check(CLI::PositiveNumber);
  app.add_option("--width", options.style.width, "of the picture, pixels; default 1600")
      ->check(CLI::Range(100, 20000));
  app.add_option("--timestep", options.style.time_step,
                 "DT (s): the stamp shows the time instead of the step")
      ->check(CLI::PositiveNumber);
  app.add_flag("--quiet", options.quiet, "no progress bar");
}

Canvas::Kind kind_of(const std::string& file) {
  if (file.ends_with(".png")) return Canvas::Kind::png;
  if (file.ends_with(".svg")) return Canvas::Kind::svg;
  throw bad_input({"--out"}, "unknown kind of picture", "a name ending in .png or .svg", in_quotes(file));
}

void set_quantity(DrawOptions& options) {
  PictureStyle& style = options.style;
  if (options.color.empty() && !style.network && !style.chains) options.color = "velocity";
  if (!options.color.empty()) style.quantity = &disc_quantity(options.color);
}

FrameSource source_of(const DrawOptions& options) {
  const PictureStyle& style = options.style;
  FrameSource source = frame_source(options.input);
  if (options.input.frames.empty() && options.input.steps.empty()) select_frames("0:0", source.selection);
  if (!style.bulk_types.empty()) source.particles_needed |= column_set(ParticleColumn::type);
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
  const auto finite = [](double number) { return std::isfinite(number); };
  if (!options.box.empty()) {
    const auto& box = options.box;
    if (!std::all_of(box.begin(), box.end(), finite) || box[0] >= box[1] || box[2] >= box[3])
      throw bad_input({"--box"}, "not a box", "XMIN < XMAX, YMIN < YMAX",
                      fmt::format("{}", fmt::join(box, " ")));
    scales.window = Box{{box[0], box[2]}, {box[1], box[3]}, {}};
  }
  if (!options.range.empty()) {
    const auto& range = options.range;
    if (!std::all_of(range.begin(), range.end(), finite) || range[0] >= range[1])
      throw bad_input({"--range"}, "the range is empty", "LOW < HIGH",
                      fmt::format("{}", fmt::join(range, " ")));
    scales.colours = {range[0], range[1]};
  }
}

// All frames are read once for scales that fit the whole sequence, then again for the pictures.
std::int64_t add_frames(const FrameSource& source, const DrawOptions& options, PictureScales& scales) {
  FrameStream stream(source);
  Frame frame;
  std::int64_t frames = 0;
  for (; stream.next(frame); ++frames) scales.add(frame, options.style);
  tell(*source.notes);
  if (frames == 0)
    throw bad_input({"--frames"}, "no frame is selected", "frames that --frames and --steps select", "0");
  return frames;
}

void draw(DrawOptions& options) {
  const Canvas::Kind kind = kind_of(options.out);
  set_quantity(options);
  options.style.border = !options.box.empty();
  PictureScales scales;
  apply_options(options, scales);
  const FrameSource source = source_of(options);
  const std::int64_t frames = add_frames(source, options, scales);
  apply_options(options, scales);
  Progress progress(total_size(source.files()), options.quiet);
  FrameStream stream(source);
  Frame frame;
  for (std::int64_t i = 0; stream.next(frame); ++i) {
    OutputFile file(numbered_name(options.out, i, frames));
    file.commit(draw_picture(frame, options.style, scales, kind));
    progress.update(stream.bytes_read(), i + 1);
  }
}

}  // namespace

void add_draw_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("draw", "discs, contact network and force chains as PNG or SVG");
  auto options = std::make_shared<DrawOptions>();
  add_options(*app, *options);
  app->callback([options] { reading_again(options->input, [&] { draw(*options); }); });
}

}  // namespace mikromakro
