// SPDX-License-Identifier: GPL-2.0-or-later
// What every kind of input gives: frames one after the other, as their rows stand in the file.
#pragma once

#include <cstdint>
#include <functional>

#include "model/raw_frame.h"

namespace mikromakro {

/// Makes a frame of bytes that were taken out of the files before; reads no file and shares nothing that
/// changes, so that several threads may do it for several frames.
using UnpackFrame = std::function<void(RawFrame&)>;

/// One of the formats: text dumps, HDF5 snapshots, MercuryDPM files.
class FrameFormat {
 public:
  FrameFormat() = default;
  FrameFormat(const FrameFormat&) = delete;
  FrameFormat& operator=(const FrameFormat&) = delete;
  virtual ~FrameFormat() = default;

  /// Goes to the next frame; false at the end.
  virtual bool next(std::int64_t& step) = 0;
  /// Takes the bytes of the frame that `next` has found; may be left out to skip it. `closely`: with all
  /// columns of contacts that can be checked, whether they are needed or not.
  virtual UnpackFrame take(bool closely = false) = 0;
  /// The run of that frame, from 0.
  virtual std::int64_t run() const { return 0; }
  /// How many rows of contacts it has, all files together; -1 where only its rows tell.
  virtual std::int64_t contact_rows() const { return -1; }
  /// For the progress bar.
  virtual std::int64_t bytes_read() const = 0;
};

}  // namespace mikromakro
