// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "measured_error.h"
#include "walled_discs.h"

namespace mikromakro {
namespace {

// Fewer than two contacts: of discs with 0, 1, 2, 2 and 3 contacts two of five, whatever their radii.
TEST(Rattlers, AreDiscsWithFewerThanTwoContacts) {
  const WallContact wall{{1, 0}};
  Frame frame;
  add_disc(frame, {10, 0}, 1);
  add_disc(frame, {-10, 0}, 2, {wall});
  add_disc(frame, {0, 10}, 3, {wall, wall});
  add_disc(frame, {0, -10}, 2, {wall, wall});
  add_disc(frame, {0, 0}, 1, {wall, wall, wall});
  expect_measured(RingAverage(frame, whole_ring({"rattler_fraction"})).at("rattler_fraction"), 0.4,
                  few_roundings);
}

}  // namespace
}  // namespace mikromakro
