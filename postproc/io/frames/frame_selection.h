// SPDX-License-Identifier: GPL-2.0-or-later
// Which frames are averaged.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace mikromakro {

/// Frames FIRST:LAST[:STEP] by index (from 0, both ends included; negative values count from the end, -1 is
/// the last) and A:B by time step (both ends included).
struct FrameSelection {
  std::int64_t first = 0;
  std::int64_t last = std::numeric_limits<std::int64_t>::max();
  std::int64_t stride = 1;
  std::int64_t first_step = 0;
  std::int64_t last_step = std::numeric_limits<std::int64_t>::max();

  bool contains(std::int64_t index, std::int64_t step) const {
    return index >= first && index <= last && (index - first) % stride == 0 && step >= first_step &&
           step <= last_step;
  }
  /// Whether the number of frames must be known before frames can be selected.
  bool counts_from_the_end() const { return first < 0 || last < 0; }
  static FrameSelection none();
  /// The same selection among `frames` frames, with non-negative indices.
  FrameSelection among(std::int64_t frames) const;

  /// Whether no later frame can be selected.
  bool over_after(std::int64_t index, std::int64_t step) const { return index >= last || step >= last_step; }
};

/// Set the part of the selection given by --frames or --steps; an omitted end (`5:`, `:9`) is open, a single
/// number selects one frame or step. Throw on anything else and on an empty range.
void select_frames(const std::string& text, FrameSelection& selection);
void select_steps(const std::string& text, FrameSelection& selection);

}  // namespace mikromakro
