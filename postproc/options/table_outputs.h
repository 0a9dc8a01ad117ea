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

/// Files by extension, created at once, so that an unwritable name is found before a long run.
struct OutputFiles {
  struct File {
    std::string name;
    std::unique_ptr<OutputFile> file;
  };
  /// No names: CSV to standard output. Throws on other extensions, and if a name is also an input or occurs
  /// twice.
  explicit OutputFiles(const std::vector<std::string>& names, const std::vector<std::string>& inputs = {});

  bool to_stdout;
  std::vector<File> files;
};

/// Filled after all frames are read.
class TableOutputs {
 public:
  explicit TableOutputs(const std::vector<std::string>& names, const std::vector<std::string>& inputs = {})
      : files_(names, inputs) {}

  void commit(const Preamble& preamble, const Table& table, const Eigen::Vector2d& center);

 private:
  OutputFiles files_;
};

}  // namespace mikromakro
