// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers as stored in an HDF5 file: read, but not yet verified and decoded.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace mikromakro {

/// Whether `bytes` end with their Fletcher-32 checksum as written by HDF5's filter: over big-endian 16-bit
/// words, modulo 65535, stored little-endian (HDF5 File Format Specification, filter 3).
bool fletcher32_fits(std::span<const char> bytes);

/// One raw HDF5 chunk: 8-byte numbers in native byte order, with a trailing Fletcher-32 checksum if `summed`.
/// May be shared by several frames.
class PackedChunk {
 public:
  PackedChunk(std::unique_ptr<char[]> bytes, std::size_t size, bool summed, std::string place)
      : bytes_(std::move(bytes)), size_(size), summed_(summed), place_(std::move(place)) {}

  /// The numbers, after verifying the checksum (once, by the first caller; thread-safe). Throws on a checksum
  /// mismatch.
  const char* numbers() const;

 private:
  std::unique_ptr<char[]> bytes_;
  std::size_t size_;
  bool summed_;
  std::string place_;
  mutable std::once_flag once_;
  mutable bool fits_ = true;
};

/// A range of numbers in a dataset, in one or several chunks. Any thread may unpack it.
class PackedNumbers {
 public:
  enum class Kind { real, integer };

  explicit PackedNumbers(Kind kind = Kind::real) : kind_(kind) {}
  void append(std::shared_ptr<const PackedChunk> chunk, std::size_t begin, std::size_t count);

  std::size_t size() const { return size_; }
  /// The numbers from index `first` on. Throws if the chunk is damaged.
  void unpack(std::size_t first, std::span<double> numbers) const;
  void unpack(std::size_t first, std::span<std::int64_t> numbers) const;
  /// The same numbers without a copy; empty if they must be unpacked. Throws if the chunk is damaged.
  std::span<const double> in_place(std::size_t first, std::size_t count) const;

 private:
  struct Piece {
    std::shared_ptr<const PackedChunk> chunk;
    std::size_t begin, count;
  };
  template <typename Number>
  void unpack_as(std::size_t first, std::span<Number> numbers) const;

  Kind kind_;
  std::vector<Piece> pieces_;
  std::size_t size_ = 0;
};

}  // namespace mikromakro
