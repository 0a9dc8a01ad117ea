// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/hdf5/packed_numbers.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "model/error.h"

namespace mikromakro {
namespace {

constexpr std::size_t number_size = 8;
constexpr std::size_t sum_size = 4;
constexpr std::uint64_t modulus = 65535;

using Pairs = std::uint32_t __attribute__((vector_size(16)));  // of words; one vector register
constexpr std::size_t lanes = sizeof(Pairs) / sizeof(std::uint16_t);

template <typename From, typename To>
void convert(const char* from, std::span<To> to) {
  for (std::size_t i = 0; i < to.size(); ++i) {
    From number;
    std::memcpy(&number, from + i * number_size, number_size);
    to[i] = static_cast<To>(number);
  }
}

}  // namespace

bool fletcher32_fits(std::span<const char> bytes) {
  if (bytes.size() < sum_size || bytes.size() % 2 != 0) return false;
  const std::size_t words = (bytes.size() - sum_size) / 2;
  std::uint64_t first = 0;   // sum of the words
  std::uint64_t second = 0;  // sum of the sums
  // Split into lanes, to vectorise without multiplications: lane l takes the words l, l + lanes, ... of a
  // block of n words; word i counts n - i = lanes (rows - row) - l times in the sum of sums. 32 bits do not
  // overflow: 65535 * 256 * 257 / 2.
  constexpr std::size_t most_rows = 256;
  const std::size_t whole_rows = words / lanes;
  for (std::size_t begin = 0; begin < whole_rows; begin += most_rows) {
    const std::size_t rows = std::min(most_rows, whole_rows - begin);
    std::array<Pairs, 2> sum{};
    std::array<Pairs, 2> sum_of_sums{};
    for (std::size_t row = 0; row < rows; ++row) {
      Pairs pairs;
      std::memcpy(&pairs, bytes.data() + sizeof pairs * (begin + row), sizeof pairs);
      sum[0] += pairs & 0xffffU;
      sum[1] += pairs >> 16U;
      sum_of_sums[0] += sum[0];
      sum_of_sums[1] += sum[1];
    }
    second += lanes * rows * first;
    for (std::size_t l = 0; l < lanes; ++l) {
      const std::uint64_t sum_of_lane = sum[l % 2][l / 2];
      first += sum_of_lane;
      second += lanes * std::uint64_t{sum_of_sums[l % 2][l / 2]} - l * sum_of_lane;
    }
    first %= modulus;
    second %= modulus;
  }
  for (std::size_t i = lanes * whole_rows; i < words; ++i) {
    std::uint16_t word = 0;
    std::memcpy(&word, bytes.data() + 2 * i, sizeof word);
    first += word;
    second += first;
  }
  // 2^16 is 1 modulo 65535, so swapping the bytes of a word multiplies it by 256.
  first = first % modulus * 256 % modulus;
  second = second % modulus * 256 % modulus;
  std::uint32_t stored = 0;
  std::memcpy(&stored, bytes.data() + 2 * words, sizeof stored);
  return (stored & 0xffffU) % modulus == first && (stored >> 16U) % modulus == second;
}

const char* PackedChunk::numbers() const {
  if (summed_) std::call_once(once_, [this] { fits_ = fletcher32_fits({bytes_.get(), size_}); });
  if (!fits_) throw bad_input({place_}, "the file is damaged", "numbers that match their checksum", "others");
  return bytes_.get();
}

void PackedNumbers::append(std::shared_ptr<const PackedChunk> chunk, std::size_t begin, std::size_t count) {
  pieces_.push_back({std::move(chunk), begin, count});
  size_ += count;
}

template <typename Number>
void PackedNumbers::unpack_as(std::size_t first, std::span<Number> numbers) const {
  for (const Piece& piece : pieces_) {
    if (numbers.empty()) return;
    if (first >= piece.count) {
      first -= piece.count;
      continue;
    }
    const std::size_t count = std::min(piece.count - first, numbers.size());
    const char* const from = piece.chunk->numbers() + (piece.begin + first) * number_size;
    kind_ == Kind::real ? convert<double>(from, numbers.first(count))
                        : convert<std::int64_t>(from, numbers.first(count));
    numbers = numbers.subspan(count);
    first = 0;
  }
}

std::span<const double> PackedNumbers::in_place(std::size_t first, std::size_t count) const {
  if (kind_ != Kind::real) return {};
  for (const Piece& piece : pieces_) {
    if (first >= piece.count) {
      first -= piece.count;
      continue;
    }
    if (count > piece.count - first) return {};
    // The allocation of a chunk is aligned for any number.
    return {reinterpret_cast<const double*>(piece.chunk->numbers()) + piece.begin + first, count};
  }
  return {};
}

void PackedNumbers::unpack(std::size_t first, std::span<double> numbers) const {
  unpack_as(first, numbers);
}

void PackedNumbers::unpack(std::size_t first, std::span<std::int64_t> numbers) const {
  unpack_as(first, numbers);
}

}  // namespace mikromakro
