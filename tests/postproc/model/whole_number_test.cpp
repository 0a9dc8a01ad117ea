// SPDX-License-Identifier: GPL-2.0-or-later
// Which numbers of a file may be ids, types and counts.
#include "model/whole_number.h"

#include <gtest/gtest.h>

#include <limits>

namespace mikromakro {
namespace {

constexpr double largest = 9007199254740992;  // 2^53: beyond it a double does not hold all whole numbers

TEST(WholeNumber, IsOneThatADoubleHoldsExactly) {
  for (const double number : {0.0, 1.0, -1001.0, largest, -largest})
    EXPECT_TRUE(is_integer(number)) << number;
  for (const double number :
       {0.5, 1 + 1e-15, largest + 2, -largest - 2, 1e300, std::numeric_limits<double>::infinity(),
        std::numeric_limits<double>::quiet_NaN()})
    EXPECT_FALSE(is_integer(number)) << number;
}

TEST(WholeNumber, AnythingElseIsAnError) {
  EXPECT_EQ(as_integer(7, "id", {"file", 3}), 7);
  EXPECT_THROW(as_integer(7.5, "id", {"file", 3}), Error);
  EXPECT_THROW(as_integer(largest + 2, "id", {"file", 3}), Error);
}

}  // namespace
}  // namespace mikromakro
