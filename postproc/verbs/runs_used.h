// SPDX-License-Identifier: GPL-2.0-or-later
// Which of several runs contribute to an average.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "averaging/parallel/ordered_sums.h"
#include "io/frames/frame_stream.h"
#include "options/volume_options.h"

namespace mikromakro {

/// 'run 2 (b.dump)', for messages; `run` counts from 0.
std::string run_name(const FrameSource& source, std::size_t run);

/// The selected frames of each run, and those whose sums are all zero.
class RunsUsed {
 public:
  explicit RunsUsed(std::size_t runs) : frames_(runs), zero_(runs) {}

  void add(std::int64_t run, bool all_sums_zero = false) {
    ++frames_[static_cast<std::size_t>(run)];
    zero_[static_cast<std::size_t>(run)] += all_sums_zero ? 1 : 0;
  }
  std::size_t runs() const { return frames_.size(); }
  bool used(std::size_t run) const { return frames_[run] > 0; }
  std::int64_t count_used() const;
  bool any_zero() const;
  /// Runs that have contributed nothing.
  std::set<std::int64_t> all_zero() const;

 private:
  std::vector<std::int64_t> frames_, zero_;
};

/// Notes each run without a selected frame, which the user has given to no effect.
void note_unused_runs(const FrameSource& source, const RunsUsed& used);

/// Notes runs whose first frame differs from that of the first run in the size of the discs or of the box by
/// more than a factor of 1.5 (lengths in mm, for example): an average over both describes neither.
void note_unlike_runs(const FrameSource& source);

}  // namespace mikromakro
