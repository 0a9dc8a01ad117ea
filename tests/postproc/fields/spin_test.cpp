// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "measured_error.h"
#include "walled_discs.h"

namespace mikromakro {
namespace {

// Latzel2001 Eq. 4 for the spin, over nu: areas pi and 4 pi, (10 - 4*5)/5.
TEST(Spin, IsWeightedByVolume) {
  Frame frame;
  add_disc(frame, {3, 0}, 1).spin = 10;
  add_disc(frame, {0, 5}, 2).spin = -5;
  expect_measured(RingAverage(frame, whole_ring({"spin"})).at("spin"), -2, few_roundings);
}

}  // namespace
}  // namespace mikromakro
