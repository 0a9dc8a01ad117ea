// SPDX-License-Identifier: GPL-2.0-or-later
// Kinds of input through the program: MercuryDPM's files, several runs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "run_program.h"

namespace mikromakro {
namespace {

const std::string dumps = "--particles good/particles.dump --contacts good/contacts.dump ";
const std::string rings = " --rings 0 4 2 --bulk-types 1";

// A run that is another one by its bytes, k lines without words, and the same by its numbers.
std::string further_run(const Folder& folder, int k) {
  const std::string particles =
      read_text(TEST_DATA "/good/particles.dump") + std::string(static_cast<std::size_t>(k), '\n');
  return "--particles '" + folder.write(fmt::format("particles.{}.dump", k), particles) +
         "' --contacts good/contacts.dump ";
}

std::string numbers(const std::string& csv) {
  return csv.substr(csv.find("\nr_inner"));
}

// Both tables, number by number.
void expect_same(const std::string& a, const std::string& b, double tolerance) {
  const auto words_of = [](std::string csv) {
    csv = numbers(csv);
    std::replace(csv.begin(), csv.end(), ',', ' ');
    std::istringstream stream(csv);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
  };
  const auto first = words_of(a), second = words_of(b);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == second[i]) continue;
    const double expected = std::stod(second[i]);
    EXPECT_NEAR(std::stod(first[i]), expected, tolerance * std::abs(expected)) << "word " << i;
  }
}

// The masses of the dump are 0.2 kg for a = 0.5 m: rho h = 0.2/(pi 0.25) kg/m^2.
TEST(MercuryInput, GivesTheAveragesOfTheSameDiscsInDumps) {
  const Ran from_dumps = run_program("average " + dumps + rings);
  for (const std::string particles : {"good/mercury.data", "good/mercury_3d.data"}) {
    const Ran ran = run_program("average --particles " + particles +
                                " --contacts good/mercury.fstat --density 0.25464790894703254" + rings);
    EXPECT_EQ(ran.code, 0) << ran.err;
    expect_same(ran.out, from_dumps.out, 1e-15);  // rounding of the masses
  }
}

TEST(MercuryInput, CanBeConvertedToHdf5) {
  const Folder folder;
  const std::string files = "--particles good/mercury.data --contacts good/mercury.fstat --density 0.25 ";
  const std::string file = fmt::format("'{}'", folder.path("m.h5"));
  EXPECT_EQ(run_program("convert " + files + "--out " + file).code, 0);
  const Ran from_file = run_program("average " + file + rings);
  EXPECT_EQ(numbers(from_file.out), numbers(run_program("average " + files + rings).out)) << from_file.err;
}

TEST(MercuryInput, IsToldByInfo) {
  EXPECT_EQ(run_program("info good/mercury.data").out,
            "good/mercury.data: particles (MercuryDPM)\n  frames   2 (times 1 to 2 s)\n  rows     4 to 4 per "
            "frame\n"
            "  box      x -5 to 5 m, y -5 to 5 m\n  type 1   3 discs\n  type 2   1 discs\n"
            "  radius   0.125 to 0.5 m\n");
  EXPECT_EQ(run_program("info good/mercury.fstat").out,
            "good/mercury.fstat: contacts (MercuryDPM)\n  frames   2 (times 1 to 2 s)\n  rows     4 to 4 per "
            "frame\n");
  EXPECT_NE(run_program("info --json good/mercury.data").out.find("\"kind\":\"MercuryDPM particles\""),
            std::string::npos);
}

// Twice the same run is the same mean of twice as many frames.
TEST(SeveralRuns, FollowEachOtherThoughTheirStepsBeginAnew) {
  const Folder folder;
  const std::string both = dumps + further_run(folder, 1);
  const Ran one = run_program("average " + dumps + rings);
  const Ran two = run_program("average " + both + rings);
  EXPECT_EQ(two.code, 0) << two.err;
  EXPECT_NE(two.out.find("# runs: 2, one after the other\n"), std::string::npos);
  EXPECT_NE(two.out.find("# frames: 4, steps 100 to 200\n"), std::string::npos);
  expect_same(two.out, one.out, 1e-15);
  // Step 200 of both; frames 1 and 2 are the second one of the first run and the first one of the second.
  EXPECT_NE(run_program("average " + both + rings + " --steps 200:200").out.find("# frames: 2,"),
            std::string::npos);
  expect_same(run_program("average " + both + rings + " --frames 1:2").out, one.out, 1e-15);
}

// As for dumps, and the same numbers; files of one run must still ascend.
TEST(SeveralRuns, MayBeHdf5Files) {
  const Folder folder;
  const std::string file = std::string("'").append(folder.path("run.h5")).append("' ");
  ASSERT_EQ(run_program("convert " + dumps + "--out " + file).code, 0);
  const std::string again = std::string("'").append(folder.path("again.h5")).append("' ");
  ASSERT_EQ(run_program("convert " + dumps + "--timestep 1 --out " + again).code, 0);
  const std::string of_dumps = run_program("average " + dumps + further_run(folder, 1) + rings).out;
  const Ran two = run_program("average --snapshots " + file + "--snapshots " + again + rings);
  EXPECT_EQ(two.code, 0) << two.err;
  EXPECT_NE(two.out.find("# runs: 2, one after the other\n"), std::string::npos);
  EXPECT_EQ(numbers(two.out), numbers(of_dumps));
  EXPECT_EQ(numbers(run_program("average " + file + "--snapshots " + again + rings).out), numbers(of_dumps));
  EXPECT_EQ(
      run_on_ranks(2, "average --snapshots " + file + "--snapshots " + again + rings + " --threads 1").out,
      two.out);
  const std::string last = std::string("'").append(folder.path("last.h5")).append("' ");
  ASSERT_EQ(run_program("convert " + dumps + "--frames 1:1 --out " + last).code, 0);
  const Ran other = run_program("average --snapshots " + file + "--snapshots " + last + rings);
  EXPECT_NE(other.out.find("# frames: 3, steps 100 to 200\n"), std::string::npos);
  const Ran one = run_program("average " + file + file + rings);
  EXPECT_EQ(one.code, 2);
  EXPECT_NE(one.err.find("time steps do not increase"), std::string::npos);
}

// 17 runs of two frames each: 34 blocks of one frame; where 16 are wanted 17 of two, since no more runs can
// be put together.
TEST(SeveralRuns, AreNotMixedInTheBlocksOfErrors) {
  const Folder folder;
  std::string runs;
  for (int run = 0; run < 17; ++run) runs += further_run(folder, run);
  const std::string arguments = "average " + runs + rings + " --threads 1 --error-blocks ";
  EXPECT_NE(run_program(arguments + "64")
                .out.find("# errors: standard errors by the jackknife of 34 blocks of 1 frames"),
            std::string::npos);
  // nan, since the mean of every run is the same.
  const std::string few = run_program(arguments + "16").out;
  EXPECT_NE(few.find("# errors: nan: nothing fluctuates in 17 blocks of 2 frames"), std::string::npos) << few;
  EXPECT_EQ(run_on_ranks(2, arguments + "16").out, few);
}

// What is there twice would make errors too small.
TEST(SeveralRuns, AreRefusedWhereTheyAreOne) {
  const Folder folder;
  const std::string copy = folder.write("copy.dump", read_text(TEST_DATA "/good/particles.dump"));
  std::filesystem::create_symlink(copy, folder.path("link.dump"));
  for (const std::string& file : {std::string("good/particles.dump"), copy, folder.path("link.dump")}) {
    const Ran ran =
        run_program("average " + dumps + "--particles '" + file + "' --contacts good/contacts.dump" + rings);
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.err.find("the same frames are in two runs"), std::string::npos) << ran.err;
  }
  const std::string snapshots = std::string("'").append(folder.path("run.h5")).append("' ");
  ASSERT_EQ(run_program("convert " + dumps + "--out " + snapshots).code, 0);
  EXPECT_EQ(run_program("average " + snapshots + "--snapshots " + snapshots + rings).code, 2);
  // In one file their steps would come twice.
  const Ran both = run_program("convert " + dumps + further_run(folder, 1) + "--out " + snapshots);
  EXPECT_NE(both.err.find("a file holds one run"), std::string::npos) << both.err;
}

TEST(SeveralRuns, AreTheSameOnRanks) {
  const Folder folder;
  const std::string arguments =
      "average " + dumps + further_run(folder, 1) + further_run(folder, 2) + rings + " --threads 1";
  const Ran alone = run_program(arguments);
  EXPECT_EQ(run_on_ranks(2, arguments).out, alone.out);
}

}  // namespace
}  // namespace mikromakro
