// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "measured_error.h"
#include "walled_discs.h"

namespace mikromakro {
namespace {

// Latzel2001 Eq. 10: C = sum V^p C^p/sum V^p. Radii 1, 2, 1 (volumes as 1, 4, 1) with 2, 2 and 0 contacts:
// (2 + 8 + 0)/6.
TEST(Coordination, IsWeightedByVolume) {
  Frame frame;
  add_disc(frame, {10, 0}, 1, {{{1, 0}}, {{0, 1}}});
  add_disc(frame, {-10, 0}, 2, {{{1, 0}}, {{0, 1}}});
  add_disc(frame, {0, 10}, 1);
  expect_measured(RingAverage(frame, whole_ring({"coordination"})).at("coordination"), 10.0 / 6,
                  few_roundings);
}

}  // namespace
}  // namespace mikromakro
