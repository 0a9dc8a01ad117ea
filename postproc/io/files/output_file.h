// SPDX-License-Identifier: GPL-2.0-or-later
// A file that appears complete or not at all.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mikromakro {

/// Writes beside `file` under a temporary name and renames on commit; a file that was not committed leaves
/// nothing behind. A symbolic link stays one: what it points to is written. What is no regular file (a pipe,
/// a device) is written to as it is. Throws: a name that cannot be written (bad input), a disk that is full
/// (failed run).
class OutputFile {
 public:
  explicit OutputFile(const std::string& file);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void commit(std::string_view content);

  /// For libraries that write files themselves: they write to `temporary`, then `publish` renames it.
  const std::string& temporary() const { return temporary_; }
  void publish();
  /// Throws where the file has no temporary name, since it is a pipe or a device.
  void require_regular() const;

 private:
  bool is_replaced() const { return temporary_ != target_; }
  [[noreturn]] void fail() const;

  std::string file_;
  std::string target_;     // where the links of file_ lead to
  std::string temporary_;  // the target itself where that is no regular file
};

/// Throws where an output is one of the inputs, or two outputs are one file, by whatever names or links: what
/// is written would destroy what is read. "-" is standard output.
void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

/// Removes the temporary files of this process; for handlers of signals, in which little is allowed.
void remove_unfinished_outputs() noexcept;

}  // namespace mikromakro
