// A file that appears complete or not at all.
#pragma once

#include <string>
#include <string_view>

namespace mikromakro {

/// Writes beside `file` under a temporary name and renames on commit; a file that was not committed leaves
/// nothing behind. Throws: a name that cannot be written (bad input), a disk that is full (failed run).
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

 private:
  std::string file_;
  std::string temporary_;
};

}  // namespace mikromakro
