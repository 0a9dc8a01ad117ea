// SPDX-License-Identifier: GPL-2.0-or-later
// Where the tables of `average` go to.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "io/files/output_file.h"
#include "io/tables/csv_writer.h"

namespace mikromakro {

/// Files by their endings, made at once (so that a name that cannot be written is found before a long run)
/// and filled when all frames are read. Throws on other endings.
class TableOutputs {
 public:
  /// No names: CSV on standard output. Throws where one is among the inputs, or is named twice.
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
