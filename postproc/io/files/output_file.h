// SPDX-License-Identifier: GPL-2.0-or-later
// Output files that are written completely or not at all.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace mikromakro {

/// Writes to a temporary file in the same directory and renames it on commit; an uncommitted file leaves
/// nothing behind. A symbolic link is kept and its target is replaced. Files that are not regular (pipes,
/// devices) are written to directly. Throws on names that cannot be written (bad input) and on a full disk
/// (failed run).
class OutputFile {
 public:
  explicit OutputFile(const std::string& file);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void commit(std::string_view content);
  /// The same for content that is written piece by piece.
  void commit(const std::function<void(std::ostream&)>& write);

  /// For libraries that write files themselves: they write to `temporary`, then `publish` renames it.
  const std::string& temporary() const { return temporary_; }
  void publish();
  /// Throws if the file has no temporary name because it is a pipe or a device.
  void require_regular() const;

 private:
  bool is_replaced() const { return temporary_ != target_; }
  [[noreturn]] void fail() const;

  std::string file_;
  std::string target_;     // `file_` with symbolic links resolved
  std::string temporary_;  // the target itself if that is not a regular file
};

/// Throws if an output is also an input, or if two outputs are the same file, under whatever names or links:
/// the input would be overwritten. "-" is standard output.
void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

/// Removes the temporary files of this process; safe in signal handlers.
void remove_unfinished_outputs() noexcept;

}  // namespace mikromakro
