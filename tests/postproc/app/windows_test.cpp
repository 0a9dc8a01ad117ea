// SPDX-License-Identifier: GPL-2.0-or-later
// Averages as functions of time, by the program.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "moving_discs.h"
#include "run_program.h"

namespace mikromakro {
namespace {

// Each window is the average of its frames alone, to the last bit and with its errors.
TEST(AverageOverWindows, AreTheAveragesOfTheirFrames) {
  const MovingDiscs dumps;
  for (const auto& [option, frames, step] :
       {std::tuple("--every 10", 10, 10), std::tuple("--per-frame", 1, 1),
        std::tuple("--moving 11", 11, 1)}) {
    const Ran ran = run_program(dumps.arguments() + option);
    ASSERT_EQ(ran.code, 0) << ran.err;
    const std::vector<std::string> rows = rows_of(ran.out, 4), with_steps = rows_of(ran.out);
    const int windows = (23 - frames) / step + 1;
    ASSERT_EQ(rows.size(), 5U * static_cast<std::size_t>(windows)) << option;
    for (int window = 0; window < windows; window += 3) {
      const int first = window * step, last = first + frames - 1;
      const Ran alone = run_program(dumps.arguments() + fmt::format("--frames {}:{}", first, last));
      const std::vector<std::string> right = rows_of(alone.out);
      for (std::size_t i = 0; i < right.size(); ++i) {
        const std::size_t row = 5 * static_cast<std::size_t>(window) + i;
        EXPECT_EQ(rows[row], right[i]) << option << " " << window;
        EXPECT_TRUE(with_steps[row].starts_with(
            fmt::format("{},nan,{},{},", 5 * (first + last), 10 * first, 10 * last)))
            << with_steps[row];
      }
    }
  }
}

TEST(AverageOverWindows, SaysWhatIsLeftOut) {
  const MovingDiscs dumps;
  const Ran ran = run_program(dumps.arguments() + "--every 10");
  const std::string line =
      "warning: frames at the end of run 1 that do not fill a window of 10 are left out: 3, steps 200 to "
      "220\n";
  EXPECT_EQ(ran.err, "mikromakro: " + line);
  EXPECT_NE(ran.out.find("# " + line.substr(0, line.size() - 1)), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("# windows: 2 of 10 frames\n"), std::string::npos);
  EXPECT_EQ(run_program(dumps.arguments() + "--moving 10").err, "");
}

// Snapshots are read in one thread while another writes the windows. The library itself has no locks, and
// fails in four of ten such runs without ours.
TEST(AverageOverWindows, AreWrittenToHdf5WhileSnapshotsAreRead) {
  const MovingDiscs dumps;
  const std::string snapshots = dumps.folder().path("s.h5"), out = dumps.folder().path("out.h5");
  ASSERT_EQ(run_program("convert " + dumps.files() + "--out " + snapshots).code, 0);
  const std::string average = "average " + snapshots + " --rings 0 4 5 --per-frame --out " + out;
  ASSERT_EQ(run_program(average + " --threads 1").code, 0);
  const std::string right = read_text(out);
  for (int i = 0; i < 10; ++i) {
    const Ran ran = run_program(average + " --threads 3");
    ASSERT_EQ(ran.code, 0) << ran.err;
    ASSERT_TRUE(read_text(out) == right);
  }
}

TEST(AverageOverWindows, GiveTheSameBytesOnAllThreadsAndRanks) {
  const MovingDiscs dumps(true);
  for (const std::string option : {"--every 4 ", "--moving 4 "}) {
    const Ran one = run_program(dumps.arguments() + option + "--threads 1");
    ASSERT_EQ(one.code, 0) << one.err;
    EXPECT_EQ(run_program(dumps.arguments() + option + "--threads 3").out, one.out);
    for (const int ranks : {2, 3})
      EXPECT_EQ(run_on_ranks(ranks, dumps.arguments() + option).out, one.out) << ranks;
  }
}

TEST(AverageOverWindows, HaveTheTimesOfTheFilesOrOfTheTimeStep) {
  const MovingDiscs without, with(true);
  // Steps 0, 10, 20 and 30.
  const auto first_row = [](const MovingDiscs& dumps, const std::string& options) {
    const Ran ran = run_program(dumps.arguments() + "--every 4 " + options);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return rows_of(ran.out).at(0);
  };
  EXPECT_TRUE(first_row(without, "").starts_with("15,nan,0,30,"));
  EXPECT_TRUE(first_row(without, "--timestep 0.002").starts_with("15,0.029999999999999999,0,30,"));
  EXPECT_TRUE(first_row(with, "").starts_with("15,0.029999999999999999,0,30,"));
  EXPECT_TRUE(first_row(with, "--timestep 0.002").starts_with("15,0.029999999999999999,0,30,"));
  const Ran other = run_program(with.arguments() + "--every 4 --timestep 0.003");
  EXPECT_EQ(other.code, 2);
  EXPECT_NE(other.err.find("--timestep: the file has times of its own, which differ"), std::string::npos)
      << other.err;
}

TEST(AverageOverWindows, OfSeveralRunsNameTheRun) {
  const MovingDiscs one, two;
  const Ran ran = run_program("average --rings 0 4 1 --every 20 --fields solid_fraction --error-blocks 0 " +
                              one.files() + two.files());
  ASSERT_EQ(ran.code, 2) << ran.out;  // a copy of a run is none
  std::string shorter = read_text(two.folder().path("particles.dump"));
  const Ran other = run_program(
      "average --rings 0 4 1 --every 20 --fields velocity --error-blocks 0 " + one.files() + "--particles '" +
      two.folder().write("p2.dump", shorter.substr(0, shorter.rfind("ITEM: TIMESTEP"))) + "' --contacts '" +
      two.folder().path("contacts.dump") + "'");
  ASSERT_EQ(other.code, 0) << other.err;
  const std::vector<std::string> rows = rows_of(other.out);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_TRUE(rows[0].starts_with("95,nan,0,190,1,")) << rows[0];
  EXPECT_TRUE(rows[1].starts_with("95,nan,0,190,2,")) << rows[1];
}

TEST(AverageOverWindows, AreRefusedWithOneLine) {
  const MovingDiscs dumps;
  const auto refused = [&](const std::string& options) {
    const Ran ran = run_program(dumps.arguments() + options);
    EXPECT_EQ(ran.code, 2) << options;
    EXPECT_EQ(ran.out, "") << options;
    return ran.err;
  };
  EXPECT_EQ(
      refused("--every 24"),
      "mikromakro: --every: no run fills a window; expected at most 23, the selected frames of a run, got "
      "24\n");
  EXPECT_EQ(refused("--moving 24"),
            "mikromakro: --moving: no run fills a window; expected at most 23, the selected frames of a run, "
            "got 24\n");
  EXPECT_EQ(refused("--every 3 --per-frame"),
            "mikromakro: --per-frame: windows are of one kind; expected one of --every, --per-frame and "
            "--moving, got 2 of them\n");
  EXPECT_EQ(
      refused("--timestep 0.1"),
      "mikromakro: --timestep: no column takes it; expected --every, --per-frame or --moving beside it, "
      "got none\n");
  EXPECT_EQ(refused("--every 3 --blocks b.csv"),
            "mikromakro: --blocks: tells of the errors of one table; expected no windows beside it, got "
            "--every\n");
  EXPECT_NE(refused("--every 0").find("--every: "), std::string::npos);
}

// Nothing is left behind by a run that ends early.
TEST(AverageOverWindows, LeaveNoPartOfAFile) {
  const MovingDiscs dumps;
  const Folder out;
  const Ran ran = run_program(dumps.arguments() + "--every 24 --out '" + out.path("a.csv") + "' --out '" +
                              out.path("a.h5") + "' --out '" + out.path("a.vtkhdf") + "'");
  EXPECT_EQ(ran.code, 2);
  EXPECT_TRUE(out.empty());
}

}  // namespace
}  // namespace mikromakro
