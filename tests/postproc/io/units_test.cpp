#include "io/units.h"

#include <gtest/gtest.h>

namespace mikromakro {
namespace {

// One of everything, so that each number becomes its unit.
RawFrame ones() {
  RawFrame frame;
  frame.box.high = {1, 1};
  frame.particles = {{1, 1, {1, 1}, 1, {1, 1}, 1, 1}};
  frame.contacts.rows.resize(1);
  frame.contacts.rows[0].value.fill(1);
  frame.time = 1;
  return frame;
}

struct Expected {
  std::string name;
  double length, velocity, spin, mass, force, time;
};

class UnitSystems : public testing::TestWithParam<Expected> {};

TEST_P(UnitSystems, ConvertEveryQuantity) {
  const Expected& expected = GetParam();
  RawFrame frame = ones();
  convert(units_of(expected.name, {"p"}), frame);
  const Particle& disc = frame.particles[0];
  EXPECT_DOUBLE_EQ(frame.box.high[0], expected.length);
  EXPECT_DOUBLE_EQ(disc.position[1], expected.length);
  EXPECT_DOUBLE_EQ(disc.radius, expected.length);
  EXPECT_DOUBLE_EQ(disc.velocity[0], expected.velocity);
  EXPECT_DOUBLE_EQ(disc.spin, expected.spin);
  EXPECT_DOUBLE_EQ(disc.mass, expected.mass);
  EXPECT_DOUBLE_EQ(frame.time, expected.time);
  const ContactRow& row = frame.contacts.rows[0];
  using enum ContactColumn;
  for (const ContactColumn column : {id1, id2, nx, ny, periodic}) EXPECT_EQ(row[column], 1);
  for (const ContactColumn column : {x1, y1, x2, y2, overlap, xi})
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
