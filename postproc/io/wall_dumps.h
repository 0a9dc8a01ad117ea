// Dumps of contacts with walls, which lie in files of their own.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/dump_reader.h"
#include "io/file_sequence.h"

namespace mikromakro {

class WallDumps {
 public:
  explicit WallDumps(const std::vector<std::string>& files) : files_(files) {}

  /// The rows of this step; steps must be asked for as they ascend. Throws where the files have none.
  std::shared_ptr<const RowBlock> take(std::int64_t step);
  std::int64_t bytes_read() const { return files_.bytes_read(); }

 private:
  FileSequence<DumpReader> files_;
  DumpHeader header_;
  bool ahead_ = false;  ///< header_ has been read, its rows have not
};

}  // namespace mikromakro
