// SPDX-License-Identifier: GPL-2.0-or-later
// Output files of `average`.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "io/files/output_file.h"
#include "io/tables/csv_writer.h"

namespace mikromakro {

/// Files by extension, created at once (so that an unwritable name is found before a long run) and filled
/// after all frames are read. Throws on other extensions.
class TableOutputs {
 public:
  /// No names: CSV to standard output. Throws if a name is also an input or occurs twice.
  explicit TableOutputs(const std::vector<std::string>& names, const std::vector<std::string>& inputs = {});

  void commit(const Preamble& preamble, const Table& table, const Eigen::Vector2d& center);

 private:
  struct File {
    std::string name;
    std::unique_ptr<OutputFile> file;
  };
  bool to_stdout_;
  std::vector<File> files_;
};

}  // namespace mikromakro
