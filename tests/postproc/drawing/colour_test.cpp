// SPDX-License-Identifier: GPL-2.0-or-later
#include "drawing/colour.h"

#include <gtest/gtest.h>

namespace mikromakro {
namespace {

// L* of sRGB: black 0, white 100, and 18.42 % grey (0.4663) is the middle, 50.
TEST(Lightness, OfKnownGreys) {
  EXPECT_NEAR(lightness({0, 0, 0, 1}), 0, 1e-12);
  EXPECT_NEAR(lightness({1, 1, 1, 1}), 100, 1e-3);                // the luminance weights have four digits
  EXPECT_NEAR(lightness({0.4663, 0.4663, 0.4663, 1}), 50, 1e-2);  // four digits of the grey
}

TEST(Viridis, CanBeReadInGrey) {
  for (int i = 1; i <= 100; ++i) EXPECT_GT(lightness(viridis(0.01 * i)), lightness(viridis(0.01 * (i - 1))));
}

// L* from 15 to 91; a tenth of the way is a tenth of it within a quarter of such a step.
TEST(Viridis, IsEvenInLightness) {
  const double low = lightness(viridis(0));
  const double step = (lightness(viridis(1)) - low) / 10;
  EXPECT_GT(step, 7);
  for (int i = 1; i < 10; ++i) EXPECT_NEAR(lightness(viridis(0.1 * i)), low + i * step, 0.25 * step) << i;
}

TEST(Viridis, BeyondTheEndsIsTheEnd) {
  EXPECT_EQ(viridis(-1).red, viridis(0).red);
  EXPECT_EQ(viridis(7).blue, viridis(1).blue);
}

}  // namespace
}  // namespace mikromakro
