// SPDX-License-Identifier: GPL-2.0-or-later
// Checks that the requested types and volumes contain discs.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "io/frames/frame_stream.h"
#include "options/volume_options.h"

namespace mikromakro {

/// Which of the types named in an option have occurred, and the frames without them. look() is thread-safe.
class TypesSeen {
 public:
  TypesSeen(std::string_view option, std::vector<int> wanted);

  void look(const Frame& frame);
  std::vector<int> missing() const;
  const std::vector<int>& wanted() const { return wanted_; }
  const std::string& option() const { return option_; }
  /// The frames without the i-th wanted type, as a note.
  Notes& without(std::size_t i) { return without_[i]; }
  const Notes& without(std::size_t i) const { return without_[i]; }

 private:
  std::string option_;
  std::vector<int> wanted_;
  std::vector<std::atomic<bool>> seen_;
  std::vector<Notes> without_;
};

/// Throws if no frame has a disc of any of the wanted types; notes if only some types are missing, in all
/// frames or in some. Re-reads the frames if types are missing, since other ranks may have seen them.
void check_types(const FrameSource& source, const TypesSeen& types);

/// For averages whose sums are all zero: throws if the volumes contain no part of any averaged disc, and
/// reports where the discs are. Re-reads the frames up to the first that is not empty.
void check_coverage(const FrameSource& source, const VolumeOptions& volumes);

/// For averages of which some frames have sums that are all zero: notes each of the `suspects` (runs, from 0)
/// without a disc in any of the volumes, or without a disc of the averaged types, and such frames of other
/// runs. All of these count in averages as empty volumes. Re-reads the frames.
void note_empty_frames(const FrameSource& source, const VolumeOptions& volumes,
                       const std::set<std::int64_t>& suspects);

/// Both checks, for the averaged discs and those of the wheel, before the main pass: reads up to the first
/// frame that contains everything.
void check_before(FrameSource source, const VolumeOptions& volumes, const std::vector<int>& wheel_types);

}  // namespace mikromakro
