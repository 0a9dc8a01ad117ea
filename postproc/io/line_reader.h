// Lines of a text file, plain or compressed by gzip or zstd, read in blocks.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/byte_source.h"
#include "io/error.h"

namespace mikromakro {

/// Reads one file line by line; whether it is compressed is seen from its content, not from its name.
/// Throws (bad input): the file cannot be opened or decompressed, a line is longer than 16 MB (binary junk),
/// the last line has no end (a cut file: its last number could be wrong without looking wrong).
class LineReader {
 public:
  explicit LineReader(const std::string& file);

  /// The next line without its end (LF or CRLF), valid until the next call; false at the end of the file.
  bool next(std::string_view& line);

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
};

}  // namespace mikromakro
