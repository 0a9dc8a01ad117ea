// SPDX-License-Identifier: GPL-2.0-or-later
// Lines of a text file, plain or compressed by gzip or zstd, read in blocks.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/byte_source.h"
#include "model/error.h"

namespace mikromakro {

/// Reads one file line by line; whether it is compressed is seen from its content, not from its name.
/// A mark of the byte order (UTF-8) before the first line is skipped.
/// Throws (bad input): the file cannot be opened or decompressed, a line is longer than 16 MB (binary junk),
/// the last line has no end (a cut file: its last number could be wrong without looking wrong). Where the
/// compressed data end early, what stands before is given, and cut() tells it.
class LineReader {
 public:
  explicit LineReader(const std::string& file);

  /// The next line without its end (LF or CRLF), valid until the next call; false at the end of the file.
  bool next(std::string_view& line);

  /// At the end: whether the compressed data ended before their end. A line without end is left out then.
  bool cut() const { return ended_ && source_->cut(); }

  /// Whether the end of the file has been met: nothing is left.
  bool at_end() const { return ended_ && begin_ == end_; }

  /// Appends the next lines as they stand, ends included: `count` of them, fewer at the end of the file and
  /// before a line that starts with `stop`. Gives how many.
  std::int64_t take(std::int64_t count, std::string_view stop, std::string& text);

  const std::string& file() const { return file_; }
  std::int64_t line() const { return line_; }
  Place place() const { return {file_, line_}; }

  /// Bytes of the (compressed) file that were read so far.
  std::int64_t bytes_read() const { return source_->bytes_read(); }

 private:
  bool refill();
  void check_end() const;

  std::string file_;
  std::unique_ptr<ByteSource> source_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::int64_t line_ = 0;
  bool ended_ = false;   ///< no more bytes came
  bool marked_ = false;  ///< the mark of the byte order was there
};

}  // namespace mikromakro
