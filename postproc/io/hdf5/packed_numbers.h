// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers as they lie in an HDF5 file: read, but not yet checked and decoded.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace mikromakro {

/// Whether `bytes` end with their Fletcher-32 sum as HDF5's filter writes it: over big-endian words of 16
/// bits, modulo 65535, stored as a little-endian number (HDF5 File Format Specification, filter 3).
bool fletcher32_fits(std::span<const char> bytes);

/// What HDF5 stores together: numbers of 8 bytes in the machine's order, where `summed` with their sum behind
/// them. Several frames may have a part in it.
class PackedChunk {
 public:
  PackedChunk(std::unique_ptr<char[]> bytes, std::size_t size, bool summed, std::string place)
      : bytes_(std::move(bytes)), size_(size), summed_(summed), place_(std::move(place)) {}

  /// The numbers, after their sum was checked (once, whoever asks). Throws where it does not fit.
  const char* numbers() const;

 private:
  std::unique_ptr<char[]> bytes_;
  std::size_t size_;
  bool summed_;
  std::string place_;
  mutable std::once_flag once_;
  mutable bool fits_ = true;
};

/// A run of numbers in a dataset, on one or several chunks. May be unpacked by any thread.
class PackedNumbers {
 public:
  enum class Kind { real, integer };

  explicit PackedNumbers(Kind kind = Kind::real) : kind_(kind) {}
  void append(std::shared_ptr<const PackedChunk> chunk, std::size_t begin, std::size_t count);

  std::size_t size() const { return size_; }
  /// The numbers from number `first` on. Throws where the chunk is damaged.
  void unpack(std::size_t first, std::span<double> numbers) const;
  void unpack(std::size_t first, std::span<std::int64_t> numbers) const;
  /// The same numbers where they lie; empty where they must be unpacked. Throws where the chunk is damaged.
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
