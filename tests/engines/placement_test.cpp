// SPDX-License-Identifier: GPL-2.0-or-later
// create_ring and create_discs in the engine; on two ranks the result of both is compared with that of one
// rank.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine.h"

namespace mikromakro::test {
namespace {

const std::string box = scene("model disc/linear tangential off", {}, 0.5, 4);
const std::string ring = "create_ring 0 0 0.1032 pitch 0.0053 type 3 radius 0.00125 density 6.36\n";
const std::string filling =
    "create_discs ring 0 0 0.1032 0.328 seed 5 density 6.36 discs 500 1 0.00371 uniform 100 2 0.004 0.005 "
    "velocity 0.05\n";

// round(2 pi 103.2/5.3) = 122 discs; m = pi a^2 rho h.
TEST(CreateRing, SpacesDiscsEquallyOnTheCircle) {
  Engine engine;
  engine.run(box + ring);
  const auto discs = engine.discs();
  ASSERT_EQ(discs.size(), 122U);
  for (const auto& [id, disc] : discs) {
    const double angle = 2 * std::numbers::pi * (id - 1) / 122;
    EXPECT_NEAR(disc.x, 0.1032 * std::cos(angle), 1e-16);  // rounding
    EXPECT_NEAR(disc.y, 0.1032 * std::sin(angle), 1e-16);
    EXPECT_EQ(disc.type, 3);
    EXPECT_EQ(disc.radius, 0.00125);
    EXPECT_DOUBLE_EQ(disc.mass, std::numbers::pi * 0.00125 * 0.00125 * 6.36);
  }
}

TEST(CreateDiscs, IdsGoOnAndFollowTheCommand) {
  Engine engine;
  engine.run(box + ring + filling);
  const auto discs = engine.discs();
  ASSERT_EQ(discs.size(), 722U);
  EXPECT_EQ(discs.rbegin()->first, 722);
  EXPECT_EQ(discs.at(122).type, 3);
  EXPECT_EQ(discs.at(123).type, 1);
  EXPECT_EQ(discs.at(622).type, 1);
  EXPECT_EQ(discs.at(623).type, 2);
  EXPECT_GE(discs.at(700).radius, 0.004);
  EXPECT_LE(discs.at(700).radius, 0.005);
}

TEST(CreateDiscs, NoOverlapsWithEachOtherOrTheRing) {
  Engine engine;
  engine.run(box + ring + filling);
  const auto discs = engine.discs();
  for (const auto& [id, a] : discs) {
    for (auto other = discs.begin(); other->first < id; ++other) {
      const Disc& b = other->second;
      if (a.type == 3 && b.type == 3) continue;
      EXPECT_GE(std::hypot(a.x - b.x, a.y - b.y), (a.radius + b.radius) * (1 - 1e-14)) << id;
    }
  }
}

TEST(CreateDiscs, SameToTheLastBitOnAnyNumberOfRanks) {
  Engine one(MPI_COMM_SELF), all(MPI_COMM_WORLD);
  one.run(box + ring + filling);
  all.run(box + ring + filling);
  const auto expected = one.discs();
  const auto discs = all.discs();
  ASSERT_EQ(discs.size(), expected.size());
  for (const auto& [id, disc] : discs) {
    const Disc& other = expected.at(id);
    EXPECT_EQ(disc.type, other.type);
    EXPECT_EQ(disc.radius, other.radius);
    EXPECT_EQ(disc.x, other.x);
    EXPECT_EQ(disc.y, other.y);
    EXPECT_EQ(disc.v_x, other.v_x);
    EXPECT_EQ(disc.v_y, other.v_y);
  }
}

}  // namespace
}  // namespace mikromakro::test
