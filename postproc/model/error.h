// SPDX-License-Identifier: GPL-2.0-or-later
// The one exception type of the library: a message 'FILE:LINE: what; expected ..., got ...' and whose fault
// it is.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace mikromakro {

/// Where in the input something was found; line 0 means the file (or option) as a whole. A view: it must not
/// outlive the name it was made of.
struct Place {
  std::string_view file;
  std::int64_t line = 0;
};

class Error : public std::runtime_error {
 public:
  enum class Kind { bad_input, run_failed, steps_come_again };

  Error(Kind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}

  /// Bad input is the user's to mend (exit code 2), a failed run is not (exit code 1). Input whose steps come
  /// again is read once more, with FrameSource::look_through.
  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

/// `text` on one line of at most `longest` bytes, escapes not counted: control characters as \x1b, what is
/// too long cut in the middle.
std::string one_line(std::string_view text, std::size_t longest);

/// Makers of the message, which stays one line of bounded length; what was found is quoted with unprintable
/// characters as '?', and cut when it is long.
Error bad_input(const Place& place, std::string_view what, std::string_view expected, std::string_view got);
Error run_failed(std::string_view what, std::string_view expected, std::string_view got);

/// 'text' in quotes, on one line, in printable characters only, at most 40 of them.
std::string in_quotes(std::string_view text);

}  // namespace mikromakro
