// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "measured_error.h"
#include "walled_discs.h"

namespace mikromakro {
namespace {

// Latzel2001 Eq. 5: v = sum V^p v^p/sum V^p. Areas pi and 4 pi. Disc 1 at (3, 0): v = (1, 2) is v_r = 1,
// v_phi = 2; disc 2 at (0, 5): e_r = (0, 1), e_phi = (-1, 0), so v = (3, -1) is v_r = -1, v_phi = -3. v_r =
// (1 - 4)/5, v_phi = (2 - 12)/5.
TEST(Velocity, IsWeightedByVolumeInThePolarBasis) {
  Frame frame;
  add_disc(frame, {3, 0}, 1).velocity = {1, 2};
  add_disc(frame, {0, 5}, 2).velocity = {3, -1};
  const RingAverage average(frame, whole_ring({"velocity"}));
  expect_measured(average.at("v_r"), -0.6, few_roundings);
  expect_measured(average.at("v_phi"), -2, few_roundings);
}

}  // namespace
}  // namespace mikromakro
