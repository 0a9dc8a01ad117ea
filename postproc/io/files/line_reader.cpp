// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/files/line_reader.h"

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
  check_end();
  return false;
}

std::int64_t LineReader::take(std::int64_t count, std::string_view stop, std::string& text) {
  const std::int64_t first = line_;
  for (bool stopped = false; !stopped && line_ - first < count;) {
    const char* const from = buffer_.data() + begin_;
    const char* const end = buffer_.data() + end_;
    const char* at = from;
    while (line_ - first < count) {
      stopped = std::string_view(at, static_cast<std::size_t>(end - at)).starts_with(stop);
      const void* found =
          stopped || at == end ? nullptr : std::memchr(at, '\n', static_cast<std::size_t>(end - at));
      if (found == nullptr) break;
      at = static_cast<const char*>(found) + 1;
      ++line_;
    }
    text.append(from, at);
    begin_ += static_cast<std::size_t>(at - from);
    if (!stopped && line_ - first < count && !refill()) {
      check_end();
      break;
    }
  }
  return line_ - first;
}

void LineReader::check_end() const {
  if (begin_ == end_ || cut()) return;
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
  ended_ = got == 0;
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (line_ == 0 && std::string_view(buffer_.data(), end_).starts_with(byte_order_mark) && !marked_) {
    begin_ += byte_order_mark.size();
    marked_ = true;
  }
  return got > 0;
}

}  // namespace mikromakro
