// SPDX-License-Identifier: GPL-2.0-or-later
// Runs of the program that are looked at from outside, through the files that they leave.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace mikromakro::test {

/// A cell with 100 free discs, 160 in all, whose wheel turns; compute `contacts`. The same from a restart
/// file.
extern const std::string turning_cell;
std::string turning_cell_from(const std::string& restart_file);

/// 32 discs that fly about in a box of 0.04 by 0.03 m, periodic along both axes.
extern const std::string periodic_box;

using Numbers = std::vector<double>;

// Every number of a frame; contacts have no order of their own.
struct Content {
  std::vector<Numbers> discs, contacts;
  bool operator==(const Content&) const = default;
};

class SnapshotOfARun : public testing::Test {
 protected:
  SnapshotOfARun();
  ~SnapshotOfARun() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& file) const { return (folder_ / file).string(); }
  std::string text(const std::string& file) const;
  /// The lines below the '#' lines.
  std::string table(const std::string& file) const;

  /// For a shell: runs the script, in lines of LIGGGHTS, in the folder of the test; output in screen.txt.
  std::string command(const std::string& script, int ranks) const;
  void run(const std::string& script, int ranks) const;
  /// Of s.h5, by `mikromakro average`.
  void average(const std::string& options, const std::string& out) const;

  /// All frames by their steps: of an HDF5 file, and of dumps p_STEP.txt, c_STEP.txt every 20 steps.
  std::map<std::int64_t, Content> snapshots(const std::string& file = "s.h5") const;
  std::map<std::int64_t, Content> dumped() const;

  std::filesystem::path folder_;
};

}  // namespace mikromakro::test
