// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/files/spool.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <ostream>

#include "model/error.h"

namespace mikromakro {
namespace {

[[noreturn]] void fail() {
  throw run_failed("cannot write a temporary file", "space on the disk of temporary files",
                   std::strerror(errno));
}

}  // namespace

Spool::Spool() : file_(std::tmpfile()) {
  if (!file_) fail();
}

void Spool::add(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) fail();
}

void Spool::copy_to(std::ostream& stream) {
  if (std::fflush(file_.get()) != 0) fail();
  std::rewind(file_.get());
  std::array<char, 1 << 16> part{};
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), file_.get()))
    stream.write(part.data(), static_cast<std::streamsize>(size));
  if (std::ferror(file_.get()) != 0) fail();
  std::fseek(file_.get(), 0, SEEK_END);
}

}  // namespace mikromakro
