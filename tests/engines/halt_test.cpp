// SPDX-License-Identifier: GPL-2.0-or-later
// Runs that the engine ends before their last step, by `fix halt` or by `timer timeout`: nobody knew in that
// step that it would be the last. Files and state are those of a run of so many steps, and the next run goes
// on from there, to the last bit.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "snapshot_run.h"

namespace mikromakro::test {
namespace {

/// Every so many steps a frame, and every third frame the averages.
std::string files(const std::string& name, int every) {
  return fmt::format(
      "fix s all snapshot/disc {1} file {0}.h5\n"
      "fix r all ave/micromacro {1} {2} file {0}_*.csv rings 0.02 0.045 5\n"
      "fix g all ave/micromacro {1} {2} file {0}.csv rings 0.02 0.045 5\n",
      name, every, 3 * every);
}

std::string final_state(const std::string& name) {
  return fmt::format(
      "write_dump all custom {} id x y vx vy omegaz fx fy tqz modify sort id format line "
      "\"%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g\"\n",
      name);
}

/// A disc at rest on a ring that does not turn has a velocity of -0 or of 0, as its row was last written by
/// the ring or where new neighbour lists were due.
std::string without_signs_of_zeros(const std::string& numbers) {
  return std::regex_replace(numbers, std::regex(" -0(?=[ \\n])"), " 0");
}

class EndedEarly : public SnapshotOfARun, public testing::WithParamInterface<int> {
 protected:
  /// What `stopped` and `whole` have written since the step in which the first was stopped.
  void expect_same_files(std::int64_t last_average) const {
    EXPECT_EQ(snapshots("stopped.h5"), snapshots("whole.h5"));
    EXPECT_EQ(table("stopped.csv"), table("whole.csv"));
    const std::string name = fmt::format("_{}.csv", last_average);
    ASSERT_GT(table("whole" + name).size(), 100U);
    EXPECT_EQ(table("stopped" + name), table("whole" + name));
    expect_same_state("stopped.txt");
  }

  void expect_same_state(const std::string& name) const {
    ASSERT_GT(text("whole.txt").size(), 10000U);
    EXPECT_EQ(without_signs_of_zeros(text(name)), without_signs_of_zeros(text("whole.txt")));
  }
};

TEST_P(EndedEarly, ByFixHalt) {
  const std::string rest = "write_restart {0}.restart\nrun 210\n";
  run(turning_cell + files("stopped", 20) +
          "variable now equal step\nfix stop all halt 50 v_now >= 250 error continue\nrun 1000\nunfix "
          "stop\n" +
          fmt::format(fmt::runtime(rest), "stopped") + final_state("stopped.txt"),
      GetParam());
  EXPECT_NE(text("screen.txt").find("met on step 250"), std::string::npos);
  run(turning_cell + files("whole", 20) + "run 250\n" + fmt::format(fmt::runtime(rest), "whole") +
          final_state("whole.txt"),
      GetParam());
  expect_same_files(420);
  run(turning_cell_from("stopped.restart") + "run 210\n" + final_state("continued.txt"), GetParam());
  expect_same_state("continued.txt");
}

// The state of that step was left open: no frame, nobody who would look.
TEST_P(EndedEarly, ByTheTimer) {
  const std::string rest = "run 400\n";
  run(turning_cell + files("stopped", 50) +
          "timer timeout 2 every 7\nrun 100000000\ntimer timeout off\nprint \"ended at $(step) .\"\n"
          "write_restart stopped.restart\n" +
          rest + final_state("stopped.txt"),
      GetParam());
  const std::string screen = text("screen.txt"), said = "\nended at ";
  const auto place = screen.find(said);
  ASSERT_NE(place, std::string::npos) << screen;
  const long step = std::stol(screen.substr(place + said.size()));
  ASSERT_GT(step, 150);
  run(turning_cell + files("whole", 50) + fmt::format("run {}\nwrite_restart whole.restart\n", step) + rest +
          final_state("whole.txt"),
      GetParam());
  expect_same_files((step + 400) / 150 * 150);
  run(turning_cell_from("stopped.restart") + rest + final_state("continued.txt"), GetParam());
  expect_same_state("continued.txt");
}

// A hard halt is an error: the run ends at once.
TEST_P(EndedEarly, ByAnError) {
  const std::string script = turning_cell + files("s", 20) +
                             "variable now equal step\nfix stop all halt 50 v_now >= 250 error hard\n";
  EXPECT_NE(std::system(("timeout 60 sh -c '" + command(script + "run 1000\n", GetParam()) + "'").c_str()),
            0);
  run(turning_cell + files("whole", 20) + "run 250\n", GetParam());
  EXPECT_EQ(snapshots(), snapshots("whole.h5"));
  EXPECT_EQ(table("s.csv"), table("whole.csv"));
}

INSTANTIATE_TEST_SUITE_P(OnRanks, EndedEarly, testing::Values(1, 2));

}  // namespace
}  // namespace mikromakro::test
