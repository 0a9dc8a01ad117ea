// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "measured_error.h"
#include "walled_discs.h"

namespace mikromakro {
namespace {

// Latzel2001 Eq. 10: C by number, whatever the radii: (2 + 1 + 0)/3.
TEST(NumberCoordination, CountsEachDiscOnce) {
  Frame frame;
  add_disc(frame, {10, 0}, 1, {{{1, 0}}, {{0, 1}}});
  add_disc(frame, {-10, 0}, 2, {{{1, 0}}});
  add_disc(frame, {0, 10}, 3);
  const RingAverage average(frame, whole_ring({"coordination_number_averaged"}));
  expect_measured(average.at("coordination_number_averaged"), 1, few_roundings);
}

}  // namespace
}  // namespace mikromakro
