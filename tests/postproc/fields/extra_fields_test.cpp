// SPDX-License-Identifier: GPL-2.0-or-later
// Fields that are averaged only when they are asked for.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "measured_error.h"
#include "model/error.h"
#include "ring_average.h"

namespace mikromakro {
namespace {

constexpr double rounding = 1e-12;

RingSetup one_ring(const std::string& field) {
  RingSetup setup;
  setup.edges = {0, 1000};
  setup.fields = {field};
  return setup;
}

// g2 of discs of the given radii, which need not touch.
double size_correction(const std::vector<double>& radii, const std::string& column) {
  Frame frame;
  for (const double radius : radii)
    frame.particles.push_back(make_disc(static_cast<int>(frame.particles.size()) + 1, {20, 0}, radius));
  return RingAverage(frame, one_ring("g2")).at(column);
}

// Radii in the middle of 2000 equal parts of an interval: the midpoint rule, good to 1e-7.
std::vector<double> uniform_radii(double smallest, double largest) {
  constexpr int parts = 2000;
  std::vector<double> radii;
  radii.reserve(parts);
  for (int i = 0; i < parts; ++i) radii.push_back(smallest + (largest - smallest) * (i + 0.5) / parts);
  return radii;
}

// Values that docs/conventions.md quotes, to their last digit.
TEST(SizeCorrection, HasItsValuesForKnownDistributions) {
  expect_measured(size_correction({3, 3, 3}, "g2"), 1, rounding);
  EXPECT_NEAR(size_correction({1, 3}, "g2"), 1.2231, 5e-5);
  EXPECT_NEAR(size_correction(uniform_radii(0.8, 1.2), "g2"), 1.0145, 5e-5);
  EXPECT_NEAR(size_correction(uniform_radii(0.5, 1.5), "g2"), 1.085, 5e-4);
}

// Radii 1 and 3: <a> = 2, <a^2> = 5, <a^3> = 14: 1 + sqrt(3)/pi (1.4 - 1).
TEST(SizeCorrection, LinearFormAsWorkedByHand) {
  expect_measured(size_correction({1, 3}, "g2_linear"), 1 + std::numbers::sqrt3 / std::numbers::pi * 0.4,
                  rounding);
}

// Discs of radius 1 in a row, touching: 1, 2, 2, 1 contacts and one alone: 6/5 contacts per disc; 3 of 5 have
// fewer than two. The lone disc has radius 2: weighted by volume 6/8.
TEST(NumberAverages, CountEachDiscOnce) {
  Frame frame;
  for (int i = 0; i < 4; ++i) frame.particles.push_back(make_disc(i + 1, {10 + 1.9 * i, 0}, 1));
  frame.particles.push_back(make_disc(9, {-10, 0}, 2));
  for (int i = 0; i < 3; ++i) frame.contacts.push_back(make_contact(frame, i, i + 1, 1));
  RingSetup setup = one_ring("coordination_number_averaged");
  setup.fields.insert(setup.fields.end(), {"rattler_fraction", "coordination"});
  const RingAverage average(frame, setup);
  expect_measured(average.at("coordination_number_averaged"), 1.2, rounding);
  expect_measured(average.at("rattler_fraction"), 0.6, rounding);
  expect_measured(average.at("coordination"), 0.75, rounding);
}

// Three contacts along e_r with forces (f_r, f_phi) on one disc; mu = 0.5: 5 of 10 slides, 4.9 of 10 does
// not, nor does a contact without forces.
TEST(SlidingContacts, AreThoseAtTheCoulombLimit) {
  Frame frame;
  frame.particles = {make_disc(1, {10, 0}, 1)};
  for (const Eigen::Vector2d& force : {Eigen::Vector2d(-10, 5), {-10, -4.9}, {0, 0}}) {
    Contact contact;
    contact.id1 = 1;
    contact.index1 = 0;
    contact.normal = {1, 0};
    contact.overlap = 0.1;
    contact.force = force;
    frame.contacts.push_back(contact);
  }
  RingSetup setup = one_ring("sliding_fraction");
  setup.field_options.friction_coefficient = 0.5;
  expect_measured(RingAverage(frame, setup).at("sliding_fraction"), 1.0 / 3, rounding);
}

// A disc on the x axis with contacts at 30 and 210 degrees: exp(2 i theta) = exp(i 60 deg) for both, so a_2 =
// 2 at 30 degrees; exp(4 i theta) = exp(i 120 deg): a_4 = 2 at 30 degrees.
TEST(ContactAngles, HarmonicsOfOneDirection) {
  const double c = std::cos(std::numbers::pi / 6);
  const double s = 0.5;
  Frame frame;
  frame.particles = {make_disc(1, {10, 0}, 1), make_disc(2, {10 + 1.9 * c, 1.9 * s}, 1, 2),
                     make_disc(3, {10 - 1.9 * c, -1.9 * s}, 1, 2)};
  frame.contacts = {make_contact(frame, 0, 1, 1), make_contact(frame, 2, 0, 1)};
  RingSetup setup = one_ring("contact_angles");
  setup.options.bulk_types = {1};
  const RingAverage average(frame, setup);
  expect_measured(average.at("contact_angle_h2_amplitude"), 2, rounding);
  expect_measured(average.at("contact_angle_h2_angle"), 30, 100 * rounding);
  expect_measured(average.at("contact_angle_h4_amplitude"), 2, rounding);
  expect_measured(average.at("contact_angle_h4_angle"), 30, 100 * rounding);
}

TEST(FieldRegistry, SourcesAreAveragedButNotShown) {
  const FieldList fields = make_fields({"stiffness"});
  ASSERT_EQ(fields.size(), 3U);
  EXPECT_EQ(fields[0].field->name(), "stress");
  EXPECT_EQ(fields[1].field->name(), "elastic_strain");
  EXPECT_FALSE(fields[0].shown || fields[1].shown);
  EXPECT_TRUE(fields[2].shown);
}

TEST(FieldRegistry, FieldWithoutItsOptionIsAnError) {
  EXPECT_THROW(make_fields({"sliding_fraction"}), Error);
  EXPECT_THROW(make_fields({"contact_angle_histogram"}), Error);
  for (const ListedField& listed : make_fields({"all"})) EXPECT_TRUE(listed.field->missing_option().empty());
}

}  // namespace
}  // namespace mikromakro
