#include "io/packed_numbers.h"

#include <algorithm>
#include <cstring>

#include "io/error.h"

namespace mikromakro {
namespace {

constexpr std::size_t number_size = 8;
constexpr std::size_t sum_size = 4;
constexpr std::uint64_t modulus = 65535;

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
  // Within a block nothing overflows 32 bits, so that the compiler can use vectors: 255 * 65535 * 256 / 2.
  constexpr std::size_t longest = 256;
  for (std::size_t begin = 0; begin < words; begin += longest) {
    const std::size_t count = std::min(longest, words - begin);
    std::uint32_t sum = 0;
    std::uint32_t moment = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      std::uint16_t word;
      std::memcpy(&word, bytes.data() + 2 * (begin + i), sizeof word);
      sum += word;
      moment += i * word;
    }
    second = (second + count * (first + sum) - moment) % modulus;
    first = (first + sum) % modulus;
  }
  // 2^16 is 1 here, so that a word with its bytes swapped is 256 times the word.
  first = first * 256 % modulus;
  second = second * 256 % modulus;
  std::uint32_t stored = 0;
  std::memcpy(&stored, bytes.data() + 2 * words, sizeof stored);
  return (stored & 0xffffU) % modulus == first && (stored >> 16U) % modulus == second;
}

const char* PackedChunk::numbers() const {
  if (summed_) std::call_once(once_, [this] { fits_ = fletcher32_fits({bytes_.get(), size_}); });
  if (!fits_) throw bad_input({place_}, "the file is damaged", "numbers that fit their sum", "others");
  return bytes_.get();
}

void PackedNumbers::append(std::shared_ptr<const PackedChunk> chunk, std::size_t begin, std::size_t count) {
  pieces_.push_back({std::move(chunk), begin, count});
  size_ += count;
}

template <typename Number>
void PackedNumbers::unpack_as(std::span<Number> numbers) const {
  for (const Piece& piece : pieces_) {
    const char* const from = piece.chunk->numbers() + piece.begin * number_size;
    const auto to = numbers.first(piece.count);
    kind_ == Kind::real ? convert<double>(from, to) : convert<std::int64_t>(from, to);
    numbers = numbers.subspan(piece.count);
  }
}

void PackedNumbers::unpack(std::span<double> numbers) const {
  unpack_as(numbers);
}

void PackedNumbers::unpack(std::span<std::int64_t> numbers) const {
  unpack_as(numbers);
}

}  // namespace mikromakro
