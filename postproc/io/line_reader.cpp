#include "io/line_reader.h"

#include <cstring>

namespace mikromakro {
namespace {

constexpr std::size_t block_size = std::size_t{1} << 20;
constexpr std::size_t longest_line = std::size_t{1} << 24;

}  // namespace

LineReader::LineReader(const std::string& file)
    : file_(file), source_(open_bytes(file)), buffer_(block_size) {}

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
  const std::size_t got = source_->read({buffer_.data() + end_, buffer_.size() - end_}, {file_, line_ + 1});
  end_ += got;
  return got > 0;
}

}  // namespace mikromakro
