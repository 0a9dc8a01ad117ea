// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/packed_bytes.h"

#include <zlib.h>

#include <array>

#include "model/error.h"

namespace mikromakro {

struct Deflated::Stream {
  z_stream z = {};

  // Writes what there is of compressed bytes to `packed`.
  void run(int flush, std::string& packed) {
    std::array<char, 1 << 16> buffer;
    do {
      z.next_out = reinterpret_cast<Bytef*>(buffer.data());
      z.avail_out = buffer.size();
      deflate(&z, flush);
      packed.append(buffer.data(), buffer.size() - z.avail_out);
    } while (z.avail_out == 0);
  }
};

Deflated::Deflated() : stream_(std::make_unique<Stream>()) {
  if (deflateInit(&stream_->z, Z_BEST_COMPRESSION) != Z_OK)
    throw run_failed("cannot compress", "memory for zlib", "none");
}

Deflated::~Deflated() {
  deflateEnd(&stream_->z);
}

void Deflated::add(std::string_view bytes) {
  // zlib's interface is not const-correct
  stream_->z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream_->z.avail_in = static_cast<uInt>(bytes.size());
  stream_->run(Z_NO_FLUSH, packed_);
}

std::string Deflated::finish() {
  stream_->run(Z_FINISH, packed_);
  return std::move(packed_);
}

void append_planes(std::span<const std::uint16_t> numbers, std::string& bytes) {
  for (const std::uint16_t number : numbers) bytes += static_cast<char>(number & 0xFFU);
  for (const std::uint16_t number : numbers) bytes += static_cast<char>(number >> 8U);
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t at) {
      return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0U;
    };
    const std::uint32_t triple = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : letters[triple >> (18 - 6 * k) & 63U];
  }
  return text;
}

}  // namespace mikromakro
