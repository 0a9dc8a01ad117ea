// SPDX-License-Identifier: GPL-2.0-or-later
#include "physics/motion/servo_wall.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace mikromakro::physics {
namespace {

/// Largest errors of position and velocity over `time` under the force(position), from rest or not.
struct Errors {
  double position = 0, velocity = 0;
};
using Force = std::function<double(double position)>;
using Exact = std::function<ServoWall(double time)>;
Errors follow(const Force& force, const ServoProperties& p, const Exact& exact, double dt, int steps) {
  ServoWall wall = exact(0);
  wall.acceleration = (force(wall.position) - p.damping * wall.velocity) / p.mass;
  Errors errors;
  for (int k = 1; k <= steps; ++k) {
    const ServoWall drifted = servo_drift(wall, dt);
    wall = servo_kick(drifted, force(drifted.position), p, dt);
    errors.position = std::max(errors.position, std::abs(wall.position - exact(k * dt).position));
    errors.velocity = std::max(errors.velocity, std::abs(wall.velocity - exact(k * dt).velocity));
  }
  return errors;
}
double order(double coarse, double fine) {
  return std::log(coarse / fine) / std::log(4.0);
}

// x = x_0 + v_0 t + F t^2/(2 m) is exact for velocity Verlet: rounding only.
TEST(ServoWall, ConstantForceWithoutDampingIsExact) {
  const auto exact = [](double t) { return ServoWall{1 + 0.5 * t + 1.5 * t * t, 0.5 + 3 * t, 3}; };
  const auto errors = follow([](double) { return 6.0; }, {2, 0}, exact, 0.01, 100);
  EXPECT_LT(errors.position, 1e-13);
  EXPECT_LT(errors.velocity, 1e-13);
}

// v = F/gamma (1 - exp(-gamma t/m)), x = F/gamma (t - m/gamma (1 - exp(-gamma t/m))).
TEST(ServoWall, ConstantForceWithDampingConvergesWithOrderTwo) {
  const double rate = 0.8 / 2, end = 6 / 0.8;
  const auto exact = [&](double t) {
    const double rest = 1 - std::exp(-rate * t);
    return ServoWall{end * (t - rest / rate), end * rest, 0};
  };
  const auto force = [](double) { return 6.0; };
  const auto coarse = follow(force, {2, 0.8}, exact, 0.1, 100),
             fine = follow(force, {2, 0.8}, exact, 0.025, 400);
  EXPECT_NEAR(order(coarse.position, fine.position), 2, 0.05);
  EXPECT_NEAR(order(coarse.velocity, fine.velocity), 2, 0.05);
  EXPECT_LT(coarse.velocity, end * std::pow(rate * 0.1, 2));
}

// A wall on a spring: m x'' = -k x - gamma x'.
TEST(ServoWall, DampedOscillatorConvergesWithOrderTwo) {
  const double m = 2, k = 5, gamma = 0.6, decay = gamma / (2 * m), omega = std::sqrt(k / m - decay * decay);
  const auto exact = [&](double t) {
    const double envelope = std::exp(-decay * t);
    return ServoWall{envelope * std::cos(omega * t),
                     -envelope * (decay * std::cos(omega * t) + omega * std::sin(omega * t)), 0};
  };
  const auto force = [&](double x) { return -k * x; };
  const auto coarse = follow(force, {m, gamma}, exact, 0.04, 250),
             fine = follow(force, {m, gamma}, exact, 0.01, 1000);
  EXPECT_NEAR(order(coarse.position, fine.position), 2, 0.05);
  EXPECT_NEAR(order(coarse.velocity, fine.velocity), 2, 0.05);
  EXPECT_LT(coarse.position,
            10 * std::pow(omega * 0.04, 3));  // phase: (omega dt)^2/24 per radian, 16 radians
}

// Damping that is stiff for the time step: the velocity goes to F/gamma and does not overshoot.
TEST(ServoWall, StiffDampingIsStable) {
  ServoWall wall;
  wall.acceleration = 6 / 2.0;
  for (int k = 0; k < 500; ++k) wall = servo_kick(servo_drift(wall, 0.1), 6, {2, 200}, 0.1);
  EXPECT_NEAR(wall.velocity, 0.03, 1e-12);
}

TEST(ServoWall, PredictedVelocityIsThatOfAConstantForce) {
  const auto drifted = servo_drift({0, 1, 4}, 0.5);
  EXPECT_DOUBLE_EQ(drifted.position, 1);
  EXPECT_DOUBLE_EQ(predicted_velocity(drifted, 0.5), 3);
}

// Discs push with 50 N, 20 N/m act on 3 m: -10 N, inwards is negative.
TEST(ServoForce, IsWhatDiscsAndPressureLeave) {
  EXPECT_DOUBLE_EQ(servo_force(50, 20, 3), -10);
}

// m = 4 kg on K = 1 N/m: a period of 4 pi s.
TEST(ServoWall, SwingsOnItsContactsWithinHalfAPeriodFromTurnToTurn) {
  EXPECT_NEAR(servo_half_period(4.0, 1.0), 2 * std::numbers::pi, 1e-15);
}

}  // namespace
}  // namespace mikromakro::physics
