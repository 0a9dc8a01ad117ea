// SPDX-License-Identifier: GPL-2.0-or-later
// What becomes of a broken file: one clear error, or the averages that the program would print.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "averaging/averager.h"
#include "averaging/time_average.h"
#include "averaging/volumes/ring_volumes.h"
#include "io/frames/frame_stream.h"
#include "model/error.h"
#include "text_file.h"

namespace mikromakro {

/// What became of a pair of files: the averages, or the line that the program would print.
struct Outcome {
  std::string error;
  Table table;
  bool told = false;  ///< by a warning
  bool refused() const { return !error.empty(); }

  bool same_as(const Outcome& good) const {
    return !refused() && table.rows.size() == good.table.rows.size() &&
           ((table.rows - good.table.rows).array().abs() < 1e-12 || good.table.rows.array().isNaN()).all();
  }
  /// Finite or undefined, nothing else.
  bool has_numbers() const {
    return !refused() && ((table.rows.array().abs() < 1e300) || table.rows.array().isNaN()).all();
  }
};

/// Reads and averages as `mikromakro average --edges 0,1,2,5 --bulk-types 1` does; every good input of the
/// corpus has two frames.
inline Outcome outcome_of(FrameSource source) {
  Outcome outcome;
  try {
    const Averager averager(
        std::make_unique<const RingVolumes>(Eigen::Vector2d::Zero(), std::vector{0.0, 1.0, 2.0, 5.0}, 1.0),
        make_weight("sliced"), make_fields({}), {{1}, Branch::radius});
    source.particles_needed = averager.particles_needed();
    source.contacts_needed = averager.contacts_needed();
    FrameStream stream(source);
    TimeAverage average;
    for (Frame frame; stream.next(frame);) average.add(averager.frame_sums(frame));
    outcome.told = !source.notes->lines().empty();
    if (average.frames() != 2) {
      EXPECT_TRUE(outcome.told) << "frames missing without a word";
      return {"frames missing", {}, outcome.told};
    }
    outcome.table = averager.solve(average.mean());
  } catch (const Error& error) {
    EXPECT_NE(error.kind(), Error::Kind::run_failed) << error.what();
    outcome.error = error.what();
    EXPECT_EQ(outcome.error.find('\n'), std::string::npos) << outcome.error;
    EXPECT_NE(outcome.error.find("expected"), std::string::npos) << outcome.error;
  }
  return outcome;
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line + "\n");
  return lines;
}

inline std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const auto& line : lines) text += line;
  return text;
}

}  // namespace mikromakro
