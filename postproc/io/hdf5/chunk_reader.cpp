// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/hdf5/chunk_reader.h"

#include <hdf5.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <span>
#include <vector>

#include "io/hdf5/hdf5_turn.h"
#include "model/error.h"

namespace mikromakro {
namespace {

constexpr std::size_t number_size = 8;
constexpr std::size_t sum_size = 4;

std::uint64_t product(const Hdf5Shape& shape) {
  return std::accumulate(shape.begin(), shape.end(), std::uint64_t{1}, std::multiplies<>());
}

// Shape of the chunks if they hold unmodified numbers with a trailing checksum; empty for others.
Hdf5Shape summed_chunks(const Hdf5Dataset& dataset, const Hdf5Shape& shape) {
  const Hdf5Id list(H5Dget_create_plist(dataset.id()), H5Pclose);
  if (H5Pget_layout(list.get()) != H5D_CHUNKED || H5Pget_nfilters(list.get()) != 1) return {};
  unsigned flags = 0;
  std::size_t values = 0;
  unsigned info = 0;
  const H5Z_filter_t filter = H5Pget_filter2(list.get(), 0, &flags, &values, nullptr, 0, nullptr, &info);
  std::vector<hsize_t> chunk(shape.size());
  if (filter != H5Z_FILTER_FLETCHER32 ||
      H5Pget_chunk(list.get(), static_cast<int>(chunk.size()), chunk.data()) < 0)
    return {};
  return {chunk.begin(), chunk.end()};
}

// Reads the raw chunk. Bits of `left_out`: filters that were not applied.
herr_t read_chunk(hid_t dataset, const std::vector<hsize_t>& offset, std::uint32_t& left_out,
                  std::span<char> bytes) {
#if H5_VERSION_GE(2, 0, 0)
  std::size_t size = bytes.size();
  return H5Dread_chunk(dataset, H5P_DEFAULT, offset.data(), &left_out, bytes.data(), &size);
#else
  return H5Dread_chunk(dataset, H5P_DEFAULT, offset.data(), &left_out, bytes.data());
#endif
}

}  // namespace

ChunkReader::ChunkReader(Hdf5Dataset dataset) : dataset_(std::move(dataset)) {
  const Hdf5Turn turn;
  const Hdf5Shape shape = dataset_.shape();
  axis_ = shape.size() == 1 ? 0 : 1;
  places_ = shape.size() > 1 ? shape[1] : 0;
  per_place_ = shape.size() == 3 ? shape[2] : 1;
  const Hdf5Id type(H5Dget_type(dataset_.id()), H5Tclose);
  const bool real = H5Tequal(type.get(), H5T_NATIVE_DOUBLE) > 0;
  const bool integer = H5Tequal(type.get(), H5T_NATIVE_INT64) > 0;
  if (H5Tget_class(type.get()) == H5T_INTEGER) kind_ = PackedNumbers::Kind::integer;
  if (!real && !integer) return;
  const Hdf5Shape chunk = summed_chunks(dataset_, shape);
  // One row per chunk, and no place split between chunks.
  const bool fits =
      !chunk.empty() && (axis_ == 0 || chunk[0] == 1) && (shape.size() < 3 || chunk[2] == shape[2]);
  if (fits) chunk_ = chunk;
}

PackedNumbers ChunkReader::take(std::uint64_t begin, std::uint64_t count) {
  return take_block({{begin}, {count}});
}

PackedNumbers ChunkReader::take_row(std::uint64_t row, std::uint64_t count) {
  return take_block(per_place_ == 1 ? Hdf5Block{{row, 0}, {1, count}}
                                    : Hdf5Block{{row, 0, 0}, {1, count, per_place_}});
}

PackedNumbers ChunkReader::take_block(const Hdf5Block& block) {
  PackedNumbers numbers(kind_);
  if (product(block.count) == 0) return numbers;
  if (chunk_.empty() || chunk_.size() != block.count.size()) {
    numbers.append(read_block(block), 0, product(block.count));
    return numbers;
  }
  const std::uint64_t begin = block.begin[axis_];
  const std::uint64_t end = begin + block.count[axis_];
  const std::uint64_t length = chunk_[axis_];
  for (std::uint64_t at = begin; at < end;) {
    Hdf5Shape corner = block.begin;
    corner[axis_] = at / length * length;
    const std::uint64_t stop = std::min<std::uint64_t>(end, corner[axis_] + length);
    if (const auto chunk = chunk_at(corner)) {
      numbers.append(chunk, (at - corner[axis_]) * per_place_, (stop - at) * per_place_);
    } else {
      Hdf5Block part = block;
      part.begin[axis_] = at;
      part.count[axis_] = stop - at;
      numbers.append(read_block(part), 0, product(part.count));
    }
    at = stop;
  }
  return numbers;
}

// Null if the chunk was never written, or has no checksum.
std::shared_ptr<const PackedChunk> ChunkReader::chunk_at(const Hdf5Shape& corner) {
  if (last_ && last_corner_ == corner) return last_;
  const Hdf5Turn turn;
  const std::vector<hsize_t> offset(corner.begin(), corner.end());
  hsize_t size = 0;
  const std::uint64_t expected = product(chunk_) * number_size + sum_size;
  if (H5Dget_chunk_storage_size(dataset_.id(), offset.data(), &size) < 0 || size != expected) return nullptr;
  auto bytes = std::make_unique_for_overwrite<char[]>(size);
  std::uint32_t left_out = 0;
  if (read_chunk(dataset_.id(), offset, left_out, std::span(bytes.get(), size)) < 0 || left_out != 0)
    return nullptr;
  last_corner_ = corner;
  last_ = std::make_shared<const PackedChunk>(std::move(bytes), size, true, dataset_.place());
  return last_;
}

std::shared_ptr<const PackedChunk> ChunkReader::read_block(const Hdf5Block& block) const {
  const std::size_t count = product(block.count);
  auto bytes = std::make_unique_for_overwrite<char[]>(count * number_size);
  if (kind_ == PackedNumbers::Kind::real) {
    dataset_.read<double>(block, {reinterpret_cast<double*>(bytes.get()), count});
  } else {
    dataset_.read<std::int64_t>(block, {reinterpret_cast<std::int64_t*>(bytes.get()), count});
  }
  return std::make_shared<const PackedChunk>(std::move(bytes), count * number_size, false, dataset_.place());
}

}  // namespace mikromakro
