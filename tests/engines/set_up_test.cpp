// SPDX-License-Identifier: GPL-2.0-or-later
// What the set-up of a run does to contacts that are there already: no time goes by in it, and none is lost.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "engine.h"

namespace mikromakro::test {
namespace {

constexpr double slip_rate = 0.1, dt = 1e-5;

/// Two heavy discs that touch at first and slide past each other, which no force slows down noticeably: their
/// spring is as long as the way they have gone. k_t dt^2 / m is 1e-10, the turn of the normal 1e-3 in ten
/// steps, of which cos makes 1e-6.
std::string sliding_pair(const std::string& law) {
  return scene(law, {.mu = 5000}, 1, 1) + disc(1, 0, 0, 0.004, 6.36e6) + disc(2, 0.0079, 0, 0.004, 6.36e6) +
         motion(1, 0, slip_rate, 0) + "compute contacts all contact/disc\nthermo_modify lost error\n";
}

const std::string integration = "fix integrate all nve/disc\ntimestep 1e-5\n";

class SetUp : public testing::TestWithParam<const char*> {
 protected:
  void expect_spring_of(int steps) {
    const double way = steps * slip_rate * dt;
    EXPECT_NEAR(engine_.contacts().at({1, 2}).xi, way, 1e-6 * way) << steps << " steps";
  }
  Engine engine_;
};

INSTANTIATE_TEST_SUITE_P(
    OfEachLaw, SetUp,
    testing::Values("model disc/linear tangential disc/cundall_strack",
                    "model disc/linear tangential disc/cundall_strack tangential_damping on",
                    "model disc/hertz tangential disc/cundall_strack"),
    [](const auto& info) { return "law_" + std::to_string(info.index); });

// The discs slide by 1e-6 m in a step; with a slip rate that the set-up forgets, the spring was 6.67e-7 m.
TEST_P(SetUp, LosesNoSlipOfContactsThatAreThere) {
  for (const int steps : {1, 2, 3}) {
    engine_.run("clear\n" + sliding_pair(GetParam()) + integration + "run " + std::to_string(steps) + "\n");
    expect_spring_of(steps);
  }
}

TEST_P(SetUp, OfAFurtherRunGoesOnWithTheSpring) {
  engine_.run(sliding_pair(GetParam()) + integration + "run 1\nrun 1\nrun 0\nrun 3\n");
  expect_spring_of(5);
}

TEST_P(SetUp, OfARunFromAFileGoesOnWithTheSpring) {
  int number = getpid();
  MPI_Bcast(&number, 1, MPI_INT, 0, MPI_COMM_WORLD);
  const std::string file = testing::TempDir() + "set_up_" + std::to_string(number);
  for (const int steps : {0, 1}) {
    engine_.run("clear\n" + sliding_pair(GetParam()) + integration + "run " + std::to_string(steps) +
                "\nwrite_restart " + file +
                "\nclear\nnewton off\ncommunicate single vel yes\natom_modify map array\nread_restart " +
                file + "\nneigh_modify delay 0\n" + constants({.mu = 5000}, 1) + integration +
                "compute contacts all contact/disc\nrun 2\n");
    expect_spring_of(steps + 2);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  std::remove(file.c_str());
}

// A contact that is made between two runs has slipped by nothing in the set-up.
TEST_P(SetUp, BeginsContactsThatWereMadeBetweenTwoRuns) {
  engine_.run(sliding_pair(GetParam()) + integration +
              "group second id 2\ndisplace_atoms second move 0.0002 0 0 units box\n"
              "run 3\ndisplace_atoms second move -0.0002 0 0 units box\nrun 2\n");
  expect_spring_of(2);
}

}  // namespace
}  // namespace mikromakro::test
