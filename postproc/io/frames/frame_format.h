// SPDX-License-Identifier: GPL-2.0-or-later
// The interface of all input formats: a sequence of frames, with rows as in the file.
#pragma once

#include <cstdint>
#include <functional>

#include "model/raw_frame.h"

namespace mikromakro {

/// Builds a frame from bytes that were read before. Reads no file and shares no mutable state, so several
/// threads may unpack different frames.
using UnpackFrame = std::function<void(RawFrame&)>;

/// An input format: text dumps, HDF5 snapshots, MercuryDPM files.
class FrameFormat {
 public:
  FrameFormat() = default;
  FrameFormat(const FrameFormat&) = delete;
  FrameFormat& operator=(const FrameFormat&) = delete;
  virtual ~FrameFormat() = default;

  /// Advances to the next frame; false at the end.
  virtual bool next(std::int64_t& step) = 0;
  /// Reads the bytes of the frame found by `next`; without this call the frame is skipped. `closely`:
  /// including all contact columns that can be checked, whether needed or not.
  virtual UnpackFrame take(bool closely = false) = 0;
  /// The run that this frame belongs to, from 0.
  virtual std::int64_t run() const { return 0; }
  /// Number of contact rows of this frame over all files; -1 if it is known only after parsing.
  virtual std::int64_t contact_rows() const { return -1; }
  /// For the progress bar.
  virtual std::int64_t bytes_read() const = 0;
};

}  // namespace mikromakro
