// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "measured_error.h"
#include "walled_discs.h"

namespace mikromakro {
namespace {

// -1/V sum m v' (x) v'. Masses 1 and 3 on the x axis (e_r = e_x), v = (2, 0) and (-2, 4): u = (2 - 6, 12)/4 =
// (-1, 3), v' = (3, -3) and (-1, 1): sum m v' v' = 9 + 3 = 12 in rr and phiphi, -9 - 3 = -12 in rphi.
TEST(KineticStress, IsThatOfTheFluctuations) {
  Frame frame;
  add_disc(frame, {3, 0}, 1).velocity = {2, 0};
  add_disc(frame, {6, 0}, 1).velocity = {-2, 4};
  frame.particles[1].mass = 3;
  const RingAverage average(frame, whole_ring({"kinetic_stress"}));
  expect_measured(average.at("sigma_kin_rr") * ring_volume, -12, 10 * few_roundings);
  expect_measured(average.at("sigma_kin_rphi") * ring_volume, 12, 10 * few_roundings);
  expect_measured(average.at("sigma_kin_phir") * ring_volume, 12, 10 * few_roundings);
  expect_measured(average.at("sigma_kin_phiphi") * ring_volume, -12, 10 * few_roundings);
}

}  // namespace
}  // namespace mikromakro
