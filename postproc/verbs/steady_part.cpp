// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/steady_part.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "model/error.h"
#include "model/nearest_name.h"
#include "statistics/steady_state.h"
#include "verbs/listener.h"

namespace mikromakro {
namespace {

// The means over the volumes, frame by frame.
struct Series {
  std::vector<double> values;
  std::vector<std::int64_t> frames, steps;
};

Eigen::Index place_of(const std::string& column, const Averager& averager) {
  std::vector<std::string> names;
  for (const Column& one : averager.columns()) names.push_back(one.name);
  const auto found = std::find(names.begin(), names.end(), column);
  if (found == names.end())
    throw bad_input({"--steady"}, "no such column", fmt::format("one of {}", fmt::join(names, " ")),
                    in_quotes_with_guess(column, std::vector<std::string_view>(names.begin(), names.end())));
  return found - names.begin();
}

// nan if it is defined nowhere.
double mean_of(const Eigen::ArrayXd& numbers) {
  const auto defined = numbers.isFinite();
  return defined.select(numbers, 0).sum() / static_cast<double>(defined.count());
}

void check(const std::string& column, const Series& series) {
  if (std::ssize(series.values) < SteadyState::fewest)
    throw bad_input({"--steady"}, "too few frames to tell what drifts",
                    fmt::format("{} frames or more", SteadyState::fewest),
                    fmt::format("{}", series.values.size()));
  for (std::size_t i = 0; i < series.values.size(); ++i)
    if (std::isnan(series.values[i]))
      throw bad_input({"--steady"},
                      fmt::format("{} is nan in all volumes of step {}", column, series.steps[i]),
                      "a column that every frame defines", "nan");
}

std::string change_of(const SteadyState& state) {
  return fmt::format("a straight line through the rest changes by {:.3g} +- {:.2g}", state.change,
                     state.error);
}

Error never_steady(const std::string& column, const SteadyState& state) {
  return run_failed(fmt::format("--steady: {} drifts to the end", column),
                    fmt::format("a change of at most {} standard errors (a longer run?)", SteadyState::most),
                    std::isnan(state.error)
                        ? "a rest that is correlated over more than a quarter of its length"
                        : change_of(state));
}

}  // namespace

std::string cut_to_steady_part(const std::string& column, const Averager& averager, const RunOptions& options,
                               const Ranks& ranks, FrameSource& source) {
  Eigen::Index place = 0;
  ranks.agree([&] {
    place = place_of(column, averager);
    if (!source.further_runs.empty())
      throw bad_input({"--steady"}, "runs become steady at different times", "one run",
                      fmt::format("{} runs", source.runs().size()));
  });
  FrameSource all = source;
  all.notes = std::make_shared<Notes>();  // those of the frames that count are found again
  Series series;
  sum_frames(
      all, [&](const Frame& frame) { return averager.frame_sums(frame); }, options, ranks,
      [&](const FrameSums& frame) {
        series.values.push_back(mean_of(averager.values(frame.sums).col(place)));
        series.frames.push_back(frame.index);
        series.steps.push_back(frame.step);
      });
  std::string text;
  std::int64_t first = 0;
  ranks.agree([&] {
    if (!ranks.first()) return;
    if (series.values.empty()) throw source.no_frame_selected();
    check(column, series);
    const SteadyState state = steady_state(series.values);
    if (!state.steady()) throw never_steady(column, state);
    const auto begin = static_cast<std::size_t>(state.begin);
    first = series.frames[begin];
    text = fmt::format("{} from frame {} (step {}) on, {} of {} frames, by MSER-5; {}", column, first,
                       series.steps[begin], series.values.size() - begin, series.values.size(),
                       change_of(state));
    if (Listener::of_this_thread() == nullptr) fmt::print(stderr, "mikromakro: steady: {}\n", text);
  });
  source.selection = source.settled_selection();
  source.selection.first = ranks.of_first(first);
  return text;
}

}  // namespace mikromakro
