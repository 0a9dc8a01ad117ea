// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "measured_error.h"
#include "walled_discs.h"

namespace mikromakro {
namespace {

// mu_c = M.kappa/kappa.kappa (Latzel2001 Bild 12), l = 2 n, l x f = 2 f_t:
//   n = (1, 0), t = (0, 1),  xi = 0.3,  f_t = -6: (l x f) l = (-24, 0), kappa_r = -0.3
//   n = (0, 1), t = (-1, 0), xi = -0.1, f_t = 4:  (l x f) l = (0, 16),  kappa_phi = 0.1
// (7.2 + 1.6)/(0.09 + 0.01)/V; M and kappa are not parallel.
TEST(RotationalStiffness, IsTheProjectionOfCoupleStressOnCurvature) {
  const Frame frame = disc_between_walls({{{1, 0}, {-10, -6}, 0.1, 0.3}, {{0, 1}, {-4, -10}, 0.1, -0.1}});
  const RingAverage average(frame, whole_ring({"rotational_stiffness"}));
  expect_measured(average.at("mu_c") * ring_volume / 88, 1, few_roundings);
}

}  // namespace
}  // namespace mikromakro
