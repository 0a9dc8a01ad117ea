// SPDX-License-Identifier: GPL-2.0-or-later
// Fits, audits, comparisons and the steady part of series, by the program.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "json_number.h"
#include "moving_discs.h"
#include "run_program.h"

namespace mikromakro {
namespace {

// v0 exp(-(r - 0.1)/s) on ten rings; v0 and s of each window.
std::string table_of(const std::vector<std::pair<double, double>>& windows) {
  std::string text =
      "# column v_phi [m/s] (-) velocity\nstep,time,step_first,step_last,r_inner,r_outer,r,v_phi\n";
  double step = 5;
  for (const auto& [v0, s] : windows) {
    for (int i = 0; i < 10; ++i) {
      const double r = 0.105 + 0.01 * i;
      text += fmt::format("{},{},{},{},{},{},{},{:.17g}\n", step, 0.1 * step, step - 5, step + 5, r - 0.005,
                          r + 0.005, r, v0 * std::exp(-(r - 0.1) / s));
    }
    step += 20;
  }
  return text;
}

std::vector<double> numbers_of(const std::string& row) {
  std::vector<double> numbers;
  std::istringstream stream(row);
  for (std::string cell; std::getline(stream, cell, ',');)
    numbers.push_back(std::strtod(cell.c_str(), nullptr));
  return numbers;
}

// Columns: step, time, step_first, step_last, v0, ..., s (8), ..., rings (12), residual_rms.
TEST(FitOfWindows, GivesEachItsConstants) {
  const Folder folder;
  folder.write("t.csv", table_of({{0.02, 0.01}, {0.04, 0.02}}));
  const Ran ran = run_program("fit t.csv", folder.path(""));
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("\nstep,time,step_first,step_last,v0,v0_err,v0_least,v0_greatest,s,s_err,s_least,"
                         "s_greatest,rings,residual_rms\n"),
            std::string::npos)
      << ran.out;
  EXPECT_NE(ran.out.find("# column v0 [m/s] (-) v_phi at R_i\n"), std::string::npos);
  const std::vector<std::string> rows = rows_of(ran.out);
  ASSERT_EQ(rows.size(), 2U);
  constexpr double converged = 1e-6;  // of the fit
  for (const auto& [row, step, v0, s] :
       {std::tuple(rows[0], 5, 0.02, 0.01), std::tuple(rows[1], 25, 0.04, 0.02)}) {
    const std::vector<double> numbers = numbers_of(row);
    ASSERT_EQ(numbers.size(), 14U);
    EXPECT_EQ(numbers[0], step);
    EXPECT_NEAR(numbers[1], 0.1 * step, 1e-12);
    EXPECT_NEAR(numbers[4], v0, converged * v0);
    EXPECT_TRUE(std::isnan(numbers[5]));
    EXPECT_NEAR(numbers[8], s, converged * s);
    EXPECT_EQ(numbers[12], 10);
  }
  const Ran json = run_program("fit t.csv --json --omega 0.1", folder.path(""));
  EXPECT_TRUE(json.out.starts_with("{\"step\":[5.0,25.0],\"time\":[0.5,2.5],")) << json.out;
  EXPECT_NE(json.out.find("\"v0_scaled\":["), std::string::npos);
}

// A profile that grows outwards has no fit.
TEST(FitOfWindows, LeavesOutWhatHasNone) {
  const Folder folder;
  folder.write("t.csv", table_of({{0.02, 0.01}, {0.04, -0.05}}));
  const Ran ran = run_program("fit t.csv", folder.path(""));
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(ran.err.starts_with("mikromakro: warning: 1 of 2 windows have no fit, the first of them: "))
      << ran.err;
  EXPECT_TRUE(std::isnan(numbers_of(rows_of(ran.out).at(1)).at(4)));
  folder.write("none.csv", table_of({{0.04, -0.05}}));
  EXPECT_EQ(run_program("fit none.csv", folder.path("")).code, 1);
  EXPECT_EQ(run_program("fit t.csv none.csv", folder.path("")).code, 2);
  EXPECT_EQ(run_program("fit t.csv --blocks none.csv", folder.path("")).code, 2);
}

// Balances of a window are those of its frames alone.
TEST(AuditOfWindows, IsThatOfTheirFrames) {
  const MovingDiscs dumps;
  const std::string audit = "audit " + dumps.files() + "--rings 0 4 5 --kn 50 ";
  for (const auto& [option, begin, end, row] :
       {std::tuple("--every 7", 7, 13, 1U), std::tuple("--moving 7", 3, 9, 3U)}) {
    const Ran ran = run_program(audit + option);
    ASSERT_EQ(ran.code, 0) << ran.err;
    const Ran alone = run_program(audit + fmt::format("--frames {}:{} --json", begin, end));
    EXPECT_NE(ran.out.find("\nstep,time,step_first,step_last,torque,radial,residual,volume,law\n"),
              std::string::npos)
        << ran.out;
    const std::vector<double> numbers = numbers_of(rows_of(ran.out).at(row));
    EXPECT_EQ(numbers.at(2), 10 * begin);
    EXPECT_EQ(numbers.at(5), json_number(alone.out, "radial"));
    EXPECT_EQ(numbers.at(6), json_number(alone.out, "residual"));
    EXPECT_EQ(numbers.at(8), json_number(alone.out, "law"));
    EXPECT_GT(numbers.at(8), 0);
  }
  // What was averaged, and why there is no torque.
  const std::string head = run_program(audit + "--every 7").out;
  for (const char* const line : {"# particles: ", "# contacts: ", "# rings: 0 4 5\n",
                                 "# nan: torque in 3 of 3 windows: no contacts with a wheel"})
    EXPECT_NE(head.find(line), std::string::npos) << line << head;
  const Ran off = run_program(audit + "--every 7 --bound 0.5");
  EXPECT_EQ(off.code, 1);
  EXPECT_NE(off.err.find("steps 0 to 60: balances are off"), std::string::npos) << off.err;
}

// Differences and profiles of a window are those of its frames alone.
TEST(ComparisonOfWindows, IsThatOfTheirFrames) {
  const MovingDiscs dumps;
  const Folder out;
  const std::string compare = "compare " + dumps.files() + "--rings 0 4 5 --fields solid_fraction ";
  const Ran ran = run_program(compare + "--every 7 --out '" + out.path("w.csv") + "'");
  ASSERT_EQ(ran.code, 0) << ran.err;
  std::string right, profiles;
  for (const int first : {0, 7, 14}) {
    const Ran alone = run_program(
        compare + fmt::format("--frames {}:{} --out '{}'", first, first + 6, out.path("one.csv")));
    right += fmt::format("steps {} to {}\n{}\n", 10 * first, 10 * first + 60, alone.out);
    for (const std::string& row : rows_of(read_text(out.path("one.csv")))) profiles += row + "\n";
  }
  EXPECT_EQ(ran.out, right);
  std::string found;
  for (const std::string& row : rows_of(read_text(out.path("w.csv")), 4)) found += row + "\n";
  EXPECT_EQ(found, profiles);
}

// One disc that moves with v_x = drift +- 0.1 in turn, 100 frames. MSER of batches of +-0.02 is smallest for
// all of them.
std::string particles(double (*drift)(int)) {
  std::string text;
  for (int i = 0; i < 100; ++i)
    text += fmt::format(
        "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff pp\n-5 5\n-5 5\n-1 1\n"
        "ITEM: ATOMS id type x y radius vx vy\n1 1 0 0 0.5 {} 0\n",
        10 * i, drift(i) + (i % 2 == 0 ? 0.1 : -0.1));
  return text;
}

// The average begins at the frame that is named; ranks agree.
TEST(SteadyPart, IsAveraged) {
  const Folder folder;
  folder.write("p", particles([](int i) { return i < 22 ? 3.0 : 1.0; }));
  const std::string average =
      "average --particles '" + folder.path("p") + "' --box -1 1 -1 1 --fields velocity ";
  const Ran ran = run_program(average + "--steady v_x");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(ran.err.starts_with(
      "mikromakro: steady: v_x from frame 25 (step 250) on, 75 of 100 frames, by MSER-5; a straight line "))
      << ran.err;
  EXPECT_EQ(rows_of(ran.out), rows_of(run_program(average + "--frames 25:").out));
  EXPECT_NE(ran.out.find("# steady: v_x from frame 25 "), std::string::npos);
  EXPECT_EQ(run_on_ranks(2, average + "--steady v_x").out, ran.out);
  const Ran windows = run_program(average + "--steady v_x --every 75");
  EXPECT_EQ(rows_of(windows.out, 4), rows_of(ran.out));
}

TEST(SteadyPart, IsRefusedWithOneLine) {
  const Folder folder;
  folder.write("p", particles([](int i) { return 0.02 * i; }));
  const std::string average =
      "average --particles '" + folder.path("p") + "' --box -1 1 -1 1 --fields velocity --steady ";
  const Ran drifts = run_program(average + "v_x");
  EXPECT_EQ(drifts.code, 1);
  EXPECT_TRUE(
      drifts.err.starts_with("mikromakro: --steady: v_x drifts to the end; expected a change of at "
                             "most 2 standard errors (a longer run?), got "))
      << drifts.err;
  EXPECT_EQ(drifts.out, "");
  EXPECT_EQ(run_program(average + "v_x --frames 0:38").err,
            "mikromakro: --steady: too few frames to tell what drifts; expected 40 frames or more, got 39\n");
  const Ran other = run_program(average + "v_phi");
  EXPECT_EQ(other.code, 2);
  EXPECT_EQ(other.err, "mikromakro: --steady: no such column; expected one of v_x v_y, got 'v_phi'\n");
}

}  // namespace
}  // namespace mikromakro
