// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/numbered_name.h"

#include <gtest/gtest.h>

namespace mikromakro {
namespace {

TEST(NumberedName, HasTheIndexWhereItIsWanted) {
  EXPECT_EQ(numbered_name("a/f.png", 3, 1), "a/f.png");
  EXPECT_EQ(numbered_name("a/f.png", 3, 5), "a/f_0003.png");
  EXPECT_EQ(numbered_name("a/f%d.png", 3, 5), "a/f3.png");
  EXPECT_EQ(numbered_name("a/f%03d.png", 3, 1), "a/f003.png");
  EXPECT_EQ(numbered_name("50%.png", 3, 1), "50%.png");
}

}  // namespace
}  // namespace mikromakro
