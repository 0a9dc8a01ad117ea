// SPDX-License-Identifier: GPL-2.0-or-later
// Dumps of a few discs, and the rows of tables made of them.
#pragma once

#include <fmt/format.h>

#include <sstream>
#include <string>
#include <vector>

#include "text_file.h"

namespace mikromakro {

// 23 frames, every 10 steps, of three discs that move and press differently in each.
class MovingDiscs {
 public:
  explicit MovingDiscs(bool with_times = false) {
    std::string particles, contacts;
    for (int i = 0; i < 23; ++i) {
      std::string head = fmt::format("ITEM: TIMESTEP\n{}\n", 10 * i);
      if (with_times) head = fmt::format("ITEM: TIME\n{}\n", 0.02 * i) + head;
      const std::string box = "ITEM: BOX BOUNDS ff ff pp\n-5 5\n-5 5\n-1 1\n";
      const double x = 1 + 0.0137 * i;
      particles += head + "ITEM: NUMBER OF ATOMS\n3\n" + box +
                   "ITEM: ATOMS id type x y radius vx vy omegaz\n" +
                   fmt::format("1 1 {} 0.1 0.5 0.{} 1 2\n2 1 {} 0.1 0.5 1 0.7 3\n3 1 0 {} 0.4 1 1 1\n", x, i,
                               x + 0.95, 2 + 0.01 * i);
      contacts += head + "ITEM: NUMBER OF ENTRIES\n1\n" + box +
                  "ITEM: ENTRIES id1 id2 nx ny overlap fx fy\n" +
                  fmt::format("1 2 1 0 0.05 {} {}\n", -3 - 0.1 * i, 0.3 * i);
    }
    folder_.write("particles.dump", particles);
    folder_.write("contacts.dump", contacts);
  }

  std::string files() const {
    return "--particles '" + folder_.path("particles.dump") + "' --contacts '" +
           folder_.path("contacts.dump") + "' ";
  }
  std::string arguments() const { return "average " + files() + "--rings 0 4 5 "; }
  const Folder& folder() const { return folder_; }

 private:
  Folder folder_;
};

// The rows of a table below its names, from column `first` on.
inline std::vector<std::string> rows_of(const std::string& text, int first = 0) {
  std::istringstream lines(text);
  std::vector<std::string> rows;
  bool named = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    std::size_t at = 0;
    for (int i = 0; i < first; ++i) at = line.find(',', at) + 1;
    if (named) rows.push_back(line.substr(at));
    named = true;
  }
  return rows;
}

}  // namespace mikromakro
