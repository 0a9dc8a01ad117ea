// SPDX-License-Identifier: GPL-2.0-or-later
// MercuryDPM frames, with particles and contacts matched by time.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/frames/frame_format.h"
#include "io/mercury/mercury_reader.h"
#include "io/text/matched_frames.h"
#include "io/text/text_frames.h"

namespace mikromakro {

/// The files have no time steps: the step is the number of the frame, from 0. Frames missing from one of the
/// two files are left out and noted. Throws if no time is in both files, on requests for columns that the
/// files do not have, and on everything that mercury_particles and mercury_contacts throw on.
class MercuryFrames : public FrameFormat {
 public:
  /// No contact files: frames without contacts.
  MercuryFrames(const std::vector<std::string>& particle_files, const std::vector<std::string>& contact_files,
                ColumnWishes wishes);

  bool next(std::int64_t& step) override;
  UnpackFrame take(bool closely = false) override;
  std::int64_t bytes_read() const override { return frames_.bytes_read(); }

 private:
  ColumnWishes wishes_;
  MatchedFrames<MercuryHeader, MercuryBlock> frames_;
  std::int64_t step_ = -1;
};

}  // namespace mikromakro
