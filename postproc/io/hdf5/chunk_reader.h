// SPDX-License-Identifier: GPL-2.0-or-later
// Reads numbers from an HDF5 dataset chunk by chunk, with as little work as possible in the serial part.
#pragma once

#include "io/hdf5/hdf5_file.h"
#include "io/hdf5/packed_numbers.h"

namespace mikromakro {

/// Takes ranges of numbers to be verified and decoded later by other threads: HDF5 is limited to one thread
/// at a time. (On one thread, H5Dread of a whole column takes about as long, see reading_bench.) Datasets
/// stored differently from ours (compressed, other types, other chunks) are read through HDF5 with its whole
/// filter pipeline. The last chunk is cached for the frame that starts where the previous one ended.
class ChunkReader {
 public:
  ChunkReader() = default;
  /// 1, 2 or 3 dimensions. Throws if the dataset cannot be read.
  explicit ChunkReader(Hdf5Dataset dataset);

  /// Places per row, for two or three dimensions.
  std::uint64_t places() const { return places_; }

  /// Numbers `begin` to `begin + count` of a one-dimensional dataset.
  PackedNumbers take(std::uint64_t begin, std::uint64_t count);
  /// The numbers of the first `count` places of a row of a two- or three-dimensional dataset.
  PackedNumbers take_row(std::uint64_t row, std::uint64_t count);

 private:
  PackedNumbers take_block(const Hdf5Block& block);
  std::shared_ptr<const PackedChunk> chunk_at(const Hdf5Shape& corner);
  std::shared_ptr<const PackedChunk> read_block(const Hdf5Block& block) const;

  Hdf5Dataset dataset_;
  std::uint64_t places_ = 0;
  std::size_t axis_ = 0;         // the dimension along which to read
  std::uint64_t per_place_ = 1;  // numbers per place along it
  PackedNumbers::Kind kind_ = PackedNumbers::Kind::real;
  Hdf5Shape chunk_;  // empty: read through HDF5
  Hdf5Shape last_corner_;
  std::shared_ptr<const PackedChunk> last_;
};

}  // namespace mikromakro
