// SPDX-License-Identifier: GPL-2.0-or-later
// fix snapshot/disc and fix ave/micromacro in the program, alone and under mpirun: what they write equals
// dumps and averages of dumps, and goes on after restarts.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <sstream>

#include "io/hdf5/hdf5_file.h"
#include "snapshot_run.h"

namespace mikromakro::test {
namespace {

// Particles and contacts as text, to the last bit.
std::string dumps(int every) {
  std::string columns;
  for (int k = 1; k <= 16; ++k) columns += fmt::format(" c_contacts[{}]", k);
  std::string format = "%.0f %.0f";
  for (int k = 3; k <= 16; ++k) format += " %.17g";
  return fmt::format(
      "dump p all custom {0} p_*.txt id type x y radius mass vx vy omegaz\n"
      "dump_modify p sort id format \"%d %d %.17g %.17g %.17g %.17g %.17g %.17g %.17g\"\n"
      "dump c all local {0} c_*.txt{1}\ndump_modify c format \"{2}\"\n",
      every, columns, format);
}

long lines_beginning_with(const std::string& text, const std::string& output) {
  std::istringstream lines(output);
  long count = 0;
  for (std::string line; std::getline(lines, line);) count += line.starts_with(text) ? 1 : 0;
  return count;
}

class OnRanks : public SnapshotOfARun, public testing::WithParamInterface<int> {};

// Also where the second run starts, which has a frame of this step already.
TEST_P(OnRanks, HasTheNumbersOfDumpsToTheLastBit) {
  run(turning_cell + "fix s all snapshot/disc 20 file s.h5\n" + dumps(20) + "run 60\nrun 60\n", GetParam());
  const auto frames = snapshots();
  ASSERT_EQ(frames.size(), 7U);
  std::size_t contacts = 0;
  for (const auto& [step, frame] : frames) contacts += frame.contacts.size();
  EXPECT_GT(contacts, 50U);
  EXPECT_EQ(frames, dumped());
}

TEST_P(OnRanks, HasTheBoxBesideTheCell) {
  run(turning_cell +
          "fix box free biaxial/2d type 1 left -0.05 fixed right 0.05 strain rate -2 bottom -0.05 fixed top "
          "0.05 fixed\nfix s all snapshot/disc 20 file s.h5\nrun 40\n",
      GetParam());
  const Hdf5File file = Hdf5File::open(path("s.h5"));
  std::vector<double> box(81), cell(27);
  file.dataset("/walls/box/value").read<double>({{0, 0}, {3, 27}}, box);
  file.dataset("/walls/cell/value").read<double>({{0, 0}, {3, 9}}, cell);
  for (const std::size_t frame : {0, 1, 2}) {
    const double* walls = &box[27 * frame];
    EXPECT_EQ(walls[0], -0.05);
    EXPECT_DOUBLE_EQ(walls[1], 0.05 - 2 * 20 * 2e-5 * static_cast<double>(frame));
    EXPECT_EQ(walls[5], -2);
    EXPECT_NEAR(walls[16], (walls[1] - 0.05) / 0.1, 1e-15);  // horizontal strain; rounding of 1 + strain
    EXPECT_EQ(cell[9 * frame + 6], 0.045);
  }
}

TEST_P(OnRanks, HasTheStateOfTheWallsAndWhatIsSimulated) {
  run(turning_cell + "fix s all snapshot/disc 20 file s.h5 height 0.006\nrun 40\n", GetParam());
  const Hdf5File file = Hdf5File::open(path("s.h5"));
  std::vector<double> walls(27), k_t(16), height(1);
  file.dataset("/walls/cell/value").read<double>({{0, 0}, {3, 9}}, walls);
  for (const std::size_t frame : {0, 1, 2}) {
    EXPECT_DOUBLE_EQ(walls[9 * frame + 4], 5 * 20 * 2e-5 * static_cast<double>(frame));  // angle of the wheel
    EXPECT_EQ(walls[9 * frame + 6], 0.045);                                              // outer radius
  }
  file.dataset("/parameters/kt").read<double>({{0, 0}, {4, 4}}, k_t);
  EXPECT_EQ(k_t, std::vector<double>(16, 300));
  file.dataset("/parameters/height").read<double>({{0}, {1}}, height);
  EXPECT_EQ(height[0], 0.006);
  const auto effects = file.text_attribute("/parameters", "effects");
  const auto simulated = [&](const char* name) { return std::count(effects.begin(), effects.end(), name); };
  EXPECT_EQ(simulated("linear normal force"), 1);
  EXPECT_EQ(simulated("friction with spring"), 1);
  EXPECT_EQ(simulated("gravity"), 0);
  EXPECT_EQ(file.text_attribute("/parameters", "units"), std::vector<std::string>{"si"});
}

// The file was ahead of the restart by two frames, which are dropped and written again.
TEST_P(OnRanks, GoesOnFromARestart) {
  const std::string snapshot = "fix s all snapshot/disc 20 file {} append yes\n";
  run(turning_cell + fmt::format(fmt::runtime(snapshot), "whole.h5") + "run 160\n", GetParam());
  run(turning_cell + fmt::format(fmt::runtime(snapshot), "s.h5") +
          "run 50\nwrite_restart half.restart\nrun 50\n",
      GetParam());
  run(turning_cell_from("half.restart") + fmt::format(fmt::runtime(snapshot), "s.h5") + "run 110\n",
      GetParam());
  EXPECT_NE(text("screen.txt").find("snapshot/disc: dropped 3 frames after step 50 from s.h5"),
            std::string::npos);
  const auto frames = snapshots(), whole = snapshots("whole.h5");
  ASSERT_EQ(frames.size(), 9U);
  for (const auto& [step, frame] : frames) {
    ASSERT_EQ(frame.discs.size(), whole.at(step).discs.size());
    for (std::size_t i = 0; i < frame.discs.size(); ++i)
      // Rounding of sums in another order, grown over 110 steps.
      for (const std::size_t k : {2U, 3U}) EXPECT_NEAR(frame.discs[i][k], whole.at(step).discs[i][k], 1e-14);
  }
}

TEST_P(OnRanks, StopsAtAFileOfAnotherSystem) {
  run(turning_cell + "fix s all snapshot/disc 20 file s.h5\nrun 20\n", GetParam());
  const auto stopped = [&](const std::string& script, const std::string& line) {
    EXPECT_NE(std::system(("timeout 60 sh -c '" + command(script, GetParam()) + "'").c_str()), 0);
    const std::string output = text("screen.txt");
    EXPECT_NE(output.find("ERROR: snapshot/disc: s.h5: belongs to another system, " + line),
              std::string::npos)
        << output;
    // From all ranks together. Open MPI 5 at times adds '[host:pid] PMIX ERROR', a line of mpirun's own, to
    // programs that end with an exit code.
    EXPECT_EQ(lines_beginning_with("ERROR", output), 1) << output;
  };
  const std::string append = "fix s all snapshot/disc 20 file s.h5 append yes\nrun 20\n";
  stopped(turning_cell + "set group outer diameter 0.0024\n" + append, "disc 21 differs");
  stopped(
      turning_cell +
          "unfix kt\nunfix mu\nfix mu all property/global coefficientFriction peratomtypepair 4 .4 .4 .4 .4 "
          ".4 .4 .4 .4 .4 .4 .4 .4 .4 .4 .4 .4\npair_style gran model disc/linear tangential off\npair_coeff "
          "* *\n" +
          append,
      "effects differs");
}

TEST_P(OnRanks, AveragesAreThoseOfTheProgramToTheLastBit) {
  run(turning_cell +
          "fix s all snapshot/disc 20 file s.h5\n"
          "fix r all ave/micromacro 20 60 file r_*.csv rings 0.02 0.045 5 bulk_types 1,2 kn 400 height "
          "0.006\n"
          "fix g all ave/micromacro 20 60 file g.csv grid -0.05 0.05 2 -0.05 0.05 2 weight centre branch "
          "contact "
          "fields solid_fraction,stress,sliding_fraction mu 0.4\n"
          "run 100\nrun 20\n",
      GetParam());
  average("--steps 20:60 --rings 0.02 0.045 5 --bulk-types 1,2 --kn 400 --height 0.006", "first.csv");
  average("--steps 80:120 --rings 0.02 0.045 5 --bulk-types 1,2 --kn 400 --height 0.006", "second.csv");
  average(
      "--steps 20:120 --grid -0.05 0.05 2 -0.05 0.05 2 --weight centre --branch contact "
      "--fields solid_fraction,stress,sliding_fraction --mu 0.4",
      "grid.csv");
  ASSERT_GT(table("first.csv").size(), 1000U);
  EXPECT_EQ(table("r_60.csv"), table("first.csv"));
  EXPECT_EQ(table("r_120.csv"), table("second.csv"));
  EXPECT_EQ(table("g.csv"), table("grid.csv"));
  EXPECT_NE(text("r_120.csv").find("# frames: 3, steps 80 to 120\n"), std::string::npos);
}

// The rows of a table from column `first` on, without the names.
std::string rows_from(const std::string& table, int first) {
  std::istringstream lines(table);
  std::string line, rows;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::size_t at = 0;
    for (int i = 0; i < first; ++i) at = line.find(',', at) + 1;
    rows += line.substr(at) + "\n";
  }
  return rows;
}

// Windows of three frames; the frame of step 0 is in none. Each row begins with step, time, step_first and
// step_last, and the nine numbers of the cell.
TEST_P(OnRanks, WindowsAreThoseOfTheProgramToTheLastBit) {
  run(turning_cell +
          "fix s all snapshot/disc 20 file s.h5\n"
          "fix r all ave/micromacro 20 60 file r_*.csv rings 0.02 0.045 5 bulk_types 1,2 kn 400 height "
          "0.006\nrun 120\n",
      GetParam());
  average("--every 3 --frames 1: --rings 0.02 0.045 5 --bulk-types 1,2 --kn 400 --height 0.006", "w.csv");
  const std::string windows = table("w.csv");
  EXPECT_TRUE(windows.starts_with(
      "step,time,step_first,step_last,cell_torque_inner,cell_torque_outer,cell_pressure_inner,"
      "cell_pressure_outer,cell_angle_inner,cell_angle_outer,cell_r_outer,cell_r_outer_rate,"
      "cell_power_inner,r_inner,r_outer,r,nu,"))
      << windows;
  const std::string rows = rows_from(windows, 13);
  ASSERT_GT(rows.size(), 2000U);
  EXPECT_EQ(rows, rows_from(table("r_60.csv"), 0) + rows_from(table("r_120.csv"), 0));
  EXPECT_NE(text("w.csv").find("# column cell_pressure_outer [N/m] (-) pressure on the outer ring\n"),
            std::string::npos);  // the cell has no height
  // Steps 20, 40, 60: the angle at the mean time, 40 steps of 2e-5 s at 5 rad/s.
  EXPECT_TRUE(rows_from(windows, 0).starts_with("40,")) << rows_from(windows, 0);
  double angle = 0;
  std::istringstream(rows_from(windows, 8)) >> angle;
  EXPECT_DOUBLE_EQ(angle, 5 * 40 * 2e-5);
}

// Discs and contacts across the boundaries count on both sides of them. nu of the whole box is that of all
// discs.
TEST_P(OnRanks, AveragesInAPeriodicBoxAreThoseOfTheProgramToTheLastBit) {
  const std::string box = "box -0.02 0.02 -0.015 0.015 kn 400 branch contact";
  const std::string rings = "rings 0 0.016 4 center -0.02 0.015 kn 400";
  const std::string grid = "grid -0.02 0.02 4 -0.015 0.015 3 weight gauss:0.003 kn 400";
  run(periodic_box + "fix s all snapshot/disc 20 file s.h5\n" +
          fmt::format(
              "fix b all ave/micromacro 20 60 file b.csv {}\nfix r all ave/micromacro 20 60 file r.csv {}\n"
              "fix g all ave/micromacro 20 60 file g.csv {}\nrun 480\n",
              box, rings, grid),
      GetParam());
  average("--steps 20:480 --box -0.02 0.02 -0.015 0.015 --kn 400 --branch contact", "box.csv");
  average("--steps 20:480 --rings 0 0.016 4 --center -0.02 0.015 --kn 400", "rings.csv");
  average("--steps 20:480 --grid -0.02 0.02 4 -0.015 0.015 3 --weight gauss:0.003 --kn 400", "grid.csv");
  EXPECT_EQ(table("b.csv"), table("box.csv"));
  EXPECT_EQ(table("r.csv"), table("rings.csv"));
  EXPECT_EQ(table("g.csv"), table("grid.csv"));
  double squares = 0;
  std::ptrdiff_t across = 0;
  const auto frames = snapshots();
  for (const Numbers& disc : frames.at(480).discs) squares += disc[4] * disc[4];
  // The place of disc 2 in its row is that of the image that touches.
  for (const auto& [step, frame] : frames) {
    const auto& discs = frame.discs;
    across += std::count_if(frame.contacts.begin(), frame.contacts.end(), [&](const Numbers& row) {
      const Numbers& second = discs.at(static_cast<std::size_t>(row[1]) - 1);
      return std::hypot(row[4] - second[2], row[5] - second[3]) > 0.01;
    });
  }
  EXPECT_GT(across, 5);
  const std::string rows = table("b.csv");
  std::istringstream numbers(rows.substr(rows.find('\n') + 1));
  double nu = 0;
  for (int column = 0; column <= 6; ++column) (numbers >> nu).ignore(1);
  EXPECT_NEAR(nu, std::numbers::pi * squares / (0.04 * 0.03), 1e-14);
}

INSTANTIATE_TEST_SUITE_P(Program, OnRanks, testing::Values(1, 2));

}  // namespace
}  // namespace mikromakro::test
