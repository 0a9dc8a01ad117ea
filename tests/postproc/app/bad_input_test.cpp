// SPDX-License-Identifier: GPL-2.0-or-later
// Every file of tests/data/bad, with the arguments and the line of its case in cases.txt, through the real
// program.
#include <gtest/gtest.h>

#include <fstream>
#include <ostream>
#include <vector>

#include "run_program.h"

namespace mikromakro {
namespace {

struct BadCase {
  std::string name;
  std::string arguments;
  std::string message;
};

void PrintTo(const BadCase& bad, std::ostream* stream) {
  *stream << bad.arguments;
}

// Blocks of three lines (name, arguments, expected line on stderr), empty lines and # lines between them.
std::vector<BadCase> read_cases() {
  std::ifstream stream(std::string(TEST_DATA) + "/bad/cases.txt");
  std::vector<BadCase> cases;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line[0] == '#') continue;
    BadCase bad{line, "", ""};
    std::getline(stream, bad.arguments);
    std::getline(stream, bad.message);
    cases.push_back(bad);
  }
  return cases;
}

class BadInput : public testing::TestWithParam<BadCase> {};

TEST_P(BadInput, GivesOneLineAndNoOutput) {
  const Folder folder;
  std::string arguments = GetParam().arguments;
  if (arguments.starts_with("average ")) arguments += " --out '" + folder.path("out.csv") + "'";
  const Ran ran = run_program(arguments, std::string(TEST_DATA) + "/bad");
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.err, GetParam().message + "\n");
  EXPECT_EQ(ran.out, "");
  EXPECT_TRUE(folder.empty());
}

TEST(BadInputCases, AreThere) {
  EXPECT_GE(read_cases().size(), 40U);
}

INSTANTIATE_TEST_SUITE_P(Folder, BadInput, testing::ValuesIn(read_cases()),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace mikromakro
