// SPDX-License-Identifier: GPL-2.0-or-later
// Text that is kept on disk until what stands above it is known.
#pragma once

#include <cstdio>
#include <iosfwd>
#include <memory>
#include <string_view>

namespace mikromakro {

/// A file without a name, in the folder of the system for temporary files, which is gone when the program
/// ends. Throws (failed run) on a full disk.
class Spool {
 public:
  Spool();
  void add(std::string_view text);
  /// Writes everything added so far.
  void copy_to(std::ostream& stream);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace mikromakro
