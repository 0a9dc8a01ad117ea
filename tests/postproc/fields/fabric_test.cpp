// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "measured_error.h"
#include "walled_discs.h"

namespace mikromakro {
namespace {

// Latzel2001 Table 1: F = 1/V sum V^p sum n (x) n. Disc 1: V^p/V = 0.01, n = (1, 0) and (0.6, 0.8), n (x) n =
// (1, 0; 0, 0) + (0.36, 0.48; 0.48, 0.64). Disc 2 of radius 1 at (0, 10): V^p/V = 0.0025, n = (1, 0) is
// -e_phi there: 1 in phiphi.
TEST(Fabric, IsTheDyadOfNormalsWeightedByVolume) {
  Frame frame = disc_between_walls({{{1, 0}}, {{0.6, 0.8}}});
  add_disc(frame, {0, 10}, 1, {{{1, 0}}});
  const RingAverage average(frame, whole_ring({"fabric"}));
  expect_measured(average.at("F_rr"), 0.0136, few_roundings);
  expect_measured(average.at("F_rphi"), 0.0048, few_roundings);
  expect_measured(average.at("F_phir"), 0.0048, few_roundings);
  expect_measured(average.at("F_phiphi"), 0.0064 + 0.0025, few_roundings);
}

}  // namespace
}  // namespace mikromakro
