// SPDX-License-Identifier: GPL-2.0-or-later
// The little of HDF5 that our files need; the library's own header is seen by hdf5_file.cpp
// and chunk_reader.cpp only.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace mikromakro {

/// An open object of HDF5, closed at the end of its life.
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
    if (id_ >= 0) close_(id_);
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

/// Lengths along the dimensions, in HDF5's own type of numbers.
using Hdf5Shape = std::vector<unsigned long long>;

/// Kind of numbers in a file. In memory they are double, std::int64_t, std::uint8_t.
enum class Hdf5Type { real, integer, byte };
template <typename T>
inline constexpr Hdf5Type hdf5_type = Hdf5Type::real;
template <>
inline constexpr Hdf5Type hdf5_type<std::int64_t> = Hdf5Type::integer;
template <>
inline constexpr Hdf5Type hdf5_type<std::uint8_t> = Hdf5Type::byte;

/// A block of a dataset: where it begins, and how far it goes along each dimension.
struct Hdf5Block {
  Hdf5Shape begin;
  Hdf5Shape count;
};

/// Throws: what cannot be read is bad input, what cannot be written a failed run.
class Hdf5Dataset {
 public:
  Hdf5Dataset() = default;
  Hdf5Dataset(Hdf5Id id, std::string place) : id_(std::move(id)), place_(std::move(place)) {}

  Hdf5Shape shape() const;
  /// For messages.
  const std::string& place() const { return place_; }
  std::int64_t id() const { return id_.get(); }
  /// Whether the file has whole numbers there.
  bool is_whole() const;
  /// Nothing where there is no attribute of this name.
  std::optional<std::vector<std::string>> text_attribute(const std::string& name) const;
  void grow(const Hdf5Shape& shape);
  /// Grows where it is shorter than `shape`, along each dimension; gives its new lengths.
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

/// HDF5 writes what it still holds when a program ends, and crashes where the disk is full. Programs that
/// close all their files call this first, before anything else of HDF5.
void leave_hdf5_open_at_exit();

/// Paths are absolute, groups on the way are made. HDF5's own messages never reach stderr.
class Hdf5File {
 public:
  /// Throws when it cannot be made or is no complete HDF5 file.
  /// `paged`: what HDF5 writes about its datasets lies within pages of 4096 bytes, none across two. The
  /// system copies a write page by page, and a process that is killed between two pages would leave a wrong
  /// sum there.
  static Hdf5File create(const std::string& file, bool paged = false);
  /// To read, also while somebody appends to it or after he was killed while he did.
  static Hdf5File open(const std::string& file);
  /// To append to the datasets that are there, by one process, while others may read (HDF5's "single writer,
  /// multiple readers"): what is flushed stays readable whenever the process is killed. `mend`: also where a
  /// process that was killed has left the file marked as being written.
  static Hdf5File open_to_append(const std::string& file, bool mend);
  /// Whether a file begins as HDF5 files do; false also for a file that cannot be read.
  static bool recognises(const std::string& file);

  /// Throws where that cannot be read.
  bool has(const std::string& path) const;

  /// A dataset that grows (in every dimension); `chunk` is what is stored together, `checked` by a sum of its
  /// own, so that flipped bits are found. `fill`: what places hold that were never written, for integers.
  Hdf5Dataset add_growing(const std::string& path, Hdf5Type type, const Hdf5Shape& chunk,
                          std::int64_t fill = 0, bool checked = true);
  Hdf5Dataset dataset(const std::string& path) const;
  template <typename T>
  void add(const std::string& path, std::span<const T> numbers, const Hdf5Shape& shape) {
    Hdf5Dataset made = add_fixed(path, hdf5_type<T>, shape);
    if (!numbers.empty()) made.write<T>({Hdf5Shape(shape.size(), 0), shape}, numbers);
  }
  void add_group(const std::string& path);
  /// A second name for the same object.
  void link(const std::string& existing, const std::string& path);

  /// What stands there in another file, with all below it.
  void copy(const Hdf5File& from, const std::string& path);

  void attribute(const std::string& path, const std::string& name, const std::string& value);
  void attribute(const std::string& path, const std::string& name, const std::vector<std::string>& values);
  void attribute(const std::string& path, const std::string& name, std::span<const std::int64_t> numbers);
  void attribute(const std::string& path, const std::string& name, std::int64_t number);
  /// A word that averages read. Most programs want words of any length, but HDF5 keeps these where no sum
  /// protects them, and crashes or hangs where they are damaged. So the word is there twice: marked (zeros as
  /// the padding, which words of any length never have), and as NAME_guarded, of fixed length, which
  /// text_attribute() reads in place of a marked one. Who replaces the word takes the mark away.
  void guarded_attribute(const std::string& path, const std::string& name, const std::string& value);
  bool has_attribute(const std::string& path, const std::string& name) const;
  /// Fixed-length ASCII, as VTK wants it.
  void short_attribute(const std::string& path, const std::string& name, const std::string& value);
  std::vector<std::string> text_attribute(const std::string& path, const std::string& name) const;
  /// Whether two paths lead to one object.
  bool are_one(const std::string& path, const std::string& other) const;
  std::vector<std::int64_t> number_attribute(const std::string& path, const std::string& name) const;

  /// Hands everything over to the operating system, metadata after the numbers that they point to.
  void flush();
  /// Writes everything out; to be called before the file is renamed.
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
