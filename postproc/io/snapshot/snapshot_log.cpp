// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/snapshot/snapshot_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "io/files/output_file.h"
#include "io/snapshot/snapshot_reader.h"
#include "io/snapshot/snapshot_writer.h"
#include "model/id_map.h"

namespace mikromakro {
namespace {

// Discs present in both frames must be the same; some may have been added or removed.
void check_discs(const RawFrame& there, const RawFrame& present, const std::string& file) {
  const IdMap ids(present.particles);
  std::size_t common = 0;
  for (const Particle& old : there.particles) {
    const int index = ids.find(old.id);
    if (index < 0) continue;
    ++common;
    const Particle& disc = present.particles[static_cast<std::size_t>(index)];
    if (disc.type != old.type || disc.radius != old.radius)
      throw bad_input({file}, fmt::format("belongs to another system, disc {} differs", old.id),
                      fmt::format("type {} and radius {:.17g} m", old.type, old.radius),
                      fmt::format("type {} and radius {:.17g} m", disc.type, disc.radius));
  }
  if (common == 0 && !there.particles.empty())
    throw bad_input({file}, "belongs to another system", "discs that the file has", "none of them");
}

// The frame at `index` of the file.
RawFrame frame_of(const std::string& file, std::size_t index) {
  SnapshotReader reader({file}, {});
  std::int64_t step = 0;
  for (std::size_t i = 0; i <= index; ++i) reader.next(step);
  RawFrame frame;
  reader.take()(frame);
  return frame;
}

}  // namespace

void check_snapshot_name(const std::string& file) {
  if (!file.ends_with(".h5"))
    throw bad_input({"file"}, "unknown kind of snapshot file", "a name ending in .h5", in_quotes(file));
  const OutputFile can_be_written(file);
}

SnapshotLog::SnapshotLog(std::string file, std::string program, SnapshotParameters parameters)
    : file_(std::move(file)), program_(std::move(program)), parameters_(std::move(parameters)) {
  check_snapshot_name(file_);
}

namespace {

// In step `now`, at or after frame `last`, at the rate of the last two frames.
double time_since(const std::vector<std::int64_t>& steps, const std::vector<double>& times, std::size_t last,
                  std::int64_t now) {
  if (now == steps[last]) return times[last];
  if (last == 0) return not_given;
  const double rate = (times[last] - times[last - 1]) / static_cast<double>(steps[last] - steps[last - 1]);
  return times[last] + rate * static_cast<double>(now - steps[last]);
}

}  // namespace

std::int64_t SnapshotLog::resume(const RawFrame& present) {
  if (!std::filesystem::exists(file_)) return 0;
  std::vector<std::int64_t> steps;
  std::vector<double> times;
  {
    const Hdf5File file = Hdf5File::open(file_);
    const SnapshotSummary summary = summarise_snapshots(file, file_);
    steps = summary.steps;
    times = summary.times;
    check_parameters(file, file_, parameters_);
  }
  frames_ =
      static_cast<std::uint64_t>(std::upper_bound(steps.begin(), steps.end(), present.step) - steps.begin());
  if (!steps.empty()) check_discs(frame_of(file_, frames_ > 0 ? frames_ - 1 : 0), present, file_);
  SnapshotWriter writer(Hdf5File::open_to_append(file_, true), file_);
  writer.check_same(present);  // before frames are dropped
  writer.keep(frames_);
  writer.close();
  begun_ = true;
  if (frames_ > 0) last_step_ = steps[frames_ - 1];
  if (frames_ > 0 && !times.empty())
    time_shift_ = time_since(steps, times, frames_ - 1, present.step) - present.time;
  if (!std::isfinite(time_shift_)) time_shift_ = 0;
  return static_cast<std::int64_t>(steps.size() - frames_);
}

void SnapshotLog::add(const RawFrame& frame) {
  if (begun_ && frame.step == last_step_) return;
  if (begun_ && frame.step < last_step_)
    throw bad_input({file_}, "time steps do not increase", fmt::format("more than {}", last_step_),
                    fmt::format("{}", frame.step));
  RawFrame shifted;
  const bool shifts = time_shift_ != 0;
  if (shifts) {
    shifted = frame;
    shifted.time += time_shift_;
  }
  begun_ ? append(shifts ? shifted : frame) : create(frame);
  begun_ = true;
  ++frames_;
  last_step_ = frame.step;
}

void SnapshotLog::create(const RawFrame& frame) {
  OutputFile file(file_);
  SnapshotWriter writer(file.temporary(), program_, SnapshotWriter::Use::running);
  writer.add(frame, frame.particles);
  writer.add_parameters(parameters_);
  writer.close();
  file.publish();
}

void SnapshotLog::append(const RawFrame& frame) {
  SnapshotWriter writer(Hdf5File::open_to_append(file_, false), file_);
  if (writer.frames() != frames_)
    throw run_failed(fmt::format("{}: another program writes to the same file", file_),
                     fmt::format("{} frames", frames_), fmt::format("{}", writer.frames()));
  writer.add(frame, frame.particles);
  writer.close();
}

}  // namespace mikromakro
