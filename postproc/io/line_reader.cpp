#include "io/line_reader.h"

#include <zlib.h>

#include <cerrno>
#include <cstring>

namespace mikromakro {
namespace {

constexpr std::size_t block_size = std::size_t{1} << 20;
constexpr std::size_t longest_line = std::size_t{1} << 24;

gzFile as_gz(void* stream) {
  return static_cast<gzFile>(stream);
}

}  // namespace

void LineReader::Close::operator()(void* stream) const {
  gzclose(as_gz(stream));
}

LineReader::LineReader(const std::string& file) : file_(file), buffer_(block_size) {
  stream_.reset(gzopen(file.c_str(), "rb"));
  if (!stream_) throw bad_input({file}, "cannot open the file", "a readable file", std::strerror(errno));
  gzbuffer(as_gz(stream_.get()), 1U << 18U);
}

std::int64_t LineReader::bytes_read() const {
  return gzoffset(as_gz(stream_.get()));
}

bool LineReader::next(std::string_view& line) {
  std::size_t searched = 0;
  while (true) {
    const char* start = buffer_.data() + begin_;
    const void* found = std::memchr(start + searched, '\n', end_ - begin_ - searched);
    if (found != nullptr) {
      std::size_t length = static_cast<const char*>(found) - start;
      begin_ += length + 1;
      ++line_;
      if (length > 0 && start[length - 1] == '\r') --length;
      line = {start, length};
      return true;
    }
    searched = end_ - begin_;
    if (!refill()) break;
  }
  if (begin_ == end_) return false;
  throw bad_input({file_, line_ + 1}, "the file ends within a line", "a line end after the last line",
                  in_quotes({buffer_.data() + begin_, end_ - begin_}));
}

bool LineReader::refill() {
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  if (end_ == buffer_.size()) {
    if (end_ >= longest_line)
      throw bad_input({file_, line_ + 1}, "the line is too long", "lines of text",
                      "more than 16 MB without an end");
    buffer_.resize(2 * buffer_.size());
  }
  const int got =
      gzread(as_gz(stream_.get()), buffer_.data() + end_, static_cast<unsigned>(buffer_.size() - end_));
  int code = Z_OK;
  const char* reason = gzerror(as_gz(stream_.get()), &code);
  if (got < 0 || (code != Z_OK && code != Z_STREAM_END)) {
    throw bad_input({file_, line_ + 1}, "cannot read on", "plain text or a complete gzip file",
                    code == Z_ERRNO ? std::strerror(errno) : reason);
  }
  end_ += static_cast<std::size_t>(got);
  return got > 0;
}

}  // namespace mikromakro
