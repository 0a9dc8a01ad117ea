// SPDX-License-Identifier: GPL-2.0-or-later
// Threads and ranks of the real program: equal bytes, and one line for an error.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "run_program.h"

namespace mikromakro {
namespace {

// 50 frames of three discs in a row that move and press differently in each; one rank has 17 of them in a
// chain of three, more than one round of 16.
class Dumps {
 public:
  explicit Dumps(int bad_frame = -1) {
    std::string particles;
    std::string contacts;
    for (int i = 0; i < 50; ++i) {
      const std::string head = fmt::format("ITEM: TIMESTEP\n{}\n", 10 * i);
      const std::string box = "ITEM: BOX BOUNDS ff ff pp\n-5 5\n-5 5\n-1 1\n";
      const double x = 1 + 0.0137 * i;
      particles +=
          head + "ITEM: NUMBER OF ATOMS\n3\n" + box + "ITEM: ATOMS id type x y radius vx vy omegaz\n";
      particles += fmt::format("1 1 {} 0.1 0.5 0.{} 1 2\n2 1 {} 0.1 0.5 1 {} 3\n3 1 0 {} 0.4 1 1 1\n", x, i,
                               x + 0.95, i == bad_frame ? "nan" : "0.7", 2 + 0.01 * i);
      contacts += head + "ITEM: NUMBER OF ENTRIES\n1\n" + box +
                  "ITEM: ENTRIES id1 id2 nx ny overlap fx fy\n" +
                  fmt::format("1 2 1 0 0.05 {} {}\n", -3 - 0.1 * i, 0.3 * i);
    }
    folder_.write("particles.dump", particles);
    folder_.write("contacts.dump", contacts);
  }

  std::string arguments() const {
    return "average --particles '" + folder_.path("particles.dump") + "' --contacts '" +
           folder_.path("contacts.dump") + "' --rings 0 4 5 ";
  }
  const Folder& folder() const { return folder_; }

 private:
  Folder folder_;
};

TEST(Threads, GiveTheSameBytes) {
  const Dumps dumps;
  const Ran one = run_program(dumps.arguments() + "--threads 1");
  ASSERT_EQ(one.code, 0) << one.err;
  EXPECT_NE(one.out.find("# frames: 50, steps 0 to 490\n"), std::string::npos);
  for (const std::string threads : {"--threads 2", "--threads 3", ""})
    EXPECT_EQ(run_program(dumps.arguments() + threads).out, one.out) << threads;
}

TEST(Ranks, GiveTheSameBytes) {
  const Dumps dumps;
  for (const std::string selection : {"", "--frames 3:44:4 ", "--steps 115:333 ", "--steps 200:200 "}) {
    const Ran alone = run_program(dumps.arguments() + selection);
    for (const int ranks : {1, 2, 3}) {
      const Ran ran = run_on_ranks(ranks, dumps.arguments() + selection + "--threads 2");
      EXPECT_EQ(ran.code, 0) << ran.err;
      EXPECT_EQ(ran.out, alone.out) << ranks << " ranks " << selection;
    }
  }
}

// mpirun adds its own words about the exit code; ours is one line.
void expect_one_line(const Ran& ran, const std::string& message) {
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.out, "");
  const auto at = ran.err.find("mikromakro: ");
  ASSERT_NE(at, std::string::npos) << ran.err;
  EXPECT_EQ(ran.err.substr(at, ran.err.find('\n', at) - at + 1), message);
  EXPECT_EQ(ran.err.find("mikromakro: ", at + 1), std::string::npos) << ran.err;
}

// In the frame of one rank, when the others have rounds to go or are done.
TEST(Ranks, AnErrorOnOneRankEndsAllWithItsLine) {
  for (const int frame : {0, 1, 34, 48, 49}) {
    const Dumps dumps(frame);
    const std::string out = "--out '" + dumps.folder().path("out.csv") + "'";
    const Ran alone = run_program(dumps.arguments() + out);
    ASSERT_EQ(alone.code, 2);
    for (const int ranks : {2, 3}) expect_one_line(run_on_ranks(ranks, dumps.arguments() + out), alone.err);
    EXPECT_FALSE(std::filesystem::exists(dumps.folder().path("out.csv")));
  }
}

TEST(Ranks, BadUsageAndOtherVerbsAreToldOnce) {
  for (const std::string arguments : {"average --rings 0 4 1 --foo", "info no_such.dump",
                                      "average --particles good/particles.dump --rings 0 4 1",
                                      "average --particles good/particles.dump --rings 0 4 1 --fields spin "
                                      "--frames 7:"})
    expect_one_line(run_on_ranks(2, arguments), run_program(arguments).err);
  EXPECT_EQ(run_on_ranks(2, "info good/particles.dump").out, run_program("info good/particles.dump").out);
}

}  // namespace
}  // namespace mikromakro
