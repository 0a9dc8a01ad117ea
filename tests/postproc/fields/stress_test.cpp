// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "measured_error.h"
#include "walled_discs.h"

namespace mikromakro {
namespace {

// Latzel2001 Eq. 16: sigma = 1/V sum f (x) l with l = a n, a = 2.
//   n = (0.6, 0.8), f = (-5, 10): l = (1.2, 1.6), f (x) l = (-6, -8; 12, 16)
//   n = (-1, 0),    f = (3, 1):   l = (-2, 0),    f (x) l = (-6, 0; -2, 0)
TEST(Stress, IsTheDyadOfForceAndBranch) {
  const Frame frame = disc_between_walls({{{0.6, 0.8}, {-5, 10}}, {{-1, 0}, {3, 1}}});
  const RingAverage average(frame, whole_ring({"stress"}));
  expect_measured(average.at("sigma_rr") * ring_volume, -12, 10 * few_roundings);
  expect_measured(average.at("sigma_rphi") * ring_volume, -8, 10 * few_roundings);
  expect_measured(average.at("sigma_phir") * ring_volume, 10, 10 * few_roundings);
  expect_measured(average.at("sigma_phiphi") * ring_volume, 16, 10 * few_roundings);
}

}  // namespace
}  // namespace mikromakro
