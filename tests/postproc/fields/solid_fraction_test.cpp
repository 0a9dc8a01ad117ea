// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "measured_error.h"
#include "walled_discs.h"

namespace mikromakro {
namespace {

// Latzel2001 Eq. 3: nu = 1/V sum V^p. Discs of radius 1 touch each other (by their row), one of radius 2
// touches nothing; V^p/V = 0.0025, 0.0025, 0.01.
TEST(SolidFraction, CountsRattlersInNuOnly) {
  Frame frame;
  add_disc(frame, {3, 0}, 1);
  add_disc(frame, {0, 5}, 1);
  add_disc(frame, {-4, 0}, 2);
  frame.contacts = {make_contact(frame, 0, 1, 0)};
  const RingAverage average(frame, whole_ring({"solid_fraction"}));
  expect_measured(average.at("nu"), 0.015, few_roundings);
  expect_measured(average.at("nu_1"), 0.005, few_roundings);
  expect_measured(average.at("nu_2"), 0, few_roundings);
}

// A middle disc between two others: 1, 2, 1 contacts; a fourth one closes a triangle with discs 2 and 3: 1,
// 3, 2, 2. Each disc has V^p/V = 0.0025.
TEST(SolidFraction, OfDiscsByTheirNumberOfContacts) {
  Frame frame;
  for (int i = 0; i < 4; ++i) add_disc(frame, {1.0 + i, 0.5}, 1);
  frame.contacts = {make_contact(frame, 0, 1, 0), make_contact(frame, 1, 2, 0), make_contact(frame, 1, 3, 0),
                    make_contact(frame, 3, 2, 0)};
  const RingAverage average(frame, whole_ring({"solid_fraction"}));
  expect_measured(average.at("nu_1"), 0.01, few_roundings);
  expect_measured(average.at("nu_2"), 0.0075, few_roundings);
  expect_measured(average.at("nu_3"), 0.0025, few_roundings);
}

}  // namespace
}  // namespace mikromakro
