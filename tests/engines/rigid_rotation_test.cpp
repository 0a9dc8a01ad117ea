// SPDX-License-Identifier: GPL-2.0-or-later
// A pair in contact that turns as a rigid body does not slip: spring and forces stay what they are.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine.h"

namespace mikromakro::test {
namespace {

constexpr double radius = 3.71e-3, overlap = 1e-4, steps_per_turn = 100, dt = 1e-5;

/// Two discs of different size, sheared until the spring is stretched, then carried around a point beside
/// them by the stock fix move, which sets positions, velocities and spins of a rigid rotation. A third disc
/// far away is integrated, so that the law works as with fix nve/disc.
Contact start_turning(Engine& engine) {
  engine.run(scene("model disc/linear tangential disc/cundall_strack", {}, 0.1, 1));
  engine.run(disc(1, 0, 0, radius) + disc(2, 1.8 * radius - overlap, 0, 0.8 * radius) +
             disc(3, 0.08, 0.08, radius));
  engine.run("group pair id 1 2\ngroup second id 2\ngroup other id 3\nfix integrate other nve/disc\n");
  engine.run(fmt::format("compute contacts all contact/disc\ntimestep {}\n", dt));
  engine.run("fix shear second move linear 0 0.02 0 units box\nrun 100\nunfix shear\n");
  engine.run(
      fmt::format("fix turn pair move rotate 0.002 0.003 0 0 0 1 {:.17g} units box\n", steps_per_turn * dt));
  // The jump of the slip rate dies out with 3^-n.
  engine.run("run 100\n");
  return engine.contacts().at({1, 2});
}

void expect_unchanged_after(int turns, double tolerance) {
  Engine engine;
  const auto before = start_turning(engine);
  ASSERT_GT(std::abs(before.xi), 1e-5);               // 0.02 m/s for 1 ms: 2e-5 m
  ASSERT_LT(std::abs(before.f_t), 0.4 * before.f_n);  // sticking, below mu = 0.44
  engine.run(fmt::format("run {}\n", std::lround(turns * steps_per_turn)));
  const auto after = engine.contacts().at({1, 2});
  std::printf("after %d turns: xi off by %.1e, f_n by %.1e, f_t by %.1e\n", turns, after.xi / before.xi - 1,
              after.f_n / before.f_n - 1, after.f_t / before.f_t - 1);
  EXPECT_NEAR(after.xi / before.xi, 1, tolerance);
  EXPECT_NEAR(after.f_n / before.f_n, 1, tolerance);
  EXPECT_NEAR(after.f_t / before.f_t, 1, tolerance);
  // A quarter of a turn and a bit further: the normal has turned with the pair.
  engine.run("run 27\n");
  const auto later = engine.contacts().at({1, 2});
  const double angle =
      std::remainder(std::atan2(later.n_y, later.n_x) - std::atan2(after.n_y, after.n_x), 2 * M_PI);
  EXPECT_NEAR(angle, 2 * M_PI * 27 / steps_per_turn, 1e-9);
  EXPECT_NEAR(later.f_t / before.f_t, 1, tolerance);
}

// Positions of 0.01 m are rounded to 1e-18 m, 1e-14 of the overlap. The slip of a step is rounded to 1e-16 of
// the rim's path of 2e-4 m, 2e-20 m: even if every rounding of 1e5 steps had the same sign, 2e-15 m or 1e-10
// of xi.
TEST(RigidRotation, KeepsSpringAndForcesForAThousandTurnsOfManySteps) {
  expect_unchanged_after(1000, 1e-9);
}

TEST(RigidRotation, KeepsSpringAndForcesAcrossTheBorderOfTheRanks) {
  expect_unchanged_after(20, 1e-10);
}

}  // namespace
}  // namespace mikromakro::test
