// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "measured_error.h"
#include "walled_discs.h"

namespace mikromakro {
namespace {

// E = tr sigma/tr eps (Latzel2001 Bild 9), G = dev sigma/dev eps (Bild 10), l = 2 n:
//   n = (1, 0), f = (-10, -6), overlap 0.2;  n = (0, 1), f = (0, -2), overlap 0.1
//   V sigma = (-20, 0; -12, -4): tr -24, dev sqrt(16^2 + 12^2) = 20
//   eps = (-0.1, 0; 0, -0.05): tr -0.15, dev 0.05
// In k_n/h = 4/0.5 = 8 an eighth of E = 160/V, G = 400/V.
TEST(Stiffness, IsTheQuotientOfInvariants) {
  const Frame frame = disc_between_walls({{{1, 0}, {-10, -6}, 0.2}, {{0, 1}, {0, -2}, 0.1}});
  RingSetup setup = whole_ring({"stiffness"});
  const RingAverage in_pascal(frame, setup);
  expect_measured(in_pascal.at("E") * ring_volume / 160, 1, few_roundings);
  expect_measured(in_pascal.at("G") * ring_volume / 400, 1, few_roundings);
  setup.field_options.normal_stiffness = 4;
  const RingAverage in_units(frame, setup);
  expect_measured(in_units.at("E") * ring_volume / 20, 1, few_roundings);
  expect_measured(in_units.at("G") * ring_volume / 50, 1, few_roundings);
}

}  // namespace
}  // namespace mikromakro
