// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/hdf5/hdf5_file.h"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <numeric>
#include <thread>

#include "io/files/file_kind.h"
#include "io/hdf5/hdf5_calls.h"
#include "io/hdf5/hdf5_turn.h"
#include "model/error.h"

namespace mikromakro {
namespace {

void silence() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

hid_t in_memory(Hdf5Type type) {
  if (type == Hdf5Type::integer) return H5T_NATIVE_INT64;
  return type == Hdf5Type::byte ? H5T_NATIVE_UINT8 : H5T_NATIVE_DOUBLE;
}

hid_t in_file(Hdf5Type type) {
  if (type == Hdf5Type::integer) return H5T_STD_I64LE;
  return type == Hdf5Type::byte ? H5T_STD_U8LE : H5T_IEEE_F64LE;
}

// The file format of 1.10: its metadata have checksums, so damage is detected, and files can be appended to
// while others read them.
Hdf5Id newer_layout() {
  Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  // A reader alongside a writer retries on a checksum mismatch, after 1 ns, 2 ns, 4 ns...: a write in
  // progress completes within these 2^20 ns, 1 ms. The library's default of 100 attempts would hang forever
  // on a damaged file.
  H5Pset_metadata_read_attempts(access.get(), 20);
  H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110);
  return access;
}

// H5Fclose of a file whose data cannot be written aborts if HDF5 was built with assertions (Debian's 2.2):
// such a file is left open.
int close_written(std::int64_t id) {
  const int flushed = H5Fflush(id, H5F_SCOPE_GLOBAL);
  return flushed < 0 ? flushed : H5Fclose(id);
}

// Also opens files that a killed process has left marked as open, or with a recorded length shorter than what
// it wrote: the repair of `h5clear --status --increment=0`. Opens in single-writer mode from the start, so
// that a kill during the repair is harmless too.
Hdf5Id open_after_kill(const std::string& file, const Hdf5Id& access) {
  const hbool_t yes = 1;
  H5Pset(access.get(), "clear_status_flags", &yes);
  H5Pset(access.get(), "skip_eof_check", &yes);
  Hdf5Id id(H5Fopen(file.c_str(), H5F_ACC_RDWR | H5F_ACC_SWMR_WRITE, access.get()), close_written);
  if (id.get() >= 0 && H5Fincrement_filesize(id.get(), 0) < 0) cannot_write(file);
  return id;
}

// Checks the flags of the superblock, present from version 3 on (HDF5 File Format Specification, II.A).
bool is_open_for_write(const std::string& file) {
  constexpr std::size_t version_at = 8, flags_at = 11;
  std::array<char, flags_at + 1> superblock{};
  std::ifstream(file, std::ios::binary).read(superblock.data(), superblock.size());
  return superblock[version_at] >= 3 && (superblock[flags_at] & 1) != 0;
}

// Creation properties without timestamps: the same content always gives the same file.
Hdf5Id without_times(hid_t kind) {
  Hdf5Id list(H5Pcreate(kind), H5Pclose);
  H5Pset_obj_track_times(list.get(), false);
  return list;
}

}  // namespace

void leave_hdf5_open_at_exit() {
  H5dont_atexit();
}

bool Hdf5Dataset::is_whole() const {
  const Hdf5Turn turn;
  const Hdf5Id type(H5Dget_type(id_.get()), H5Tclose);
  return H5Tget_class(type.get()) == H5T_INTEGER;
}

Hdf5Shape Hdf5Dataset::shape() const {
  const Hdf5Turn turn;
  const Hdf5Id space(H5Dget_space(id_.get()), H5Sclose);
  std::array<hsize_t, H5S_MAX_RANK> lengths = {};
  const int rank = H5Sget_simple_extent_dims(space.get(), lengths.data(), nullptr);
  if (rank < 0) cannot_read(place_);
  return {lengths.begin(), lengths.begin() + rank};
}

void Hdf5Dataset::grow(const Hdf5Shape& shape) {
  const Hdf5Turn turn;
  if (H5Dset_extent(id_.get(), sizes(shape).data()) < 0)
    throw run_failed(fmt::format("{}: cannot be extended", place_),
                     "space on the disk, and a dataset that may grow (written by mikromakro)", last_reason());
}

Hdf5Shape Hdf5Dataset::reach(const Hdf5Shape& shape) {
  const Hdf5Turn turn;
  Hdf5Shape lengths = this->shape();
  const Hdf5Shape before = lengths;
  for (std::size_t i = 0; i < shape.size(); ++i) lengths[i] = std::max(lengths[i], shape[i]);
  if (lengths != before) grow(lengths);
  return lengths;
}

Hdf5Id Hdf5Dataset::select(const Hdf5Block& block, Hdf5Id& in_memory) const {
  const Hdf5Turn turn;
  Hdf5Id space(H5Dget_space(id_.get()), H5Sclose);
  if (H5Sget_simple_extent_ndims(space.get()) != static_cast<int>(block.count.size())) return {};
  if (H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, sizes(block.begin).data(), nullptr,
                          sizes(block.count).data(), nullptr) < 0)
    return {};
  in_memory = space_of(block.count);
  return space;
}

void Hdf5Dataset::read_raw(const Hdf5Block& block, Hdf5Type type, void* numbers, std::size_t size) const {
  const Hdf5Turn turn;
  const std::uint64_t wanted =
      std::accumulate(block.count.begin(), block.count.end(), std::uint64_t{1}, std::multiplies<>());
  if (wanted == 0) return;
  Hdf5Id memory;
  const Hdf5Id space = select(block, memory);
  if (space.get() < 0 || wanted != size ||
      H5Dread(id_.get(), in_memory(type), memory.get(), space.get(), H5P_DEFAULT, numbers) < 0)
    cannot_read(place_);
}

void Hdf5Dataset::write_raw(const Hdf5Block& block, Hdf5Type type, const void* numbers) {
  const Hdf5Turn turn;
  Hdf5Id memory;
  const Hdf5Id space = select(block, memory);
  if (space.get() < 0 ||
      H5Dwrite(id_.get(), in_memory(type), memory.get(), space.get(), H5P_DEFAULT, numbers) < 0)
    cannot_write(place_);
}

Hdf5File Hdf5File::create(const std::string& file, bool paged) {
  const Hdf5Turn turn;
  silence();
  const Hdf5Id list = without_times(H5P_FILE_CREATE);
  if (paged) H5Pset_file_space_strategy(list.get(), H5F_FSPACE_STRATEGY_PAGE, false, 1);
  Hdf5Id id(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, list.get(), newer_layout().get()), close_written);
  if (id.get() < 0) cannot_write(file);
  return {std::move(id), file};
}

Hdf5File Hdf5File::open(const std::string& file) {
  const Hdf5Turn turn;
  silence();
  // Open as a reader alongside a writer; files of other programs may have a format without that mode. The
  // open fails if a writer changes the file meanwhile, so it is retried for a second.
  for (int attempt = 1;; ++attempt) {
    Hdf5Id id(H5Fopen(file.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, newer_layout().get()), H5Fclose);
    if (id.get() < 0) id = Hdf5Id(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (id.get() >= 0) return {std::move(id), file};
    if (!is_open_for_write(file) || attempt == 100) cannot_read(file);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

Hdf5File Hdf5File::open_to_append(const std::string& file, bool mend) {
  const Hdf5Turn turn;
  silence();
  const Hdf5Id access = newer_layout();
  // A reader, such as a notebook with the file open, must not block the writer.
  H5Pset_file_locking(access.get(), 0, 1);
  Hdf5Id id(H5Fopen(file.c_str(), H5F_ACC_RDWR | H5F_ACC_SWMR_WRITE, access.get()), close_written);
  if (id.get() < 0 && mend) id = open_after_kill(file, access);
  if (id.get() < 0) cannot_write(file);
  return {std::move(id), file};
}

bool Hdf5File::has(const std::string& path) const {
  const Hdf5Turn turn;
  for (std::size_t slash = path.find('/', 1);; slash = path.find('/', slash + 1)) {
    const htri_t there = H5Lexists(id_.get(), path.substr(0, slash).c_str(), H5P_DEFAULT);
    if (there < 0) cannot_read(file_);
    if (there == 0) return false;
    if (slash == std::string::npos) return true;
  }
}

Hdf5Dataset Hdf5File::add_growing(const std::string& path, Hdf5Type type, const Hdf5Shape& chunk,
                                  std::int64_t fill, bool checked, bool packed) {
  const Hdf5Turn turn;
  add_groups_above(path);
  const std::vector<hsize_t> none(chunk.size(), 0);
  const std::vector<hsize_t> any(chunk.size(), H5S_UNLIMITED);
  const int rank = static_cast<int>(chunk.size());
  const Hdf5Id space(H5Screate_simple(rank, none.data(), any.data()), H5Sclose);
  const Hdf5Id list = without_times(H5P_DATASET_CREATE);
  H5Pset_chunk(list.get(), rank, sizes(chunk).data());
  constexpr unsigned quick = 1;
  if (packed) {
    H5Pset_shuffle(list.get());
    H5Pset_deflate(list.get(), quick);
  }
  if (checked) H5Pset_fletcher32(list.get());
  if (type == Hdf5Type::integer) H5Pset_fill_value(list.get(), H5T_NATIVE_INT64, &fill);
  Hdf5Id id(
      H5Dcreate2(id_.get(), path.c_str(), in_file(type), space.get(), H5P_DEFAULT, list.get(), H5P_DEFAULT),
      H5Dclose);
  if (id.get() < 0) cannot_write(file_);
  return {std::move(id), fmt::format("{}:{}", file_, path)};
}

Hdf5Dataset Hdf5File::add_fixed(const std::string& path, Hdf5Type type, const Hdf5Shape& shape) {
  const Hdf5Turn turn;
  add_groups_above(path);
  const Hdf5Id space = space_of(shape);
  Hdf5Id id(H5Dcreate2(id_.get(), path.c_str(), in_file(type), space.get(), H5P_DEFAULT,
                       without_times(H5P_DATASET_CREATE).get(), H5P_DEFAULT),
            H5Dclose);
  if (id.get() < 0) cannot_write(file_);
  return {std::move(id), fmt::format("{}:{}", file_, path)};
}

Hdf5Dataset Hdf5File::dataset(const std::string& path) const {
  const Hdf5Turn turn;
  Hdf5Id id(H5Dopen2(id_.get(), path.c_str(), H5P_DEFAULT), H5Dclose);
  if (id.get() < 0) cannot_read(fmt::format("{}:{}", file_, path));
  return {std::move(id), fmt::format("{}:{}", file_, path)};
}

// Intermediate groups that HDF5 creates itself would have timestamps.
void Hdf5File::add_groups_above(const std::string& path) {
  const Hdf5Turn turn;
  const std::size_t slash = path.rfind('/');
  if (slash != std::string::npos && slash > 0 && !has(path.substr(0, slash)))
    add_group(path.substr(0, slash));
}

void Hdf5File::add_group(const std::string& path) {
  const Hdf5Turn turn;
  add_groups_above(path);
  const Hdf5Id id(
      H5Gcreate2(id_.get(), path.c_str(), H5P_DEFAULT, without_times(H5P_GROUP_CREATE).get(), H5P_DEFAULT),
      H5Gclose);
  if (id.get() < 0) cannot_write(file_);
}

void Hdf5File::link(const std::string& existing, const std::string& path) {
  const Hdf5Turn turn;
  add_groups_above(path);
  if (H5Lcreate_hard(id_.get(), existing.c_str(), id_.get(), path.c_str(), H5P_DEFAULT, H5P_DEFAULT) < 0)
    cannot_write(file_);
}

void Hdf5File::copy(const Hdf5File& from, const std::string& path) {
  const Hdf5Turn turn;
  if (H5Ocopy(from.id_.get(), path.c_str(), id_.get(), path.c_str(), H5P_DEFAULT, H5P_DEFAULT) < 0)
    cannot_write(file_);
}

bool Hdf5File::are_one(const std::string& path, const std::string& other) const {
  const Hdf5Turn turn;
#if H5_VERSION_GE(1, 12, 0)
  H5O_info2_t one{}, two{};
  int difference = 0;
  return H5Oget_info_by_name3(id_.get(), path.c_str(), &one, H5O_INFO_BASIC, H5P_DEFAULT) >= 0 &&
         H5Oget_info_by_name3(id_.get(), other.c_str(), &two, H5O_INFO_BASIC, H5P_DEFAULT) >= 0 &&
         one.fileno == two.fileno && H5Otoken_cmp(id_.get(), &one.token, &two.token, &difference) >= 0 &&
         difference == 0;
#else
  H5O_info_t one{}, two{};
  return H5Oget_info_by_name2(id_.get(), path.c_str(), &one, H5O_INFO_BASIC, H5P_DEFAULT) >= 0 &&
         H5Oget_info_by_name2(id_.get(), other.c_str(), &two, H5O_INFO_BASIC, H5P_DEFAULT) >= 0 &&
         one.fileno == two.fileno && one.addr == two.addr;
#endif
}

void Hdf5File::flush() {
  const Hdf5Turn turn;
  if (H5Fflush(id_.get(), H5F_SCOPE_GLOBAL) < 0) cannot_write(file_);
}

void Hdf5File::close() {
  const Hdf5Turn turn;
  flush();
  id_ = Hdf5Id();
}

bool Hdf5File::recognises(const std::string& file) {
  const Hdf5Turn turn;
  check_regular(file);
  silence();
  return H5Fis_hdf5(file.c_str()) > 0;
}

}  // namespace mikromakro
