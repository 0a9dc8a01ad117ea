// SPDX-License-Identifier: GPL-2.0-or-later
// Whether there is anything in what was asked for: types and volumes that hold no disc.
#pragma once

#include <atomic>
#include <memory>
#include <string_view>
#include <vector>

#include "io/frames/frame_stream.h"
#include "options/volume_options.h"

namespace mikromakro {

/// Which of the types that an option names have been seen. Any thread may look; once all are found, looking
/// costs nothing.
class TypesSeen {
 public:
  explicit TypesSeen(std::vector<int> wanted);

  void look(const Frame& frame);
  std::vector<int> missing() const;
  const std::vector<int>& wanted() const { return wanted_; }

 private:
  std::vector<int> wanted_;
  std::vector<std::atomic<bool>> seen_;
};

/// Throws where no disc of all frames has one of the types; notes where some types have none. Reads the
/// frames once more where types are missing, since other ranks may have seen them.
void check_types(const FrameSource& source, std::string_view option, const TypesSeen& types);

/// For averages whose sums are all zero: throws where the volumes hold no part of any averaged disc, and says
/// where the discs are. Reads the frames once more, up to the first one that is not empty.
void check_coverage(const FrameSource& source, const VolumeOptions& volumes);

/// Both, of discs and of the wheel's discs, before the frames are read: up to the first one where all is
/// there.
void check_before(FrameSource source, const VolumeOptions& volumes, const std::vector<int>& wheel_types);

}  // namespace mikromakro
