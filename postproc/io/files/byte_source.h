// SPDX-License-Identifier: GPL-2.0-or-later
// The bytes of a file, plain or decompressed.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "model/error.h"

namespace mikromakro {

class ByteSource {
 public:
  ByteSource() = default;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;
  virtual ~ByteSource() = default;

  /// Fills `room` as far as possible and returns the number of bytes, 0 at the end. Throws, naming `place`,
  /// if the file is damaged.
  virtual std::size_t read(std::span<char> room, const Place& place) = 0;
  /// Whether the compressed data were truncated, so that what was read is incomplete.
  virtual bool cut() const { return false; }
  /// Bytes of the (compressed) file read so far.
  virtual std::int64_t bytes_read() const = 0;
};

/// Opens gzip, zstd or plain files, recognised by content, not by name. Throws if the file cannot be opened,
/// is not a regular file (files are opened more than once, which does not work for a pipe), or is of a known
/// but unsupported kind (file_kind.h).
std::unique_ptr<ByteSource> open_bytes(const std::string& file);

}  // namespace mikromakro
