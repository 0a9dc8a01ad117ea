#include "physics/near_pairs.h"

#include <gtest/gtest.h>

#include <vector>

namespace mikromakro::physics {
namespace {

/// Discs of radius 1 on a line; gaps 0.5, 0.25, 0.125 from the first on, exact in binary.
const std::vector<DiscRow> discs = {DiscRow::of(0, 0, 1), DiscRow::of(2.5, 0, 1), DiscRow::of(4.75, 0, 1),
                                    DiscRow::of(6.875, 0, 1)};
const std::vector<DiscPair> pairs = {{0, 1}, {1, 2}, {0, 2}, {2, 3}};

std::vector<int> found(const std::vector<char>& touched, double gap) {
  NearPairs near;
  near.find(pairs, discs.data(), touched, gap);
  std::vector<int> numbers;
  for (int k = 0; k < near.size(); ++k) {
    numbers.push_back(near.number(k));
    EXPECT_EQ(near.from(k)->i, pairs[near.number(k)].i);
    EXPECT_EQ(near.from(k)->j, pairs[near.number(k)].j);
  }
  return numbers;
}

TEST(NearPairs, AreThoseWhoseGapIsNotLarger) {
  EXPECT_EQ(found({}, 0.5), (std::vector<int>{0, 1, 3}));
  EXPECT_EQ(found({}, 0.25), (std::vector<int>{1, 3}));
  EXPECT_EQ(found({}, 0.0625), (std::vector<int>{}));
}

TEST(NearPairs, AreThoseThatTouchedToo) {
  EXPECT_EQ(found({0, 0, 1, 0}, 0.25), (std::vector<int>{1, 2, 3}));
}

TEST(NearPairs, KeepTheSpringsThatTheyAreGiven) {
  NearPairs near;
  near.find(pairs, discs.data(), {1, 0, 0, 1}, 0);
  near.set_spring(0, true, 1e-6, 2e-3);
  near.set_spring(1, true, 3e-6, 4e-3);
  ContactBatch batch;
  near.load_springs(batch, 0, 2);
  EXPECT_EQ(batch.xi[1], 3e-6);
  EXPECT_EQ(batch.slip_rate[0], 2e-3);
  EXPECT_NE(batch.touched[0], 0);
}

/// Every number of lanes, and no lane beside them.
TEST(NearPairs, GiveSpringsToTheLanesAndTakeThemBack) {
  const std::vector<DiscPair> many(ContactBatch::lanes, {0, 1});
  for (int count = 1; count <= ContactBatch::lanes; ++count) {
    NearPairs near;
    near.find(many, discs.data(), std::vector<char>(many.size(), 1), 0);
    for (int k = 0; k < near.size(); ++k) near.set_spring(k, k % 3 == 0, 1 + k, -1 - k);
    ContactBatch batch;
    near.load_springs(batch, 0, count);
    for (int k = 0; k < count; ++k) {
      EXPECT_EQ(batch.xi[k], 1 + k);
      EXPECT_EQ(batch.slip_rate[k], -1 - k);
      EXPECT_EQ(batch.touched[k], k % 3 == 0 ? 1 : 0);
      batch.xi[k] *= 2;
      batch.slip_rate[k] *= 3;
    }
    near.store_springs(batch, 0, count);
    for (int k = 0; k < near.size(); ++k) {
      EXPECT_EQ(near.xi(k), k < count ? 2 * (1 + k) : 1 + k);
      EXPECT_EQ(near.slip_rate(k), k < count ? -3 * (1 + k) : -1 - k);
    }
  }
}

/// The sum of the costs, as in the comment of near_gap(), is larger on either side of it.
TEST(NearGap, CostsLeast) {
  const double path = 1e-6, skin = 8e-4;
  const auto cost = [&](double gap) { return 4.0 / 3 * path / gap + 0.55 * std::sqrt(gap / skin); };
  const double gap = near_gap(path, skin);
  EXPECT_LT(cost(gap), cost(1.1 * gap));
  EXPECT_LT(cost(gap), cost(gap / 1.1));
}

TEST(NearGap, StaysWithinTheSkin) {
  EXPECT_EQ(near_gap(0, 8e-4), 8e-6);
  EXPECT_EQ(near_gap(1, 8e-4), 8e-4);
}

}  // namespace
}  // namespace mikromakro::physics
