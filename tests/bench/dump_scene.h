// SPDX-License-Identifier: GPL-2.0-or-later
// Dumps of a shear cell's size as our input scripts write them, for benchmarks: 3800 discs and 4700 contacts
// per frame between the rings of the paper, numbers with the digits of inputs/couette.
#pragma once

#include <cstdint>
#include <string>

namespace mikromakro::bench {

/// A folder that is removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string path(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

struct Dumps {
  std::string particles, contacts;  // file names
  std::int64_t bytes = 0;
};

/// Frames of random discs and contacts, another one in each frame; with `bytes` > 0 as many copies of one
/// frame (with ascending steps) as come nearest to that size.
Dumps write_dumps(const TemporaryFolder& folder, int frames, std::int64_t bytes = 0);

}  // namespace mikromakro::bench
