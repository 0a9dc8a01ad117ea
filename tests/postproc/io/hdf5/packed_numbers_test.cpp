// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/hdf5/packed_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>

#include "model/error.h"

namespace mikromakro {
namespace {

// Words with the sum behind them, one after the other as HDF5's description of the filter has it.
std::vector<char> with_sum(std::vector<char> bytes) {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const auto high = static_cast<unsigned char>(bytes[i]);
    const auto low = static_cast<unsigned char>(bytes[i + 1]);
    first = (first + 256U * high + low) % 65535;
    second = (second + first) % 65535;
  }
  const std::uint32_t sum = second << 16U | first;
  for (unsigned shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(sum >> shift & 255U));
  return bytes;
}

std::vector<char> random_bytes(std::size_t count) {
  std::mt19937 random(static_cast<unsigned>(count));
  std::vector<char> bytes(count);
  for (char& byte : bytes) byte = static_cast<char>(random() & 255U);
  return bytes;
}

// Around the lanes and the blocks of the sum, with and without words left over.
const std::vector<std::size_t> lengths = {0,    2,    8,    14,   16,   18,    30,   32,
                                          4094, 4096, 4098, 4112, 8192, 12300, 40000};

TEST(Fletcher32, IsTheSumWordByWord) {
  for (const std::size_t length : lengths)
    EXPECT_TRUE(fletcher32_fits(with_sum(random_bytes(length)))) << length;
}

TEST(Fletcher32, LargestWordsOverflowNothing) {
  // All bits set is 0 here, so that one of the bits is taken from each word.
  for (const std::size_t length : lengths) {
    std::vector<char> bytes(length, '\xff');
    for (std::size_t i = 0; i < length; i += 2) bytes[i] = '\xfe';
    EXPECT_TRUE(fletcher32_fits(with_sum(bytes))) << length;
  }
}

TEST(Fletcher32, NoticesEveryFlippedBitAndSwappedWords) {
  const auto right = with_sum(random_bytes(4130));
  for (std::size_t i = 0; i < right.size(); ++i) {
    auto wrong = right;
    wrong[i] = static_cast<char>(wrong[i] ^ static_cast<char>(1U << i % 8));
    EXPECT_FALSE(fletcher32_fits(wrong)) << "byte " << i;
  }
  for (std::size_t i = 0; i + 20 < right.size() - 4; i += 2) {
    auto wrong = right;
    std::swap_ranges(wrong.begin() + static_cast<std::ptrdiff_t>(i),
                     wrong.begin() + static_cast<std::ptrdiff_t>(i) + 2,
                     wrong.begin() + static_cast<std::ptrdiff_t>(i) + 18);
    if (wrong == right) continue;
    EXPECT_FALSE(fletcher32_fits(wrong)) << "byte " << i;
  }
}

std::shared_ptr<const PackedChunk> chunk_of(const std::vector<double>& numbers) {
  const std::size_t size = numbers.size() * sizeof(double);
  auto bytes = std::make_unique<char[]>(size);
  std::memcpy(bytes.get(), numbers.data(), size);
  return std::make_shared<const PackedChunk>(std::move(bytes), size, false, "test");
}

TEST(PackedNumbers, AreUnpackedFromAnyPlaceOverAllPieces) {
  PackedNumbers packed;
  packed.append(chunk_of({0, 1, 2, 3, 4}), 2, 3);
  packed.append(chunk_of({5}), 0, 1);
  packed.append(chunk_of({6, 7, 8}), 0, 2);
  const std::vector<double> all = {2, 3, 4, 5, 6, 7};
  ASSERT_EQ(packed.size(), all.size());
  for (std::size_t first = 0; first <= all.size(); ++first) {
    for (std::size_t count = 0; first + count <= all.size(); ++count) {
      std::vector<double> numbers(count);
      packed.unpack(first, numbers);
      for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(numbers[i], all[first + i]);
    }
  }
}

}  // namespace
}  // namespace mikromakro
