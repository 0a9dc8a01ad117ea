// SPDX-License-Identifier: GPL-2.0-or-later
// The part of HDF5 that our files need. The library's own header is included by hdf5_file.cpp and
// chunk_reader.cpp only.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/hdf5/hdf5_turn.h"

namespace mikromakro {

/// RAII handle of an HDF5 object.
class Hdf5Id {
 public:
  using Close = int (*)(std::int64_t);

  Hdf5Id() = default;
  Hdf5Id(std::int64_t id, Close close) : id_(id), close_(close) {}
  Hdf5Id(Hdf5Id&& other) noexcept { swap(other); }
  Hdf5Id& operator=(Hdf5Id&& other) noexcept {
    swap(other);
    return *this;
  }
  ~Hdf5Id() {
    if (id_ < 0) return;
    const Hdf5Turn turn;
    close_(id_);
  }

  std::int64_t get() const { return id_; }

 private:
  void swap(Hdf5Id& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
  }

  std::int64_t id_ = -1;
  Close close_ = nullptr;
};

/// Lengths along the dimensions, in the integer type of HDF5.
using Hdf5Shape = std::vector<unsigned long long>;

/// Type of the numbers in a file; in memory double, std::int64_t, std::uint8_t.
enum class Hdf5Type { real, integer, byte };
template <typename T>
inline constexpr Hdf5Type hdf5_type = Hdf5Type::real;
template <>
inline constexpr Hdf5Type hdf5_type<std::int64_t> = Hdf5Type::integer;
template <>
inline constexpr Hdf5Type hdf5_type<std::uint8_t> = Hdf5Type::byte;

/// A block of a dataset: start and length along each dimension.
struct Hdf5Block {
  Hdf5Shape begin;
  Hdf5Shape count;
};

/// Throws bad input on failure to read, and a failed run on failure to write.
class Hdf5Dataset {
 public:
  Hdf5Dataset() = default;
  Hdf5Dataset(Hdf5Id id, std::string place) : id_(std::move(id)), place_(std::move(place)) {}

  Hdf5Shape shape() const;
  /// For messages.
  const std::string& place() const { return place_; }
  std::int64_t id() const { return id_.get(); }
  /// Whether the file stores integers.
  bool is_whole() const;
  /// Empty if there is no attribute of this name.
  std::optional<std::vector<std::string>> text_attribute(const std::string& name) const;
  void grow(const Hdf5Shape& shape);
  /// Extends each dimension that is shorter than in `shape`; returns the new lengths.
  Hdf5Shape reach(const Hdf5Shape& shape);

  template <typename T>
  void read(const Hdf5Block& block, std::span<T> numbers) const {
    read_raw(block, hdf5_type<T>, numbers.data(), numbers.size());
  }
  template <typename T>
  void write(const Hdf5Block& block, std::span<const T> numbers) {
    write_raw(block, hdf5_type<T>, numbers.data());
  }

 private:
  void read_raw(const Hdf5Block& block, Hdf5Type type, void* numbers, std::size_t size) const;
  void write_raw(const Hdf5Block& block, Hdf5Type type, const void* numbers);
  Hdf5Id select(const Hdf5Block& block, Hdf5Id& in_memory) const;

  Hdf5Id id_;
  std::string place_;
};

/// At exit HDF5 writes the data it still holds, and crashes if the disk is full. Programs that close all
/// their files call this before any other use of HDF5.
void leave_hdf5_open_at_exit();

/// Paths are absolute; missing groups are created. HDF5's own messages never reach stderr.
class Hdf5File {
 public:
  /// Throws if the file cannot be created. `paged`: HDF5 metadata stay within pages of 4096 bytes, never
  /// across two. The system copies a write page by page, so a process killed between two pages would
  /// otherwise leave a wrong checksum.
  static Hdf5File create(const std::string& file, bool paged = false);
  /// Opens for reading, also while a process appends to the file or after such a process was killed. Throws
  /// if it is not a complete HDF5 file.
  static Hdf5File open(const std::string& file);
  /// Opens for appending to existing datasets by one process while others may read (HDF5's "single writer,
  /// multiple readers"): flushed data stay readable whenever the process is killed. `mend`: also if a killed
  /// process has left the file marked as being written.
  static Hdf5File open_to_append(const std::string& file, bool mend);
  /// Whether a file has the HDF5 signature; false also for a file that cannot be read.
  static bool recognises(const std::string& file);

  /// Throws if this cannot be determined.
  bool has(const std::string& path) const;

  /// Adds a dataset that can grow in every dimension; `chunk` is the HDF5 chunk shape, `checked` adds a
  /// checksum per chunk, so that flipped bits are detected. `fill`: value of integers never written.
  /// `packed`: compressed by zlib, for files that other programs read (ChunkReader does not).
  Hdf5Dataset add_growing(const std::string& path, Hdf5Type type, const Hdf5Shape& chunk,
                          std::int64_t fill = 0, bool checked = true, bool packed = false);
  Hdf5Dataset dataset(const std::string& path) const;
  template <typename T>
  void add(const std::string& path, std::span<const T> numbers, const Hdf5Shape& shape) {
    Hdf5Dataset made = add_fixed(path, hdf5_type<T>, shape);
    if (!numbers.empty()) made.write<T>({Hdf5Shape(shape.size(), 0), shape}, numbers);
  }
  void add_group(const std::string& path);
  /// A second name for the same object.
  void link(const std::string& existing, const std::string& path);

  /// Copies an object from another file, with everything below it.
  void copy(const Hdf5File& from, const std::string& path);

  void attribute(const std::string& path, const std::string& name, const std::string& value);
  void attribute(const std::string& path, const std::string& name, const std::vector<std::string>& values);
  void attribute(const std::string& path, const std::string& name, std::span<const std::int64_t> numbers);
  void attribute(const std::string& path, const std::string& name, std::int64_t number);
  /// A string that averages rely on. Most programs expect variable-length strings, but HDF5 stores these
  /// without a checksum, and crashes or hangs if they are damaged. The string is therefore stored twice: as a
  /// marked variable-length one (null padding, which ordinary variable-length strings never have), and as
  /// NAME_guarded, of fixed length, which text_attribute() reads in place of a marked one. Replacing the
  /// string removes the mark.
  void guarded_attribute(const std::string& path, const std::string& name, const std::string& value);
  bool has_attribute(const std::string& path, const std::string& name) const;
  /// Fixed-length ASCII, as required by VTK.
  void short_attribute(const std::string& path, const std::string& name, const std::string& value);
  std::vector<std::string> text_attribute(const std::string& path, const std::string& name) const;
  /// Whether two paths refer to the same object.
  bool are_one(const std::string& path, const std::string& other) const;
  std::vector<std::int64_t> number_attribute(const std::string& path, const std::string& name) const;

  /// Passes everything to the operating system, metadata after the data that they point to.
  void flush();
  /// Writes everything out; call before renaming the file.
  void close();

 private:
  void add_groups_above(const std::string& path);
  Hdf5File(Hdf5Id id, std::string file) : id_(std::move(id)), file_(std::move(file)) {}
  Hdf5Dataset add_fixed(const std::string& path, Hdf5Type type, const Hdf5Shape& shape);
  void add_attribute(const std::string& path, const std::string& name, const Hdf5Id& space, std::int64_t type,
                     const void* value);

  Hdf5Id id_;
  std::string file_;
};

}  // namespace mikromakro
