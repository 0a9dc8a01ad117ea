// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "measured_error.h"
#include "walled_discs.h"

namespace mikromakro {
namespace {

// Latzel2001 Bild 6: 2 pi P(theta) = 1 + a_2 cos 2(theta - theta_2) + a_4 cos 4(theta - theta_4).

// Contacts at 30 and 210 degrees: exp(2 i theta) = exp(i 60 deg) for both, so a_2 = 2 at 30 degrees; exp(4 i
// theta) = exp(i 120 deg): a_4 = 2 at 30 degrees.
TEST(ContactAngles, HarmonicsOfOneDirection) {
  const double c = std::sqrt(3.0) / 2;
  const RingAverage average(disc_between_walls({{{c, 0.5}}, {{-c, -0.5}}}), whole_ring({"contact_angles"}));
  expect_measured(average.at("contact_angle_h2_amplitude"), 2, few_roundings);
  expect_measured(average.at("contact_angle_h2_angle"), 30, 100 * few_roundings);
  expect_measured(average.at("contact_angle_h4_amplitude"), 2, few_roundings);
  expect_measured(average.at("contact_angle_h4_angle"), 30, 100 * few_roundings);
}

// Volumes as 4 and 1, contacts at 0 and 90 degrees: <exp(2 i theta)> = (4 - 1)/5, <exp(4 i theta)> = 1.
TEST(ContactAngles, AreWeightedByVolume) {
  Frame frame = disc_between_walls({{{1, 0}}});
  add_disc(frame, {5, 0}, 1, {{{0, 1}}});
  const RingAverage average(frame, whole_ring({"contact_angles"}));
  expect_measured(average.at("contact_angle_h2_amplitude"), 1.2, few_roundings);
  expect_measured(average.at("contact_angle_h2_angle"), 0, few_roundings);
  expect_measured(average.at("contact_angle_h4_amplitude"), 2, few_roundings);
}

RingSetup four_bins() {
  RingSetup setup = whole_ring({"contact_angle_histogram"});
  setup.field_options.histogram_bins = 4;
  return setup;
}

// Along e_r, on the edge of bins 2 and 3 of 4, and from disc 2 along -e_r, on that of 4 and 1, as at smooth
// walls: rounding does not choose.
TEST(ContactAngleHistogram, CountsContactsOnTheEdgeOfTwoBinsHalfInEach) {
  for (const double off : {-1e-9, 0.0, 1e-9}) {
    Frame frame;
    add_disc(frame, {3, 0}, 1);
    add_disc(frame, {4.9, off}, 1);
    frame.contacts = {make_contact(frame, 0, 1, 100)};
    const RingAverage average(frame, four_bins());
    for (const char* bin : {"1", "2", "3", "4"})
      EXPECT_EQ(average.at(std::string("contact_angle_bin_") + bin), 0.25) << bin;
  }
}

// Disc 1 sees the contact 3 degrees above e_r (bin 3 of 4: 0 to 90), disc 2 from the other side, 1 degree
// lower since its e_r is turned: at -178 degrees (bin 1). Both discs are whole in the ring: half each.
TEST(ContactAngleHistogram, CountsEachContactFromBothDiscs) {
  Frame frame;
  add_disc(frame, {3, 0}, 1);
  add_disc(frame, {4.9, 0.1}, 1);
  frame.contacts = {make_contact(frame, 0, 1, 100)};
  const RingAverage average(frame, four_bins());
  EXPECT_EQ(average.at("contact_angle_bin_1"), 0.5);
  EXPECT_EQ(average.at("contact_angle_bin_2"), 0);
  EXPECT_EQ(average.at("contact_angle_bin_3"), 0.5);
  EXPECT_EQ(average.at("contact_angle_bin_4"), 0);
}

// Volumes as 4 and 1: four fifths of the contacts are at 53 degrees (bin 3), one fifth at -53 (bin 2).
TEST(ContactAngleHistogram, IsWeightedByVolume) {
  Frame frame = disc_between_walls({{{0.6, 0.8}}});
  add_disc(frame, {5, 0}, 1, {{{0.6, -0.8}}});
  const RingAverage average(frame, four_bins());
  expect_measured(average.at("contact_angle_bin_2"), 0.2, few_roundings);
  expect_measured(average.at("contact_angle_bin_3"), 0.8, few_roundings);
}

}  // namespace
}  // namespace mikromakro
