// SPDX-License-Identifier: GPL-2.0-or-later
// `mikromakro compare` as a user runs it.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "run_program.h"

namespace mikromakro {
namespace {

const std::string good = "--particles good/particles.dump --contacts good/contacts.dump --bulk-types 1 ";
const std::string cell =
    "--particles reference/couette_small_particles.dump.gz --contacts "
    "reference/couette_small_contacts.dump.gz --height 0.006 --bulk-types 1,2 --rings 0.1032 0.1782 10 ";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (!line.starts_with('#')) lines.push_back(line);
  return lines;
}

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

// Names of columns, and the rows, of `average` with one weight and so many rings, behind weight and
// resolution.
std::vector<std::string> average(const std::string& weight, int rings) {
  const Ran ran = run_program("average " + good + "--error-blocks 0 --rings 0 4 " + std::to_string(rings) +
                              " --weight " + weight);
  EXPECT_EQ(ran.code, 0) << ran.err;
  std::vector<std::string> lines = lines_of(ran.out);
  for (std::size_t i = 0; i < lines.size(); ++i)
    lines[i] = (i == 0 ? "weight,resolution," : weight + "," + std::to_string(rings) + ",") + lines[i];
  return lines;
}

// One pass with four averages gives the numbers of four passes, to the last digit.
TEST(Compare, WritesTheRowsThatAverageGives) {
  const Folder folder;
  const Ran ran =
      run_program("compare " + good + "--rings 0 4 1 --weights sliced,gauss:0.5 --resolutions 1,3 --out '" +
                  folder.path("all.csv") + "'");
  ASSERT_EQ(ran.code, 0) << ran.err;
  std::vector<std::string> expected = average("sliced", 1);
  for (const auto& [weight, rings] : {std::pair{"gauss:0.5", 1}, {"sliced", 3}, {"gauss:0.5", 3}}) {
    const std::vector<std::string> more = average(weight, rings);
    expected.insert(expected.end(), more.begin() + 1, more.end());
  }
  EXPECT_EQ(lines_of(read_text(folder.path("all.csv"))), expected);
}

// All three free discs lie in the ring by their area; by its centre, disc 7 at (1, 0), 3 at (1.9, 0), both
// with a = 0.5, and 20 at (0, -2) with a = 0.25 count in 0..1.5: of 7 all against all, nothing of 3 against a
// slice: so only nu of that slice differs. In 1.5..4: the rest. nu V/pi = 1/4 + s, 1/4 - s + 1/16, s the
// slice's part of 1/4.
TEST(Compare, PrintsDifferencesOfTheWeights) {
  const Ran ran = run_program("compare " + good + "--edges 0,1.5,4 --fields solid_fraction");
  ASSERT_EQ(ran.code, 0) << ran.err;
  const std::vector<std::string> lines = lines_of(ran.out);
  // Four columns below two lines; an empty line and the summary of five.
  ASSERT_EQ(lines.size(), 12U);
  EXPECT_EQ(lines[0], "differences from the weight sliced");
  EXPECT_EQ(lines[1].substr(0, 6), "column");
  const std::vector<std::string> sliced = lines_of(
      run_program("average " + good + "--edges 0,1.5,4 --fields solid_fraction --error-blocks 0").out);
  const auto nu_of = [](const std::string& row) {
    std::istringstream stream(row);
    std::string number;
    for (int i = 0; i < 4; ++i) std::getline(stream, number, ',');
    return std::stod(number);
  };
  const double first = nu_of(sliced[1]) - 0.25 / 2.25;
  const double second = nu_of(sliced[2]) - (0.25 + 0.0625) / 13.75;
  const std::vector<std::string> words = words_of(lines[2]);
  ASSERT_EQ(words.size(), 11U) << lines[2];
  EXPECT_EQ(words[0] + words[1] + words[2] + words[3], "nu12centre");
  // Four digits are printed.
  const double mean = (std::abs(first) + std::abs(second)) / 2;
  EXPECT_NEAR(std::stod(words[4]) / mean, 1, 6e-4);
  EXPECT_NEAR(std::stod(words[5]) / std::abs(first), 1, 6e-4);
  const double rms =
      std::sqrt((nu_of(sliced[1]) * nu_of(sliced[1]) + nu_of(sliced[2]) * nu_of(sliced[2])) / 2);
  EXPECT_NEAR(std::stod(words[6]) / (mean / rms), 1, 6e-4);
  EXPECT_EQ(words[8] + words[9] + words[10], "0of2");
  EXPECT_EQ(lines[7], "summary: 4 columns, resolutions 2; mean differences over the rms of sliced");
  double most = 0;
  for (std::size_t i = 2; i < 6; ++i) most = std::fmax(most, std::stod(words_of(lines[i])[6]));
  // Two digits are printed.
  EXPECT_NEAR(std::stod(words_of(lines[9])[2]) / most, 1, 0.05) << lines[9];
  EXPECT_EQ(lines[10],
            "  fine ones add up to coarse ones: one resolution, or no columns that are sums over V");
}

// Finer rings divide the coarser ones, whatever the weight: 1e-10 is what kernels promise.
TEST(Compare, FineAveragesAddUpToTheCoarseOnesWhereTheyAreSums) {
  const Ran ran =
      run_program("compare " + cell +
                  "--weights sliced,centre,gauss:0.004,wendland:0.006,tophat:0.004 --resolutions 30,10");
  ASSERT_EQ(ran.code, 0) << ran.err;
  const std::size_t begin = ran.out.find("differences of resolutions");
  ASSERT_NE(begin, std::string::npos);
  const std::size_t end = ran.out.find("\nsummary: ");
  ASSERT_NE(end, std::string::npos);
  const std::vector<std::string> summary = lines_of(ran.out.substr(end + 1));
  ASSERT_EQ(summary.size(), 5U);
  // "fine ones add up to coarse ones: to 1e-11, ..."
  EXPECT_LT(std::stod(words_of(summary[3])[8]), 1e-10) << summary[3];
  const std::vector<std::string> lines = lines_of(ran.out.substr(begin, end - begin));
  // nu, nu_1, nu_2, nu_3, four of F and of sigma, two of M, of five weights
  ASSERT_EQ(lines.size(), 2 + 14U * 5);
  for (std::size_t i = 2; i < lines.size(); ++i) {
    const std::vector<std::string> words = words_of(lines[i]);
    ASSERT_EQ(words.size(), 8U) << lines[i];
    EXPECT_EQ(words[2] + " " + words[3], "10 30");
    EXPECT_LT(std::stod(words[5]), 1e-10) << lines[i];
    EXPECT_GT(std::stod(words[7]), 1e-3) << lines[i];
  }
}

TEST(Compare, GridsKeepTheirProportion) {
  const Folder folder;
  const Ran ran =
      run_program("compare " + good + "--grid -4 4 4 -4 0 2 --weights sliced,lucy:1 --resolutions 6 --out '" +
                  folder.path("grid.csv") + "'");
  ASSERT_EQ(ran.code, 0) << ran.err;
  // 6 by 3 cells of two weights
  EXPECT_EQ(lines_of(read_text(folder.path("grid.csv"))).size(), 1 + 2U * 18);
}

TEST(Compare, GivesTheSameOnThreadsAndRanks) {
  const std::string arguments =
      "compare " + good + "--rings 0 4 2 --weights sliced,gauss:0.3 --resolutions 2,5 ";
  const Ran one = run_program(arguments + "--threads 1");
  ASSERT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(run_program(arguments + "--threads 3").out, one.out);
  EXPECT_EQ(run_on_ranks(2, arguments).out, one.out);
}

}  // namespace
}  // namespace mikromakro
