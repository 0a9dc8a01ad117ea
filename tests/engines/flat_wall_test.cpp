// SPDX-License-Identifier: GPL-2.0-or-later
// One disc at the smooth walls of a box, against closed forms. The wall's mass is infinite: m12 = m, and a
// tangential force changes the slip rate by 3 f_t/m.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine.h"
#include "physics/contact/contact_duration.h"

namespace mikromakro::test {
namespace {

constexpr double a = 3.71e-3, density = 6.36, k_n = 352.1, g = 9.81;
const double mass = density * M_PI * a * a;
const double t_c = physics::contact_duration(k_n, 0, mass);
const char* const viscous = "disc/viscous";
const char* const spring = "disc/cundall_strack";
const char* const damped_spring = "disc/cundall_strack tangential_damping on";

std::string box(const std::string& tangential, const Material& material) {
  return scene("model disc/linear tangential " + tangential, material, 0.5);
}
/// The floor is at y = 0, the left wall at x = -0.4.
std::string walls(const std::string& integrator = "nve/disc") {
  return "fix integrate all " + integrator +
         "\ncompute contacts all contact/disc\n"
         "fix walls all biaxial/2d type 2 left -0.4 fixed right 0.4 fixed bottom 0 fixed top 0.4 fixed\n";
}
/// Gravity on a floor that falls by `angle` towards x.
std::string gravity(double angle) {
  return fmt::format("fix weight all gravity {} vector {:.17g} {:.17g} 0\n", g, std::sin(angle),
                     -std::cos(angle));
}
std::string run(double dt, double time) {
  return fmt::format("timestep {:.17g}\nrun {}\n", dt, std::lround(time / dt));
}

TEST(DiscOnAFloor, SinksByItsWeightOverTheStiffness) {
  Engine engine;
  engine.run(box("off", {.k_n = k_n}) + disc(1, 0, a, a, density) + gravity(0) + walls() + run(4e-5, 0.4));
  const auto contact = engine.contacts().at({-3, 1});
  // m/gamma_n = 1.4 ms: what is left of the oscillation after 0.4 s is below rounding, 1e-17 m of a position.
  EXPECT_NEAR(contact.overlap, mass * g / k_n, 1e-16);
  EXPECT_NEAR(contact.f_n, mass * g, 1e-13);
  EXPECT_NEAR(contact.y1, 0, 1e-17);   // the contact point is on the wall
  EXPECT_NEAR(contact.n_y, 1, 1e-15);  // from the wall, whose id is smaller, to the disc
}

// Hertz at a flat wall: m g = k_n sqrt(a) overlap^(3/2).
TEST(DiscOnAFloor, SinksUnderHertzsLaw) {
  Engine engine;
  const double stiffness = 1e6;  // N/m^2
  engine.run(scene("model disc/hertz tangential off", {.k_n = stiffness}, 0.5) + disc(1, 0, a, a, density) +
             gravity(0) + walls() + run(4e-5, 2));
  const double overlap = std::pow(mass * g / (stiffness * std::sqrt(a)), 2.0 / 3);
  EXPECT_NEAR(engine.contacts().at({-3, 1}).overlap, overlap, 1e-15);
}

TEST(DiscInACorner, TouchesTwoWalls) {
  Engine engine;
  engine.run(box("off", {.k_n = k_n}) + disc(1, -0.4 + a - 2e-5, a - 1e-5, a, density) + walls() + "run 0\n");
  const auto contacts = engine.contacts();
  ASSERT_EQ(contacts.size(), 2U);
  EXPECT_NEAR(contacts.at({-1, 1}).overlap, 2e-5, 1e-16);
  EXPECT_NEAR(contacts.at({-3, 1}).overlap, 1e-5, 1e-16);
  const auto d = engine.discs().at(1);
  EXPECT_NEAR(d.f_x, k_n * 2e-5, 1e-13);
  EXPECT_NEAR(d.f_y, k_n * 1e-5, 1e-13);
}

/// Velocity after an impact on the floor with v_n, v_t and spin (units of v_n: v_t and the rim's speed),
/// `onset` steps after a step.
struct Impact {
  double v_n, v_t, rim, energy_ratio;
  double slip() const { return v_t + rim; }
};
Impact impact(const std::string& tangential, const Material& material, double v_t, double rim, double steps,
              double onset) {
  constexpr double v_n = 1e-6;  // overlap/a = 1e-7 is below every tolerance here
  const double dt = physics::contact_duration(material.k_n, material.gamma_n, mass) / steps;
  Engine engine;
  engine.run(box(tangential, material) + disc(1, 0, a + onset * dt * v_n, a, density) +
             motion(1, v_t * v_n, -v_n, rim * v_n / a) + walls() +
             run(dt, dt * (std::floor(1.1 * steps) + 3)));
  const auto d = engine.discs().at(1);
  const double before = 1 + v_t * v_t + rim * rim / 2;
  const Impact after{d.v_y / v_n, d.v_x / v_n, d.omega * a / v_n, 0};
  return {after.v_n, after.v_t, after.rim,
          (after.v_n * after.v_n + after.v_t * after.v_t + after.rim * after.rim / 2) / before};
}

double order(double coarse, double fine, double ratio) {
  return std::log(std::abs(coarse / fine)) / std::log(ratio);
}

/// Mean of e_n/expected - 1 over the phases of onset and release within a step.
double restitution_error(double steps_per_contact) {
  const Material material{.k_n = k_n, .gamma_n = 0.19};
  const double expected = physics::restitution(k_n, 0.19, mass);
  double sum = 0;
  for (int onset = 0; onset < 8; ++onset) {
    for (int release = 0; release < 8; ++release) {
      sum +=
          impact("off", material, 0, 0, steps_per_contact + release / 8.0, (onset + 0.5) / 8).v_n / expected -
          1;
    }
  }
  return sum / 64;
}

TEST(BouncingDisc, HasTheRestitutionOfAPartnerWithoutEnd) {
  const double coarse = restitution_error(50), fine = restitution_error(200);
  std::printf("e_n at a wall off by %+.1e at t_c/50, %+.1e at t_c/200\n", coarse, fine);
  EXPECT_NEAR(order(coarse, fine, 4), 2, 0.3);
  EXPECT_LT(std::abs(coarse), 5e-3);
}

// Sticking throughout: v_t' = v_t cos(pi sqrt(3 k_t/k_n)), here -v_t; order 2 as between two discs.
TEST(StickingDisc, ReversesItsSlip) {
  const Material material{.k_n = k_n, .gamma_n = 0, .k_t = k_n / 3, .mu = 1e6};
  double worst[2] = {0, 0};
  for (int k = 0; k < 2; ++k) {
    for (int phase = 0; phase < 8; ++phase) {
      const auto after =
          impact(spring, material, 0.7, 0.3, (k == 0 ? 40 : 160) + phase / 8.0, (phase + 0.5) / 8);
      worst[k] = std::max(worst[k], std::abs(after.slip() + 1));
    }
  }
  EXPECT_LT(worst[0], 1e-3);  // (omega dt)^2/24 = 2.6e-4 of Verlet; onset and release are of its size
  EXPECT_NEAR(order(worst[0], worst[1], 4), 2, 0.4);
}

// J_t = -mu J_n: v_t' = v_t - mu (v_n + v_n'), the rim gets twice that with opposite arms.
TEST(SlidingDisc, LosesMuTimesTheNormalImpulse) {
  for (const auto* law : {viscous, spring}) {
    const Material material{.k_n = k_n, .gamma_n = 0, .k_t = k_n, .gamma_t = 10, .mu = 0.1};
    for (const double v_t : {2.0, -2.0}) {
      const auto after = impact(law, material, v_t, 0, 50, 0.3);
      const double impulse = -std::copysign(0.1, v_t) * (1 + after.v_n);
      EXPECT_NEAR(after.v_t, v_t + impulse, 1e-6);  // lever arm: overlap/a = 1e-7
      EXPECT_NEAR(after.rim, 2 * impulse, 1e-6);
    }
  }
}

TEST(GrazingDisc, GainsNoEnergy) {
  const Material hard{.k_n = k_n, .gamma_n = 0, .k_t = 0.8 * k_n, .gamma_t = mass / (3 * t_c), .mu = 0.5};
  for (const auto* law : {viscous, spring, damped_spring}) {
    for (const double steps : {25.0, 100.0}) {
      double gain = -1;
      for (double speed = 0.1; speed < 40; speed *= 2) {
        for (int phase = 0; phase < 2; ++phase) {
          for (const double rim : {0.0, speed, -0.5 * speed}) {
            const auto after = impact(law, hard, speed - rim, rim, steps + phase / 2.0, (phase + 0.5) / 2);
            gain = std::max(gain, after.energy_ratio - 1);
          }
        }
      }
      std::printf("%s, t_c/%g: largest gain of energy %.1e\n", law, steps, gain);
      EXPECT_LT(gain, std::pow(M_PI / steps, 2) / 12);  // of the elastic normal impact, either way
    }
  }
}

// Without dashpots the set-up repeats the forces of the last step, so that a run may be cut: no tolerance.
// The contact sticks: one that slides would hide a spring that was moved twice.
TEST(SetUpOfARunAtAWall, NeitherMovesTheSpringNorForgetsTheSlip) {
  const auto contact_after = [](const std::string& runs) {
    Engine engine;
    engine.run(box(spring, {.k_n = k_n, .gamma_n = 0}) + disc(1, 0, a - 1e-5, a, density) +
               motion(1, 0.001, 0) + walls() + "timestep 2e-5\n" + runs);
    return engine.contacts().at({-3, 1});
  };
  const auto whole = contact_after("run 40\n"), cut = contact_after("run 20\nrun 20\n");
  ASSERT_NE(whole.xi, 0);
  EXPECT_EQ(whole.xi, cut.xi);
  EXPECT_EQ(whole.f_t, cut.f_t);
  EXPECT_EQ(whole.overlap, cut.overlap);
}

constexpr double angle = 0.3;  // tan = 0.31, below mu = 0.44

// A free disc rolls; the stock `fix nve` leaves its spin alone, so that the disc slides like a block.
TEST(BlockOnASlope, DoesNotCreepUnderTheSpring) {
  Engine engine;
  engine.run(box(damped_spring, {.k_n = k_n, .gamma_t = 0.15}) + disc(1, 0, a, a, density) + gravity(angle) +
             walls("nve") + run(4e-5, 0.4));
  const auto at_rest = engine.discs().at(1);
  const auto contact = engine.contacts().at({-3, 1});
  // Seen from the disc the tangent of the floor is x: it has slipped downhill and is held back.
  EXPECT_NEAR(contact.f_t, -mass * g * std::sin(angle), 1e-13);
  EXPECT_NEAR(contact.xi, mass * g * std::sin(angle) / 281.68, 1e-16);
  engine.run(run(4e-5, 4));
  EXPECT_NEAR(engine.discs().at(1).x, at_rest.x, 1e-16);
}

// Above the angle of friction it slides: x'' = g (sin - mu cos).
TEST(BlockOnASlope, SlidesAboveTheAngleOfFriction) {
  Engine engine;
  engine.run(box(spring, {.k_n = k_n}) + disc(1, 0, a - mass * g * std::cos(0.6) / k_n, a, density) +
             gravity(0.6) + walls("nve") + run(4e-5, 0.1));
  const double start = engine.discs().at(1).v_x;
  engine.run(run(4e-5, 0.1));
  EXPECT_NEAR((engine.discs().at(1).v_x - start) / 0.1, g * (std::sin(0.6) - 0.44 * std::cos(0.6)), 1e-9);
}

// Eq. 1 has no static friction: m x'' = m g sin - gamma_t x' ends at g sin m/gamma_t; m/gamma_t = 1.8 ms.
TEST(BlockOnASlope, CreepsUnderEquation1) {
  Engine engine;
  engine.run(box(viscous, {.k_n = k_n, .gamma_t = 0.15}) + disc(1, 0, a, a, density) + gravity(angle) +
             walls("nve") + run(4e-5, 0.2));
  const double speed = g * std::sin(angle) * mass / 0.15;
  ASSERT_LT(0.15 * speed, 0.44 * mass * g * std::cos(angle));
  EXPECT_NEAR(engine.discs().at(1).v_x, speed, 1e-12);
}

// A free disc rolls: x'' = g sin/(1 + I/(m c^2)), with the lever arm c = a - overlap.
TEST(DiscOnASlope, RollsWithTwoThirdsOfTheAcceleration) {
  Engine engine;
  engine.run(box(damped_spring, {.k_n = k_n, .gamma_t = 0.15}) + disc(1, 0, a, a, density) + gravity(angle) +
             walls() + run(2e-5, 0.1));
  const double start = engine.discs().at(1).v_x;
  engine.run(run(2e-5, 0.1));
  const double arm = a - mass * g * std::cos(angle) / k_n;
  const double expected = g * std::sin(angle) / (1 + a * a / 2 / (arm * arm));
  EXPECT_NEAR((engine.discs().at(1).v_x - start) / 0.1, expected, 1e-9);
}

// Under Eq. 1 it also slips, by a third of what a block would: s' = g sin - gamma_t s (1/m + c^2/I) = 0.
TEST(DiscOnASlope, SlipsAThirdOfABlockUnderEquation1) {
  Engine engine;
  engine.run(box(viscous, {.k_n = k_n, .gamma_t = 0.15}) + disc(1, 0, a, a, density) + gravity(angle) +
             walls() + run(4e-5, 0.2));
  const auto contact = engine.contacts().at({-3, 1});
  const double arm = a - mass * g * std::cos(angle) / k_n;
  EXPECT_NEAR(std::abs(contact.v_t),
              g * std::sin(angle) / (0.15 * (1 / mass + arm * arm / (mass * a * a / 2))), 1e-12);
}

}  // namespace
}  // namespace mikromakro::test
