// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/units.h"

#include <gtest/gtest.h>

#include "io/frames/frame_format.h"

namespace mikromakro {
namespace {

// One of everything, so that each number becomes its unit.
struct Ones {
  RawFrame raw;
  Frame frame;
};

Ones ones() {
  Ones ones;
  ones.raw.box.high = {1, 1};
  ones.raw.contacts.rows.resize(1);
  ones.raw.contacts.rows[0].value.fill(1);
  ones.raw.time = 1;
  ones.frame.box.high = {1, 1};
  ones.frame.particles = {{1, 1, {1, 1}, 1, {1, 1}, 1, 1}};
  ones.frame.contacts = {{1, 2, 0, 1, {1, 0}, 1, {1, 1}, 1}};
  return ones;
}

struct Expected {
  std::string name;
  double length, velocity, spin, mass, force, time;
};

class UnitSystems : public testing::TestWithParam<Expected> {};

TEST_P(UnitSystems, ConvertEveryQuantity) {
  const Expected& expected = GetParam();
  auto [raw, frame] = ones();
  convert(units_of(expected.name, {"p"}), raw, frame);
  const Particle& disc = frame.particles[0];
  EXPECT_DOUBLE_EQ(frame.box.high[0], expected.length);
  EXPECT_DOUBLE_EQ(disc.position[1], expected.length);
  EXPECT_DOUBLE_EQ(disc.radius, expected.length);
  EXPECT_DOUBLE_EQ(disc.velocity[0], expected.velocity);
  EXPECT_DOUBLE_EQ(disc.spin, expected.spin);
  EXPECT_DOUBLE_EQ(disc.mass, expected.mass);
  EXPECT_DOUBLE_EQ(raw.time, expected.time);
  EXPECT_DOUBLE_EQ(raw.box.high[1], expected.length);
  const Contact& contact = frame.contacts[0];
  EXPECT_EQ(contact.normal, Eigen::Vector2d(1, 0));
  EXPECT_DOUBLE_EQ(contact.overlap, expected.length);
  EXPECT_DOUBLE_EQ(contact.spring, expected.length);
  EXPECT_DOUBLE_EQ(contact.force[1], expected.force);
  const ContactRow& row = raw.contacts.rows[0];
  using enum ContactColumn;
  for (const ContactColumn column : {id1, id2, nx, ny, periodic}) EXPECT_EQ(row[column], 1);
  for (const ContactColumn column : {x1, y1, x2, y2, overlap, xi, dist, shearx, sheary})
    EXPECT_DOUBLE_EQ(row[column], expected.length);
  for (const ContactColumn column : {fx, fy, fn, ft}) EXPECT_DOUBLE_EQ(row[column], expected.force);
  for (const ContactColumn column : {vn, vt}) EXPECT_DOUBLE_EQ(row[column], expected.velocity);
}

// cm, g, s, dyn; um, pg, us and 1e-15 kg 1e-6 m/(1e-6 s)^2; nm, ag, ns and 1e-21 kg 1e-9 m/(1e-9 s)^2.
INSTANTIATE_TEST_SUITE_P(Systems, UnitSystems,
                         testing::Values(Expected{"si", 1, 1, 1, 1, 1, 1}, Expected{"lj", 1, 1, 1, 1, 1, 1},
                                         Expected{"cgs", 1e-2, 1e-2, 1, 1e-3, 1e-5, 1},
                                         Expected{"micro", 1e-6, 1, 1e6, 1e-15, 1e-9, 1e-6},
                                         Expected{"nano", 1e-9, 1, 1e9, 1e-21, 1e-12, 1e-9}));

TEST(Units, OfOtherForcesAreRefused) {
  for (const auto* name : {"real", "metal", "electron", "SI", ""})
    EXPECT_THROW(units_of(name, {"p"}), Error) << name;
}

TEST(Units, AreToldUnlessTheyAreSi) {
  EXPECT_EQ(units_note("si"), "");
  EXPECT_EQ(units_note("cgs"), "units cgs: numbers are converted to SI");
  EXPECT_NE(units_note("lj").find("stay as they are"), std::string::npos);
}

}  // namespace
}  // namespace mikromakro
