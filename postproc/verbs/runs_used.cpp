// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/runs_used.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace mikromakro {
namespace {

// What runs of one system have in common.
struct Scale {
  double radius = 0;  // mean
  Eigen::Vector2d box;
};

std::optional<Scale> scale_of(FrameSource run) {
  run.particles_needed = run.contacts_needed = 0;
  run.contact_files.clear();
  run.wall_files.clear();
  run.contacts_required = run.look_through = false;
  run.density = 0;
  FrameStream stream(run);
  Frame frame;
  if (!stream.next(frame) || frame.particles.empty()) return {};
  double sum = 0;
  for (const Particle& disc : frame.particles) sum += disc.radius;
  return Scale{sum / static_cast<double>(frame.particles.size()), frame.box.length()};
}

bool unlike(double one, double other) {
  constexpr double factor = 1.5;
  return one > factor * other || other > factor * one;
}

std::string text_of(const Scale& scale) {
  return fmt::format("{:.4g} m, {:.4g} m by {:.4g} m", scale.radius, scale.box.x(), scale.box.y());
}

}  // namespace

std::string run_name(const FrameSource& source, std::size_t run) {
  return fmt::format("run {} ({})", run + 1, source.one_run(run).files().front());
}

std::int64_t RunsUsed::count_used() const {
  return std::count_if(frames_.begin(), frames_.end(), [](std::int64_t frames) { return frames > 0; });
}

bool RunsUsed::any_zero() const {
  return std::any_of(zero_.begin(), zero_.end(), [](std::int64_t frames) { return frames > 0; });
}

std::set<std::int64_t> RunsUsed::all_zero() const {
  std::set<std::int64_t> runs;
  for (std::size_t i = 0; i < frames_.size(); ++i)
    if (used(i) && zero_[i] == frames_[i]) runs.insert(static_cast<std::int64_t>(i));
  return runs;
}

void note_unused_runs(const FrameSource& source, const RunsUsed& used) {
  for (std::size_t i = 0; i < used.runs(); ++i) {
    if (used.used(i)) continue;
    const FrameSource::Count there = source.one_run(i).count();
    source.notes->add(
        there.frames == 0
            ? fmt::format("{} has no frame", run_name(source, i))
            : fmt::format("{} has no selected frame (--frames and --steps; its {} frames are of "
                          "the steps {} to {})",
                          run_name(source, i), there.frames, there.first_step, there.last_step));
  }
}

void note_unlike_runs(const FrameSource& source) {
  std::optional<Scale> first;
  std::size_t of_first = 0;
  const std::size_t runs = 1 + source.further_runs.size();
  for (std::size_t i = 0; runs > 1 && i < runs; ++i) {
    const std::optional<Scale> scale = scale_of(source.one_run(i));
    if (!scale) continue;
    if (!first) {
      first = scale;
      of_first = i;
    }
    if (unlike(scale->radius, first->radius) || unlike(scale->box.x(), first->box.x()) ||
        unlike(scale->box.y(), first->box.y()))
      source.notes->add(fmt::format(
          "{} differs in size from {}: mean radius and box {}, against {} (another system or unit?)",
          run_name(source, i), run_name(source, of_first), text_of(*scale), text_of(*first)));
  }
}

}  // namespace mikromakro
