// SPDX-License-Identifier: GPL-2.0-or-later
#include "options/window_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "model/error.h"
#include "options/value_checks.h"

namespace mikromakro {
namespace {

constexpr std::int64_t most_frames = 1000000000;

}  // namespace

void add_window_options(CLI::App& app, WindowOptions& options) {
  app.add_option("--every", options.every,
                 "N: averages as functions of time, over windows of N frames each, in one table")
      ->transform(whole_number(1, most_frames));
  app.add_flag("--per-frame", options.per_frame, "the same for each frame: --every 1");
  app.add_option("--moving", options.moving,
                 "N: the same over overlapping windows of N frames, one from each frame on")
      ->transform(whole_number(1, most_frames));
  app.add_option("--timestep", options.time_step,
                 "DT (s): time = step DT, for files without times; with --every, --per-frame or --moving")
      ->check(positive());
}

void check_windows(const WindowOptions& options) {
  const int given = (options.every > 0 ? 1 : 0) + (options.moving > 0 ? 1 : 0) + (options.per_frame ? 1 : 0);
  if (given > 1)
    throw bad_input({window_option(options)}, "windows are of one kind",
                    "one of --every, --per-frame and --moving", fmt::format("{} of them", given));
  if (given == 0 && options.time_step > 0)
    throw bad_input({"--timestep"}, "no column takes it", "--every, --per-frame or --moving beside it",
                    "none");
}

WindowRule rule_of(const WindowOptions& options) {
  if (options.moving > 0) return {options.moving, true, options.time_step};
  return {options.per_frame ? 1 : options.every, false, options.time_step};
}

std::string_view window_option(const WindowOptions& options) {
  if (options.moving > 0) return "--moving";
  return options.per_frame ? "--per-frame" : "--every";
}

void check_windows(const WindowOptions& options, const Windows& windows, Notes& notes) {
  const std::int64_t frames = rule_of(options).frames;
  std::int64_t most = 0;
  for (const Windows::Rest& rest : windows.rests()) {
    most = std::max(most, rest.frames);
    notes.add(
        fmt::format("frames at the end of run {} that do not fill a window of {} are left out: {}, "
                    "steps {} to {}",
                    rest.run + 1, frames, rest.frames, rest.first_step, rest.last_step));
  }
  if (windows.windows() == 0)
    throw bad_input({window_option(options)}, "no run fills a window",
                    fmt::format("at most {}, the selected frames of a run", most), fmt::format("{}", frames));
}

void describe_windows(const WindowOptions& options, std::int64_t windows, Preamble& lines) {
  const WindowRule rule = rule_of(options);
  lines.emplace_back("windows",
                     fmt::format("{} of {} frame{}{}", windows, rule.frames, rule.frames > 1 ? "s" : "",
                                 rule.moving ? ", one from each frame on" : ""));
  if (rule.time_step > 0) lines.emplace_back("time step", fmt::format("{} s", rule.time_step));
}

}  // namespace mikromakro
