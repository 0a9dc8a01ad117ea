// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/nearest_name.h"

#include <gtest/gtest.h>

namespace mikromakro {
namespace {

constexpr std::string_view names[] = {"stress", "spin", "solid_fraction", "stress_axes"};

TEST(EditDistance, CountsLettersThatChange) {
  EXPECT_EQ(edit_distance("stress", "stress"), 0U);
  EXPECT_EQ(edit_distance("stres", "stress"), 1U);    // one left out
  EXPECT_EQ(edit_distance("strress", "stress"), 1U);  // one too many
  EXPECT_EQ(edit_distance("strass", "stress"), 1U);   // one exchanged
  EXPECT_EQ(edit_distance("sterss", "stress"), 1U);   // two swapped
  EXPECT_EQ(edit_distance("", "spin"), 4U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(NearestName, IsTheOneThatWasMeant) {
  EXPECT_EQ(nearest_name("stres", names), "stress");
  EXPECT_EQ(nearest_name("solidfraction", names), "solid_fraction");
  EXPECT_EQ(nearest_name("spn", names), "spin");
}

TEST(NearestName, MayBeLeftUnfinished) {
  EXPECT_EQ(nearest_name("solid_fr", names), "solid_fraction");
  EXPECT_EQ(nearest_name("so", names), "");
}

// A third of the letters of 'mass' is one, and three would have to change.
TEST(NearestName, IsNoneWhereNothingIsNear) {
  EXPECT_EQ(nearest_name("mass", names), "");
  EXPECT_EQ(nearest_name("", names), "");
  EXPECT_EQ(nearest_name(std::string(100000, 'x'), names), "");
}

TEST(NearestName, StandsBehindWhatWasGiven) {
  EXPECT_EQ(in_quotes_with_guess("stres", names), "'stres' (did you mean 'stress'?)");
  EXPECT_EQ(in_quotes_with_guess("mass", names), "'mass'");
}

}  // namespace
}  // namespace mikromakro
