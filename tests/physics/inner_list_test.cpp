// SPDX-License-Identifier: GPL-2.0-or-later
#include "physics/contact/inner_list.h"

#include <gtest/gtest.h>

#include <vector>

namespace mikromakro::physics {
namespace {

/// Discs of radius 1 on a line; gaps 0.5, 0.25, 0.125 from the first on, exact in binary.
const std::vector<DiscRow> discs = {DiscRow::of(0, 0, 1), DiscRow::of(2.5, 0, 1), DiscRow::of(4.75, 0, 1),
                                    DiscRow::of(6.875, 0, 1)};
const std::vector<DiscPair> pairs = {{0, 1}, {1, 2}, {0, 2}, {2, 3}};

std::vector<int> found(const std::vector<char>& touched, double gap) {
  InnerList near;
  near.prune(pairs, discs.data(), touched, gap);
  std::vector<int> numbers;
  for (int k = 0; k < near.size(); ++k) {
    numbers.push_back(near.number(k));
    EXPECT_EQ(near.from(k)->i, pairs[near.number(k)].i);
    EXPECT_EQ(near.from(k)->j, pairs[near.number(k)].j);
  }
  return numbers;
}

TEST(InnerList, HasThePairsWhoseGapIsNotLarger) {
  EXPECT_EQ(found({}, 0.5), (std::vector<int>{0, 1, 3}));
  EXPECT_EQ(found({}, 0.25), (std::vector<int>{1, 3}));
  EXPECT_EQ(found({}, 0.0625), (std::vector<int>{}));
}

TEST(InnerList, HasThoseThatTouchedToo) {
  EXPECT_EQ(found({0, 0, 1, 0}, 0.25), (std::vector<int>{1, 2, 3}));
}

TEST(InnerList, KeepsTheSpringsThatItIsGiven) {
  InnerList near;
  near.prune(pairs, discs.data(), {1, 0, 0, 1}, 0);
  near.set_spring(0, true, 1e-6, 2e-3);
  near.set_spring(1, true, 3e-6, 4e-3);
  const SpringLanes& springs = near.springs(0);
  EXPECT_EQ(springs.xi[1], 3e-6);
  EXPECT_EQ(springs.slip_rate[0], 2e-3);
  EXPECT_NE(springs.touched[0], 0);
}

/// Each pair has a lane of its own, in the batch that it belongs to.
TEST(InnerList, HasSpringsInTheirLanes) {
  const int count = 2 * ContactBatch::lanes + 3;
  const std::vector<DiscPair> many(count, {0, 1});
  InnerList near;
  near.prune(many, discs.data(), std::vector<char>(many.size(), 1), 0);
  for (int k = 0; k < count; ++k) near.set_spring(k, k % 3 == 0, 1 + k, -1 - k);
  for (int first = 0; first < count; first += ContactBatch::lanes) {
    auto& springs = near.springs(first);
    for (int k = 0; k < ContactBatch::lanes && first + k < count; ++k) {
      EXPECT_EQ(springs.xi[k], 1 + first + k);
      EXPECT_EQ(springs.slip_rate[k], -1 - first - k);
      EXPECT_EQ(springs.touched[k], (first + k) % 3 == 0 ? 1 : 0);
      springs.xi[k] *= 2;
    }
  }
  for (int k = 0; k < count; ++k) EXPECT_EQ(near.xi(k), 2 * (1 + k));
}

/// The sum of the costs, as in the comment of inner_gap(), is larger on either side of it.
TEST(InnerGap, CostsLeast) {
  const double path = 1e-6, skin = 8e-4;
  const auto cost = [&](double gap) { return 4.0 / 3 * path / gap + 0.55 * std::sqrt(gap / skin); };
  const double gap = inner_gap(path, skin);
  EXPECT_LT(cost(gap), cost(1.1 * gap));
  EXPECT_LT(cost(gap), cost(gap / 1.1));
}

TEST(InnerGap, StaysWithinTheSkin) {
  EXPECT_EQ(inner_gap(0, 8e-4), 8e-6);
  EXPECT_EQ(inner_gap(1, 8e-4), 8e-4);
}

}  // namespace
}  // namespace mikromakro::physics
