// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/files/byte_source.h"

#include <zlib.h>
#include <zstd.h>

#include <algorithm>
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

// Members are inflated one by one: gzread would silently drop any data after the last one.
class GzipSource : public ByteSource {
 public:
  explicit GzipSource(OpenFile file) : file_(std::move(file)), packed_(std::size_t{1} << 18U) {
    constexpr int gzip_only = 16;
    if (inflateInit2(&stream_, MAX_WBITS + gzip_only) != Z_OK)
      throw Error(Error::Kind::run_failed, "no memory to inflate a gzip file");
  }
  ~GzipSource() override { inflateEnd(&stream_); }

  std::size_t read(std::span<char> room, const Place& place) override {
    stream_.next_out = reinterpret_cast<Bytef*>(room.data());
    stream_.avail_out = static_cast<uInt>(room.size());
    while (stream_.avail_out > 0) {
      const bool more = stream_.avail_in > 0 || refill(place);
      if (!within_member_ && !more) break;
      if (!within_member_ && !begin_member(place)) continue;
      const int code = inflate(&stream_, Z_NO_FLUSH);
      // At the end of a truncated file the decoder may still hold output.
      if (code == Z_BUF_ERROR && !more) break;
      if (code == Z_STREAM_END) within_member_ = false;
      if (code != Z_OK && code != Z_STREAM_END) complain(place, code);
    }
    return room.size() - stream_.avail_out;
  }

  std::int64_t bytes_read() const override { return bytes_ - stream_.avail_in; }
  bool cut() const override { return within_member_ && stream_.avail_in == 0 && std::feof(file_.get()) != 0; }

 private:
  bool refill(const Place& place) {
    const std::size_t got = std::fread(packed_.data(), 1, packed_.size(), file_.get());
    if (got == 0 && std::ferror(file_.get()) != 0)
      throw bad_input(place, "cannot read on", "a readable file", std::strerror(errno));
    bytes_ += static_cast<std::int64_t>(got);
    stream_.next_in = packed_.data();
    stream_.avail_in = static_cast<uInt>(got);
    return got > 0;
  }

  // False if everything read so far is zeros: tapes pad their blocks with zeros, which gzip ignores.
  bool begin_member(const Place& place) {
    Bytef* const end = stream_.next_in + stream_.avail_in;
    if (members_ > 0 && *stream_.next_in == 0) padded_ = true;
    if (padded_) {
      Bytef* const other = std::find_if(stream_.next_in, end, [](Bytef byte) { return byte != 0; });
      if (other != end) complain_of_rest(place, "zeros followed by data");
      stream_.avail_in = 0;
      return false;
    }
    constexpr Bytef first_of_mark = 0x1f;
    if (members_ > 0 && *stream_.next_in != first_of_mark) complain_of_rest(place, "other data");
    if (members_++ > 0) inflateReset(&stream_);
    within_member_ = true;
    return true;
  }

  [[noreturn]] static void complain_of_rest(const Place& place, std::string_view got) {
    throw bad_input({place.file},
                    "the file continues after its gzip data (files joined by cat: compress each, or none)",
                    "gzip data up to the end of the file", got);
  }

  [[noreturn]] void complain(const Place& place, int code) const {
    constexpr uLong mark = 2;
    if (members_ > 1 && code == Z_DATA_ERROR && stream_.total_in <= mark)
      complain_of_rest(place, "other data");
    throw bad_input(place, "cannot read on", "plain text or a complete gzip file",
                    stream_.msg != nullptr ? stream_.msg : zError(code));
  }

  OpenFile file_;
  std::vector<Bytef> packed_;
  z_stream stream_ = {};
  std::int64_t bytes_ = 0, members_ = 0;
  bool within_member_ = false;
  bool padded_ = false;  ///< zero padding has begun after the last member
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
      return std::make_unique<GzipSource>(std::move(opened));
    case Packing::zstd:
      return std::make_unique<ZstdSource>(std::move(opened));
    case Packing::none:
      break;
  }
  check_kind({begin.data(), got}, file);
  return std::make_unique<PlainSource>(std::move(opened));
}

}  // namespace mikromakro
