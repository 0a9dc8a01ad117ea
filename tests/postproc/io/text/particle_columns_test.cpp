// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/text/particle_columns.h"

#include <gtest/gtest.h>

#include "io/text/particle_reader.h"

namespace mikromakro {
namespace {

// A box from -5 to 5 and from 0 to 20, periodic in x, 2 deep.
Particle read(const std::string& columns, const std::string& row, bool boundaries_known = true) {
  RowBlock block;
  block.file = "p";
  block.header.label = "ATOMS";
  block.header.rows = 1;
  block.header.depth = 2;
  block.header.box = {{-5, 0}, {5, 20}, {boundaries_known, false}, boundaries_known};
  for (std::size_t at = 0, end = 0; end != std::string::npos; at = end + 1) {
    end = columns.find(' ', at);
    block.header.columns.push_back(columns.substr(at, end - at));
  }
  block.text = row + "\n";
  return read_particles(block, {}, 0).particles.front();
}

TEST(ParticleColumns, SpellingsOfOnePlaceAgree) {
  const Eigen::Vector2d place(2.5, 15);
  EXPECT_EQ(read("x y radius", "2.5 15 1").position, place);
  EXPECT_EQ(read("xs ys radius", "0.75 0.75 1").position, place);
  EXPECT_EQ(read("xu yu radius", "32.5 15 1").position, place);
  EXPECT_EQ(read("xu yu radius", "-27.5 15 1").position, place);
  EXPECT_EQ(read("xsu ysu radius", "-2.25 0.75 1").position, place);
  EXPECT_EQ(read("xs ys x y xu yu radius", "0 0 2.5 15 0 0 1").position, place);
  EXPECT_EQ(read("xs ys xu yu diameter", "0 0 12.5 15 2").position, place);
}

// Beyond a wall a disc has left the box; where nothing is known of the boundaries it cannot be placed.
TEST(ParticleColumns, UnwrappedPlacesAreBroughtBackIntoPeriodicBoxesOnly) {
  EXPECT_EQ(read("xu yu radius", "2.5 35 1").position, Eigen::Vector2d(2.5, 35));
  EXPECT_EQ(read("xu yu radius", "2.5 15 1", false).position, Eigen::Vector2d(2.5, 15));
  EXPECT_THROW(read("xu yu radius", "12.5 15 1", false), Error);
}

TEST(ParticleColumns, ADiameterIsTwiceTheRadius) {
  EXPECT_EQ(read("x y diameter", "0 0 3").radius, 1.5);
  EXPECT_EQ(read("x y diameter radius", "0 0 3 2").radius, 2);
}

TEST(ParticleColumns, WithoutIdsParticlesAreNumbered) {
  EXPECT_EQ(read("x y radius", "0 0 1").id, 1);
  EXPECT_EQ(read("id x y radius", "77 0 0 1").id, 77);
}

TEST(ParticleColumns, ZMustBeTheSameToAMillionthOfARadius) {
  PlaneCheck plane;
  plane.add(3, 0.5, {"p", 10});
  plane.add(3 + 0.4e-6, 0.5, {"p", 11});
  EXPECT_THROW(plane.add(3 + 0.6e-6, 0.5, {"p", 12}), Error);
}

}  // namespace
}  // namespace mikromakro
