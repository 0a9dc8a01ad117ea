// SPDX-License-Identifier: GPL-2.0-or-later
// Reads the lines of a text file, plain or compressed with gzip or zstd, in blocks.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/byte_source.h"
#include "model/error.h"

namespace mikromakro {

/// Reads one file line by line; compression is recognised by content, not by name. A UTF-8 byte order mark
/// before the first line is skipped.
/// Throws (bad input) if the file cannot be opened or decompressed, if a line is longer than 16 MB (binary
/// data), and if the last line has no line end (a truncated file: its last number could be wrong and still
/// look right). If the compressed data are truncated, the lines before that are returned and cut() is true.
class LineReader {
 public:
  explicit LineReader(const std::string& file);

  /// The next line without its end (LF or CRLF), valid until the next call; false at the end of the file.
  bool next(std::string_view& line);

  /// At the end: whether the compressed data were truncated. A line without end is then dropped.
  bool cut() const { return ended_ && source_->cut(); }

  /// Whether all lines have been read.
  bool at_end() const { return ended_ && begin_ == end_; }

  /// Appends the next lines verbatim, line ends included: `count` of them, fewer at the end of the file and
  /// before a line that starts with `stop`. Returns their number.
  std::int64_t take(std::int64_t count, std::string_view stop, std::string& text);

  const std::string& file() const { return file_; }
  std::int64_t line() const { return line_; }
  Place place() const { return {file_, line_}; }

  /// Bytes of the (compressed) file read so far.
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
  bool ended_ = false;   ///< the source is exhausted
  bool marked_ = false;  ///< a byte order mark was skipped
};

}  // namespace mikromakro
