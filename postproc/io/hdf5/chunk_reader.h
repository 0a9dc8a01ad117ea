// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers out of an HDF5 dataset, chunk by chunk, with as little as possible done while others wait.
#pragma once

#include "io/hdf5/hdf5_file.h"
#include "io/hdf5/packed_numbers.h"

namespace mikromakro {

/// Takes runs of numbers that are checked and decoded later, by other threads: HDF5 itself works on one
/// thread at a time, and its own sums and conversions are several times slower than reading. Datasets that
/// are stored in another way than ours (compressed, other types, other chunks) are read by HDF5 with all that
/// belongs to it. The last chunk is kept, for the frame that begins where another has ended.
class ChunkReader {
 public:
  ChunkReader() = default;
  /// 1, 2 or 3 dimensions. Throws what cannot be read.
  explicit ChunkReader(Hdf5Dataset dataset);

  /// Of each row, where there are two or three dimensions.
  std::uint64_t places() const { return places_; }

  /// The numbers of a dataset of one dimension from `begin` on.
  PackedNumbers take(std::uint64_t begin, std::uint64_t count);
  /// The first numbers of a row of a dataset of two or three dimensions: those of `count` places.
  PackedNumbers take_row(std::uint64_t row, std::uint64_t count);

 private:
  PackedNumbers take_block(const Hdf5Block& block);
  std::shared_ptr<const PackedChunk> chunk_at(const Hdf5Shape& corner);
  std::shared_ptr<const PackedChunk> read_block(const Hdf5Block& block) const;

  Hdf5Dataset dataset_;
  std::uint64_t places_ = 0;
  std::size_t axis_ = 0;         // the dimension along which is read
  std::uint64_t per_place_ = 1;  // numbers for each place along it
  PackedNumbers::Kind kind_ = PackedNumbers::Kind::real;
  Hdf5Shape chunk_;  // empty: HDF5 has to read
  Hdf5Shape last_corner_;
  std::shared_ptr<const PackedChunk> last_;
};

}  // namespace mikromakro
