// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "measured_error.h"
#include "walled_discs.h"

namespace mikromakro {
namespace {

// Latzel2001 Table 2: M = 1/V sum (l x f) l, l = 2 n.
//   l = (1.2, 1.6), f = (-5, 10): l x f = 12 + 8 = 20, times l: (24, 32)
//   l = (-2, 0),    f = (3, 1):   l x f = -2,          times l: (4, 0)
TEST(CoupleStress, IsTheTorqueTimesTheBranch) {
  const Frame frame = disc_between_walls({{{0.6, 0.8}, {-5, 10}}, {{-1, 0}, {3, 1}}});
  const RingAverage average(frame, whole_ring({"couple_stress"}));
  expect_measured(average.at("M_zr") * ring_volume, 28, 10 * few_roundings);
  expect_measured(average.at("M_zphi") * ring_volume, 32, 10 * few_roundings);
}

}  // namespace
}  // namespace mikromakro
