// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/coverage.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "drawing/picture.h"
#include "model/error.h"
#include "verbs/listener.h"
#include "verbs/runs_used.h"

namespace mikromakro {
namespace {

// Reads discs and their types only.
void for_each_frame(FrameSource source, const std::function<bool(const Frame&)>& keep_going) {
  source.notes = std::make_shared<Notes>();  // the first pass has reported everything
  source.particles_needed = column_set(ParticleColumn::type) & source.particles_needed;
  FrameStream stream(source);
  Frame frame;
  while (stream.next(frame) && keep_going(frame))
    if (Listener* listener = Listener::of_this_thread()) listener->pause();
}

bool is_averaged(const Particle& particle, const std::vector<int>& types) {
  return types.empty() || std::find(types.begin(), types.end(), particle.type) != types.end();
}

// The region occupied by the averaged discs.
struct Extent {
  Limits x, y, r;

  void add(const Frame& frame, const VolumeOptions& volumes) {
    const bool rings = volumes.grid.empty() && volumes.box.empty();
    const Eigen::Vector2d centre = rings ? ring_centre(volumes) : Eigen::Vector2d::Zero();
    for (const Particle& particle : frame.particles) {
      if (!is_averaged(particle, volumes.bulk_types)) continue;
      for (const double side : {-particle.radius, particle.radius}) {
        x.add(particle.position.x() + side);
        y.add(particle.position.y() + side);
        r.add(std::max(0.0, (particle.position - centre).norm() + side));
      }
    }
  }
};

std::string place_of(const Extent& discs, const VolumeOptions& volumes) {
  if (volumes.grid.empty() && volumes.box.empty())
    return fmt::format("r = {:.6g} to {:.6g} m", discs.r.low, discs.r.high);
  return fmt::format("x = {:.6g} to {:.6g}, y = {:.6g} to {:.6g} m", discs.x.low, discs.x.high, discs.y.low,
                     discs.y.high);
}

const std::vector<double>& numbers_of(const VolumeOptions& volumes) {
  if (!volumes.rings.empty()) return volumes.rings;
  if (!volumes.edges.empty()) return volumes.edges;
  return volumes.grid.empty() ? volumes.box : volumes.grid;
}

// Whether discs in this region may be expected in the volumes: a dilute gas may leave a small volume empty.
bool surrounds(const Extent& discs, const VolumeOptions& volumes) {
  const auto overlap = [](const Limits& one, double low, double high) {
    return one.low < high && one.high > low;
  };
  const std::vector<double>& grid = volumes.grid;
  const std::vector<double>& box = volumes.box;
  if (!grid.empty()) return overlap(discs.x, grid[0], grid[1]) && overlap(discs.y, grid[3], grid[4]);
  if (!box.empty()) return overlap(discs.x, box[0], box[1]) && overlap(discs.y, box[2], box[3]);
  const std::vector<double> edges = ring_edges(volumes);
  return overlap(discs.r, edges.front(), edges.back());
}

// What the frames of a run contain.
struct RunContents {
  Extent discs;  // those that are averaged
  std::set<int> types;
  bool covered = false;
  std::vector<std::int64_t> empty_steps;    // of frames without averaged discs
  std::vector<std::int64_t> outside_steps;  // of frames with such discs, but none in the volumes
};

std::string why_empty(const RunContents& run, const VolumeOptions& volumes) {
  if (!run.discs.r.empty())
    return "no disc lies in any of the volumes; its discs are at " + place_of(run.discs, volumes);
  if (run.types.empty()) return "its frames contain no discs";
  return fmt::format("no disc is of a type of --bulk-types {}; its types are {}",
                     fmt::join(volumes.bulk_types, ","), fmt::join(run.types, ","));
}

}  // namespace

TypesSeen::TypesSeen(std::string_view option, std::vector<int> wanted)
    : option_(option), wanted_(std::move(wanted)), seen_(wanted_.size()), without_(wanted_.size()) {}

void TypesSeen::look(const Frame& frame) {
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    const auto of_type = [&](const Particle& particle) { return particle.type == wanted_[i]; };
    if (std::any_of(frame.particles.begin(), frame.particles.end(), of_type))
      seen_[i].store(true, std::memory_order_relaxed);
    else if (!frame.particles.empty())
      without_[i].add(fmt::format("{}: frames contain no disc of type {}", option_, wanted_[i]), frame.step);
  }
}

std::vector<int> TypesSeen::missing() const {
  std::vector<int> types;
  for (std::size_t i = 0; i < wanted_.size(); ++i)
    if (!seen_[i]) types.push_back(wanted_[i]);
  return types;
}

void check_types(const FrameSource& source, const TypesSeen& types) {
  std::vector<int> missing = types.missing();
  std::set<int> present;
  if (!missing.empty())
    for_each_frame(source, [&](const Frame& frame) {
      for (const Particle& particle : frame.particles) present.insert(particle.type);
      return true;
    });
  std::erase_if(missing, [&](int type) { return present.count(type) != 0; });
  for (std::size_t i = 0; i < types.wanted().size(); ++i)
    if (std::find(missing.begin(), missing.end(), types.wanted()[i]) == missing.end())
      source.notes->add(types.without(i));
  if (missing.empty()) return;
  if (missing.size() == types.wanted().size())
    throw bad_input({types.option()}, "no disc is of such a type",
                    fmt::format("some of {}", fmt::join(present, ",")),
                    fmt::format("{}", fmt::join(missing, ",")));
  source.notes->add(fmt::format("{}: no disc is of type {}; the types are {}", types.option(),
                                fmt::join(missing, ","), fmt::join(present, ",")));
}

void check_coverage(const FrameSource& source, const VolumeOptions& volumes) {
  const auto averager = make_averager(volumes, make_fields({"solid_fraction"}));
  Extent discs;
  bool covered = false;
  for_each_frame(source, [&](const Frame& frame) {
    covered = (averager->frame_sums(frame) != 0).any();
    discs.add(frame, volumes);
    return !covered;
  });
  if (covered) return;
  throw bad_input(
      {volume_option(volumes)}, "no disc lies in any of the volumes",
      discs.r.empty() ? "frames with discs" : "the region of the discs, " + place_of(discs, volumes),
      fmt::format("{}", fmt::join(numbers_of(volumes), " ")));
}

void note_empty_frames(const FrameSource& source, const VolumeOptions& volumes,
                       const std::set<std::int64_t>& suspects) {
  const auto averager = make_averager(volumes, make_fields({"solid_fraction"}));
  std::map<std::int64_t, RunContents> runs;
  for_each_frame(source, [&](const Frame& frame) {
    RunContents& run = runs[frame.run];
    bool empty = true;
    for (const Particle& particle : frame.particles) {
      run.types.insert(particle.type);
      empty = empty && !is_averaged(particle, volumes.bulk_types);
    }
    run.discs.add(frame, volumes);
    const bool outside = !empty && (averager->frame_sums(frame) == 0).all();
    run.covered = run.covered || !(empty || outside);
    if (empty) run.empty_steps.push_back(frame.step);
    Extent of_frame;
    of_frame.add(frame, volumes);
    if (outside && !surrounds(of_frame, volumes)) run.outside_steps.push_back(frame.step);
    return true;
  });
  for (const auto& [number, run] : runs) {
    if (suspects.count(number) != 0 && !run.covered) {
      source.notes->add(fmt::format("{}: {}: its frames count as empty volumes",
                                    run_name(source, static_cast<std::size_t>(number)),
                                    why_empty(run, volumes)));
      continue;
    }
    for (const std::int64_t step : run.empty_steps)
      source.notes->add("frames contain no averaged disc, and count as empty volumes", step);
    for (const std::int64_t step : run.outside_steps)
      source.notes->add("no averaged disc of these frames lies in any of the volumes, which count as empty",
                        step);
  }
}

void check_before(FrameSource source, const VolumeOptions& volumes, const std::vector<int>& wheel_types) {
  if (!volumes.bulk_types.empty() || !wheel_types.empty())
    source.particles_needed |= column_set(ParticleColumn::type);
  TypesSeen bulk("--bulk-types", volumes.bulk_types), wheel("--wheel-types", wheel_types);
  for_each_frame(source, [&](const Frame& frame) {
    bulk.look(frame);
    wheel.look(frame);
    return !bulk.missing().empty() || !wheel.missing().empty();
  });
  check_types(source, bulk);
  check_types(source, wheel);
  if (!numbers_of(volumes).empty()) check_coverage(source, volumes);
}

}  // namespace mikromakro
