// SPDX-License-Identifier: GPL-2.0-or-later
// The library's only exception type: a message 'FILE:LINE: what; expected ..., got ...' and the kind of
// failure.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace mikromakro {

/// Location in the input; line 0 means the file (or option) as a whole. A view: it must not outlive the name
/// it refers to.
struct Place {
  std::string_view file;
  std::int64_t line = 0;
};

class Error : public std::runtime_error {
 public:
  enum class Kind { bad_input, run_failed, steps_come_again };

  Error(Kind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}

  /// Bad input must be corrected by the user (exit code 2); a failed run is no fault of the input (exit code
  /// 1). On steps_come_again the input is read again with FrameSource::look_through.
  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

/// `text` on one line of at most `longest` bytes, not counting escapes: control characters as \x1b, text that
/// is too long is shortened in the middle.
std::string one_line(std::string_view text, std::size_t longest);

/// Create errors whose message is one line of bounded length; the offending value is quoted, with unprintable
/// characters as '?', and shortened if long.
Error bad_input(const Place& place, std::string_view what, std::string_view expected, std::string_view got);
Error run_failed(std::string_view what, std::string_view expected, std::string_view got);

/// 'text' in quotes, on one line, at most 40 characters, printable ones only.
std::string in_quotes(std::string_view text);

}  // namespace mikromakro
