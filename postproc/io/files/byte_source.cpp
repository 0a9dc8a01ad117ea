// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/files/byte_source.h"

#include <zlib.h>
#include <zstd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <vector>

#include "io/files/file_kind.h"

namespace mikromakro {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

OpenFile open_file(const std::string& file) {
  check_regular(file);
  OpenFile opened(std::fopen(file.c_str(), "rb"));
  if (!opened) throw bad_input({file}, "cannot open the file", "a readable file", std::strerror(errno));
  return opened;
}

class PlainSource : public ByteSource {
 public:
  // Unbuffered, since the requested blocks are large.
  explicit PlainSource(OpenFile file) : file_(std::move(file)) {}

  std::size_t read(std::span<char> room, const Place& place) override {
    const std::size_t got = std::fread(room.data(), 1, room.size(), file_.get());
    if (got == 0 && std::ferror(file_.get()) != 0)
      throw bad_input(place, "cannot read on", "a readable file", std::strerror(errno));
    bytes_ += static_cast<std::int64_t>(got);
    return got;
  }

  std::int64_t bytes_read() const override { return bytes_; }

 private:
  OpenFile file_;
  std::int64_t bytes_ = 0;
};

class GzipSource : public ByteSource {
 public:
  explicit GzipSource(const std::string& file) : stream_(gzopen(file.c_str(), "rb")) {
    if (!stream_) throw bad_input({file}, "cannot open the file", "a readable file", std::strerror(errno));
    gzbuffer(stream_.get(), 1U << 18U);
  }

  std::size_t read(std::span<char> room, const Place& place) override {
    const int got = gzread(stream_.get(), room.data(), static_cast<unsigned>(room.size()));
    int code = Z_OK;
    const char* reason = gzerror(stream_.get(), &code);
    // zlib >= 1.3.2 reports the cut once, before it hands out the last bytes.
    const bool cut_now = got >= 0 && code == Z_BUF_ERROR;
    cut_ = cut_ || cut_now;
    if (cut_now) return static_cast<std::size_t>(got);
    if (got < 0 || (code != Z_OK && code != Z_STREAM_END)) {
      throw bad_input(place, "cannot read on", "plain text or a complete gzip file",
                      code == Z_ERRNO ? std::strerror(errno) : reason);
    }
    return static_cast<std::size_t>(got);
  }

  std::int64_t bytes_read() const override { return gzoffset(stream_.get()); }
  bool cut() const override { return cut_; }

 private:
  struct Close {
    void operator()(gzFile stream) const { gzclose(stream); }
  };
  std::unique_ptr<gzFile_s, Close> stream_;
  bool cut_ = false;
};

class ZstdSource : public ByteSource {
 public:
  explicit ZstdSource(OpenFile file)
      : file_(std::move(file)), stream_(ZSTD_createDStream()), packed_(ZSTD_DStreamInSize()) {}

  std::size_t read(std::span<char> room, const Place& place) override {
    ZSTD_outBuffer out{room.data(), room.size(), 0};
    while (out.pos == 0) {
      const bool more = in_.pos < in_.size || refill();
      if (!more && wanted_ == 0) return 0;
      // At the end of a truncated file the decoder may still hold output.
      wanted_ = ZSTD_decompressStream(stream_.get(), &out, &in_);
      if (ZSTD_isError(wanted_) != 0) complain(place, ZSTD_getErrorName(wanted_));
      if (!more && out.pos == 0) return 0;
    }
    return out.pos;
  }

  std::int64_t bytes_read() const override { return bytes_; }
  // The zstd frame needs more bytes.
  bool cut() const override { return wanted_ != 0 && in_.pos == in_.size && std::feof(file_.get()) != 0; }

 private:
  bool refill() {
    const std::size_t got = std::fread(packed_.data(), 1, packed_.size(), file_.get());
    bytes_ += static_cast<std::int64_t>(got);
    in_ = {packed_.data(), got, 0};
    return got > 0;
  }

  [[noreturn]] static void complain(const Place& place, const char* reason) {
    throw bad_input(place, "cannot read on", "a complete zstd file", reason);
  }

  struct Free {
    void operator()(ZSTD_DStream* stream) const { ZSTD_freeDStream(stream); }
  };
  OpenFile file_;
  std::unique_ptr<ZSTD_DStream, Free> stream_;
  std::vector<char> packed_;
  ZSTD_inBuffer in_{nullptr, 0, 0};
  std::size_t wanted_ = 0;
  std::int64_t bytes_ = 0;
};

}  // namespace

std::unique_ptr<ByteSource> open_bytes(const std::string& file) {
  OpenFile opened = open_file(file);
  std::array<char, 64> begin = {};
  const std::size_t got = std::fread(begin.data(), 1, begin.size(), opened.get());
  std::rewind(opened.get());
  switch (packing_of({begin.data(), got})) {
    case Packing::gzip:
      return std::make_unique<GzipSource>(file);
    case Packing::zstd:
      return std::make_unique<ZstdSource>(std::move(opened));
    case Packing::none:
      break;
  }
  check_kind({begin.data(), got}, file);
  return std::make_unique<PlainSource>(std::move(opened));
}

}  // namespace mikromakro
