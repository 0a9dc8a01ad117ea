// The bytes of a file, plain or decompressed.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "io/error.h"

namespace mikromakro {

class ByteSource {
 public:
  ByteSource() = default;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;
  virtual ~ByteSource() = default;

  /// Fills `room` as far as there is something, 0 at the end. Throws, naming `place`, when the file is cut or
  /// damaged.
  virtual std::size_t read(std::span<char> room, const Place& place) = 0;
  /// Bytes of the (compressed) file that were read so far.
  virtual std::int64_t bytes_read() const = 0;
};

/// gzip, zstd or plain: seen from the content, not from the name. Throws when the file cannot be opened.
std::unique_ptr<ByteSource> open_bytes(const std::string& file);

}  // namespace mikromakro
