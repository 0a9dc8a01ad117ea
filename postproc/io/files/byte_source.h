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

  /// Fills `room` as far as there is something, 0 at the end. Throws, naming `place`, when the file is
  /// damaged.
  virtual std::size_t read(std::span<char> room, const Place& place) = 0;
  /// Whether the compressed data ended before their end, so that what was read is not all.
  virtual bool cut() const { return false; }
  /// Bytes of the (compressed) file that were read so far.
  virtual std::int64_t bytes_read() const = 0;
};

/// gzip, zstd or plain: seen from the content, not from the name. Throws when the file cannot be opened, is
/// no regular file (files are opened more than once, which a pipe would not survive), or is of a kind that is
/// known and not read (file_kind.h).
std::unique_ptr<ByteSource> open_bytes(const std::string& file);

}  // namespace mikromakro
