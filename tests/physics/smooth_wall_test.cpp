// SPDX-License-Identifier: GPL-2.0-or-later
#include "physics/walls/smooth_wall.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mikromakro::physics {
namespace {

constexpr Effects spring_law{Tangential::spring, false};
const ContactParameters material{1000, 0.2, 800, 0.15, 0.5};

SmoothWall flat(PlaneVector point, PlaneVector outward) {
  SmoothWall wall;
  wall.point = point;
  wall.outward = outward;
  return wall;
}
SmoothWall circle(WallShape shape, PlaneVector centre, double radius) {
  SmoothWall wall;
  wall.shape = shape;
  wall.point = centre;
  wall.radius = radius;
  return wall;
}

// All points of the circle are equally near: the distance is the radius, and a normal is a unit vector.
TEST(NearestPoint, OfACircleFromItsCentre) {
  for (const auto shape : {WallShape::circle_around, WallShape::circle_within}) {
    const auto at = nearest_point(circle(shape, {3, 4}, 0.5), {3, 4});
    EXPECT_EQ(std::abs(at.distance), 0.5);
    EXPECT_EQ(std::hypot(at.normal.x, at.normal.y), 1);
    EXPECT_EQ(std::hypot(at.place.x - 3, at.place.y - 4), 0.5);
  }
}

TEST(NearestPoint, OfAFlatWall) {
  const auto at = nearest_point(flat({3, 7}, {0, -1}), {5, 9});  // a floor at y = 7
  EXPECT_EQ(at.distance, 2);
  EXPECT_EQ(at.normal.x, 0);
  EXPECT_EQ(at.normal.y, -1);
  EXPECT_EQ(at.place.x, 5);
  EXPECT_EQ(at.place.y, 7);
}

// The disc's centre is 5 (3, 4, 5) from the centre of the circle, at the unit vector (0.6, 0.8).
TEST(NearestPoint, OfACircleAroundTheDiscs) {
  const auto at = nearest_point(circle(WallShape::circle_around, {1, 2}, 10), {4, 6});
  EXPECT_DOUBLE_EQ(at.distance, 5);
  EXPECT_DOUBLE_EQ(at.normal.x, 0.6);
  EXPECT_DOUBLE_EQ(at.normal.y, 0.8);
  EXPECT_DOUBLE_EQ(at.place.x, 7);
  EXPECT_DOUBLE_EQ(at.place.y, 10);
}

TEST(NearestPoint, OfACircleWithinTheDiscs) {
  const auto at = nearest_point(circle(WallShape::circle_within, {1, 2}, 2), {4, 6});
  EXPECT_DOUBLE_EQ(at.distance, 3);
  EXPECT_DOUBLE_EQ(at.normal.x, -0.6);
  EXPECT_DOUBLE_EQ(at.normal.y, -0.8);
  EXPECT_DOUBLE_EQ(at.place.x, 2.2);
  EXPECT_DOUBLE_EQ(at.place.y, 3.6);
}

// a R/(a + R): 2 * 3/5 beside a wheel, 2 * 6/(6 - 2) inside a ring, a at a flat wall.
TEST(ReducedRadius, FollowsTheCurvature) {
  EXPECT_DOUBLE_EQ(reduced_radius_at(curvature(circle(WallShape::circle_within, {1, 2}, 3)), 2), 1.2);
  EXPECT_DOUBLE_EQ(reduced_radius_at(curvature(circle(WallShape::circle_around, {1, 2}, 6)), 2), 3);
  EXPECT_EQ(reduced_radius_at(curvature(flat({3, 7}, {0, -1})), 2), 2);
}

// v = v_point + omega x r + dR/dt e_r at r = (6, 8), R = 10: (1 - 3 * 8 + 0.5 * 0.6, 2 + 3 * 6 + 0.5 * 0.8).
TEST(VelocityAt, AddsTranslationRotationAndGrowth) {
  auto wall = circle(WallShape::circle_around, {1, 2}, 10);
  wall.velocity = {1, 2};
  wall.rotation_rate = 3;
  wall.radial_velocity = 0.5;
  const auto v = velocity_at(wall, {7, 10});
  EXPECT_DOUBLE_EQ(v.x, -22.7);
  EXPECT_DOUBLE_EQ(v.y, 20.4);
}

// A floor that moves with (0.5, 0.1); a disc of radius 2, 1.9 above it, with velocity (1, -1) and spin 3: the
// normal is (0, -1), the tangent (1, 0), the lever arm 1.9. Approach (0.5, -1.1).(0, -1) = 1.1; slip
// 0.5 + 3 * 1.9.
TEST(StateAtWall, OfAMovingFloor) {
  auto wall = flat({0, 0}, {0, -1});
  wall.velocity = {0.5, 0.1};
  const MovingDisc disc{{4, 1.9}, {1, -1}, 3, 2};
  const auto state = state_at_wall(wall, nearest_point(wall, disc.position), disc, 0.25);
  EXPECT_NEAR(state.overlap, 0.1, 1e-15);
  EXPECT_DOUBLE_EQ(state.v_n, 1.1);
  EXPECT_DOUBLE_EQ(state.v_t, 6.2);
  EXPECT_EQ(state.xi, 0.25);
}

// A disc that is carried by a turning ring like a rigid part of it: no relative velocity anywhere.
TEST(StateAtWall, OfADiscCarriedByTheRingHasNoRelativeVelocity) {
  for (const auto shape : {WallShape::circle_around, WallShape::circle_within}) {
    auto wall = circle(shape, {1, 2}, shape == WallShape::circle_around ? 6.9 : 3.1);
    wall.rotation_rate = 0.7;
    const MovingDisc disc{{4, 6}, {-0.7 * 4, 0.7 * 3}, 0.7, 2};
    const auto state = state_at_wall(wall, nearest_point(wall, disc.position), disc, 0);
    EXPECT_NEAR(state.overlap, 0.1, 1e-15);
    EXPECT_NEAR(state.v_n, 0, 1e-15);
    EXPECT_NEAR(state.v_t, 0, 3e-15);  // terms of size 5
  }
}

// About the ring's centre, the torque on the disc (of the force at its centre, and the lever arm times f_t)
// is opposite to the one on the wall.
TEST(WallLoad, ConservesAngularMomentum) {
  for (const auto shape : {WallShape::circle_around, WallShape::circle_within}) {
    const auto wall = circle(shape, {1, 2}, shape == WallShape::circle_around ? 6.9 : 3.1);
    const PlaneVector centre{4, 6};
    const auto at = nearest_point(wall, centre);
    const double f_n = 5, f_t = -2;
    const PlaneVector force{-f_n * at.normal.x - f_t * at.normal.y, -f_n * at.normal.y + f_t * at.normal.x};
    WallLoad load;
    load.add(wall, at, f_n, force);
    EXPECT_NEAR(load.torque + 3 * force.y - 4 * force.x + at.distance * f_t, 0, 1e-14);
    EXPECT_EQ(load.force.x, -force.x);
    EXPECT_EQ(load.force.y, -force.y);
    EXPECT_EQ(load.pressing, f_n);
  }
}

TEST(Displacement, IsThatOfTheSurface) {
  const auto floor = flat({3, 7}, {0, -1});
  EXPECT_EQ(displacement(floor, flat({5, 7.5}, {0, -1})), 0.5);
  EXPECT_EQ(displacement(circle(WallShape::circle_within, {0, 0}, 2),
                         circle(WallShape::circle_within, {3, 4}, 1.5)),
            5.5);
}

// In the step of first contact the disc has slipped since it met the wall: overlap/v_n = 1e-4 s of 1e-3 s.
TEST(WallSpring, BeginsWhereTheDiscMetTheWall) {
  WallSpring spring;
  const auto force = wall_contact_force<spring_law>(material, {1e-4, 1, 0.2, 0}, {1e-3, true}, spring);
  EXPECT_DOUBLE_EQ(spring.xi, 0.2e-4);
  EXPECT_EQ(spring.slip_rate, 0.2);
  EXPECT_TRUE(spring.touching);
  EXPECT_DOUBLE_EQ(force.f_t, -800 * 0.2e-4);
}

// Later by Verlet's slip (2 * 0.2 + 0.17)/3 dt = 0.19 dt; by 0.2 dt where velocities are those of half steps.
TEST(WallSpring, GrowsByTheSlipOfTheHalfStep) {
  for (const bool predicted : {true, false}) {
    WallSpring spring{1e-5, 0.17, true};
    wall_contact_force<spring_law>(material, {1e-3, 0, 0.2, 1e-5}, {1e-5, predicted}, spring);
    EXPECT_DOUBLE_EQ(spring.xi, 1e-5 + (predicted ? 0.19e-5 : 0.2e-5));
    EXPECT_DOUBLE_EQ(spring.slip_rate, predicted ? 0.19 : 0.2);
  }
}

TEST(WallSpring, DoesNotMoveInASetUp) {
  WallSpring spring{1e-5, 0.17, true};
  const auto force = wall_contact_force<spring_law>(material, {1e-3, 0, 0.2, 1e-5}, {0, true}, spring);
  EXPECT_EQ(spring.xi, 1e-5);
  EXPECT_EQ(spring.slip_rate, 0.17);
  EXPECT_DOUBLE_EQ(force.f_t, -800 * 1e-5);
}

}  // namespace
}  // namespace mikromakro::physics
