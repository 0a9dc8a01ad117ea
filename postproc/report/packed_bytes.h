// SPDX-License-Identifier: GPL-2.0-or-later
// Binary data as text within a page.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace mikromakro {

/// Compresses bytes as they come (zlib format, RFC 1950).
class Deflated {
 public:
  Deflated();
  ~Deflated();
  Deflated(const Deflated&) = delete;
  Deflated& operator=(const Deflated&) = delete;

  void add(std::string_view bytes);
  /// All of them; nothing can be added afterwards.
  std::string finish();

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
  std::string packed_;
};

/// Appends 16-bit numbers, the lower bytes of all of them first: the upper ones are alike and compress well.
void append_planes(std::span<const std::uint16_t> numbers, std::string& bytes);

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

}  // namespace mikromakro
