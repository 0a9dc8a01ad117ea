// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "app/command_text.h"
#include "app/commands.h"
#include "app/report_audit.h"
#include "app/report_data.h"
#include "app/report_profiles.h"
#include "io/files/output_file.h"
#include "io/snapshot/snapshot_summary.h"
#include "model/error.h"
#include "options/plausible_options.h"
#include "options/value_checks.h"
#include "report/page.h"
#include "report/scene.h"
#include "verbs/audits.h"
#include "verbs/coverage.h"
#include "verbs/input_options.h"
#include "verbs/memory_need.h"
#include "verbs/run_constants.h"
#include "verbs/warnings.h"

namespace mikromakro {
namespace {

struct ReportOptions {
  InputOptions input;
  AverageOptions average;
  std::vector<int> wheel_types;
  double margin = 0;
  std::int64_t every = 0;  // 0: a tenth of the frames
  std::int64_t scene_frames = 100;
  double time_step = 0;
  std::string title, out;
  bool quiet = false;
};

void add_options(CLI::App& app, ReportOptions& options) {
  add_input_options(app, options.input);
  add_volume_options(app, options.average.volumes);
  add_weight_option(app, options.average.volumes);
  add_field_options(app, options.average.fields);
  app.add_option("--wheel-types", options.wheel_types,
                 "types of the wheel's discs, for the audit of rings; the inner wall counts too")
      ->delimiter(',');
  app.add_option(
         "--margin", options.margin,
         "rings nearer than this to the first and last edge are not judged by the audit (m), default 0")
      ->check(not_negative());
  app.add_option("--every", options.every,
                 "frames per window of the profiles, default a tenth of all, but 8 or more")
      ->transform(whole_number(1, 1000000000));
  app.add_option("--scene-frames", options.scene_frames,
                 "frames that are shown, evenly spaced among those read, default 100; averages are of all")
      ->transform(whole_number(1, 100000));
  app.add_option("--timestep", options.time_step, "DT (s): the page shows times where the files give none")
      ->check(positive());
  app.add_option("--title", options.title, "heading of the page, default the names of the files");
  app.add_option("--out", options.out, "FILE.html")->required();
  app.add_flag("--quiet", options.quiet, "no progress bar");
}

// Input, averager and audit, completed with the constants from the files.
struct Task {
  AverageOptions average;
  std::unique_ptr<const Averager> averager;
  AuditOptions audit;
  FrameSource source;
  bool with_contacts = false;
};

bool any_contacts(const InputOptions& input, const FrameSource& source) {
  if (source.snapshot_files.empty()) return input.any_contacts();
  const std::string& file = source.snapshot_files.front();
  return !summarise_snapshots(Hdf5File::open(file), file).contact_offsets.empty();
}

Task task_of(const ReportOptions& options) {
  Task task;
  task.average = options.average;
  const FrameSource files = frame_source(options.input);
  take_height(files, task.average.volumes.height);
  take_stiffness(files, task.average.volumes.bulk_types, task.average.fields);
  take_friction(files, task.average.fields);
  note_other_runs(files);
  note_unrecorded_walls(files);
  task.averager = make_averager(task.average);
  check_use(options.average.volumes, *task.averager);
  check_memory({static_cast<double>(task.averager->volume_count() * task.averager->sum_count()), 1,
                2 * static_cast<double>(error_blocks(task.average, *task.averager))},
               volume_option(task.average.volumes));
  task.source = source_of(options.input, *task.averager);
  task.source.notes = files.notes;
  task.with_contacts = any_contacts(options.input, files);
  if (task.with_contacts)
    task.source.contacts_needed |= column_set(ContactColumn::fx, ContactColumn::fy, ContactColumn::overlap);
  task.audit = audit_options(options.input, options.average);
  task.audit.wheel_types = options.wheel_types;
  task.audit.margin = options.margin;
  task.audit.quiet = options.quiet;
  check_wheel_and_margin(task.audit);
  return task;
}

// What the first pass finds: the average of all frames, and what the scene spans.
struct Survey {
  Averaged all;
  SceneRanges ranges;
  Json first, last;  // frames
};

Survey survey(const ReportOptions& options, const Task& task) {
  const VolumeOptions& volumes = task.average.volumes;
  Survey result{{no_sums(task.average, *task.averager), {}},
                SceneRanges({volumes.bulk_types, volumes.height, options.time_step}),
                {},
                {}};
  TypesSeen types("--bulk-types", volumes.bulk_types), wheel("--wheel-types", options.wheel_types);
  read_frames(task.source, task.audit, [&](const Frame& frame) {
    Notes& notes = *task.source.notes;
    check_time(frame, task.source.files().front(), options.time_step);
    types.look(frame);
    wheel.look(frame);
    note_volumes(frame, volumes, notes);
    note_density(frame, task.source.density, options.average.volumes.height, notes);
    if (task.with_contacts) {
      note_branch(frame, volumes, notes);
      note_walls(frame, options.input, notes);
    }
    result.ranges.add(frame);
    result.last = place_json(frame, options.time_step);
    if (result.first.is_null()) result.first = result.last;
    const Rows sums = task.averager->frame_sums(frame);
    result.all.add(frame.step, sums, frame.run);
    return (sums != 0).any();
  });
  check_types(task.source, types);
  check_types(task.source, wheel);
  check_wheel_is_no_bulk(task.audit);
  if ((result.all.sums.mean() == 0).all()) check_coverage(task.source, volumes);
  return result;
}

// Pages with more numbers than this would be slow.
constexpr double most_numbers = 500000;

std::int64_t window_length(const ReportOptions& options, const Task& task, std::int64_t frames) {
  constexpr std::int64_t windows = 10, fewest = 8;
  const std::int64_t every =
      options.every > 0 ? options.every : std::max(fewest, (frames + windows - 1) / windows);
  const std::int64_t tables = (frames + every - 1) / every + 1;
  const double numbers = 2.0 * static_cast<double>(tables) *
                         static_cast<double>(task.averager->volume_count()) *
                         static_cast<double>(task.averager->columns().size());
  if (numbers > most_numbers)
    throw bad_input(
        {options.every > 0 ? "--every" : volume_option(task.average.volumes)}, "too many numbers for a page",
        fmt::format("at most {:.0f} values and errors in all windows (fewer volumes, --fields, or "
                    "longer windows)",
                    most_numbers),
        fmt::format("{:.0f}", numbers));
  return every;
}

// The second pass: windows, and the frames of the scene.
Json windows_and_scene(const ReportOptions& options, const Task& task, const Survey& found,
                       std::int64_t every, std::string& scene) {
  const std::int64_t frames = found.all.sums.frames();
  const std::int64_t stride = (frames + options.scene_frames - 1) / options.scene_frames;
  PageWindows windows(*task.averager, {every, false, options.time_step},
                      error_blocks(task.average, *task.averager));
  ScenePacker packer(found.ranges);
  std::int64_t place = 0;
  read_frames(task.source, task.audit, [&](const Frame& frame) {
    windows.add(frame);
    if (place++ % stride == 0) packer.add(frame);
    return true;
  });
  scene = packer.finish();
  Json description = found.ranges.description();
  description["stride"] = stride;
  description["frames"] = packer.frames();
  if (options.every > 0 && windows.windows().empty())
    throw bad_input({"--every"}, "no window is full", "as many frames as a run has, or fewer",
                    fmt::format("{}", options.every));
  const Json all = windows.windows_of_frames();
  Json of_scene = Json::array();
  for (std::size_t i = 0; i < all.size(); i += static_cast<std::size_t>(stride)) of_scene.push_back(all[i]);
  description["windows_of_frames"] = of_scene;
  return {{"windows", windows.windows()}, {"scene", description}};
}

void report(const ReportOptions& options, const CLI::App& app) {
  if (!options.out.ends_with(".html"))
    throw bad_input({"--out"}, "unknown kind of output file", "a name ending in .html",
                    in_quotes(options.out));
  const Task task = task_of(options);
  check_outputs({options.out}, task.source.files());
  OutputFile file(options.out);
  const Survey found = survey(options, task);
  const std::int64_t every = window_length(options, task, found.all.sums.frames());
  std::string scene;
  Json data = {{"title", options.title.empty() ? title_of(task.source) : options.title},
               {"program", "mikromakro " MIKROMAKRO_VERSION}};
  data.update(windows_and_scene(options, task, found, every, scene));
  data["every"] = every;
  data["colours"] = colours_json();
  data["volumes"] = volumes_json(*task.averager, task.average.volumes);
  data["columns"] = columns_json(*task.averager);
  const BlockErrors errors = errors_of(*task.averager, found.all.sums);
  data["all"] = averages_json(*task.averager, found.all.sums, errors);
  data["all"]["first"] = found.first;
  data["all"]["last"] = found.last;
  data["audit"] = task.with_contacts ? audit_json(task.audit)
                                     : Json{{"impossible", "there are no contacts in the input"}};
  Preamble lines;
  describe_input(options.input, task.source, found.all.runs.size(), lines);
  data["parameters"] = parameters_json(task.average, *task.averager, found.all, errors, std::move(lines));
  data["constants"] = constants_json(task.source);
  data["commands"] = commands_json(app, task.audit, task.source.settled_selection().stride);
  file.commit(page_html(data, scene));
}

}  // namespace

void add_report_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "report", "a page for a browser: the scene, profiles, audit and parameters in one file");
  auto options = std::make_shared<ReportOptions>();
  add_options(*app, *options);
  app->callback([options, app] { reading_again(options->input, [&] { report(*options, *app); }); });
}

}  // namespace mikromakro
