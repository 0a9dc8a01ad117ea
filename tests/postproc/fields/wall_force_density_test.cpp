// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "measured_error.h"
#include "walled_discs.h"

namespace mikromakro {
namespace {

// Weinhart2012: t = 1/V sum of the forces of walls and wall discs on free discs. Disc 1 at (19, 0) feels (-3,
// 4) from a wall, 100 * 0.1 = 10 along -e_phi from a wall disc, and a free disc beyond the ring, which does
// not count.
TEST(WallForceDensity, IsTheForceOfWallsAndWallDiscs) {
  Frame frame;
  add_disc(frame, {19, 0}, 1, {{{1, 0}, {-3, 4}}});
  add_disc(frame, {20.9, 0}, 1);
  add_disc(frame, {19, 1.9}, 1).type = 2;
  frame.contacts.push_back(make_contact(frame, 1, 0, 100));
  frame.contacts.push_back(make_contact(frame, 2, 0, 100));
  RingSetup setup = whole_ring({"wall_force_density"});
  setup.weight = "centre";
  setup.options.bulk_types = {1};
  const RingAverage average(frame, setup);
  expect_measured(average.at("wall_force_density_r") * ring_volume, -3, 10 * few_roundings);
  // The overlap 2 - 1.9 has lost two digits.
  expect_measured(average.at("wall_force_density_phi") * ring_volume, -6, 1000 * few_roundings);
}

}  // namespace
}  // namespace mikromakro
