// SPDX-License-Identifier: GPL-2.0-or-later
// Head-on collisions of two discs inside the engine against the closed form of the linear spring-dashpot law
// (Latzel2001 2.2): t_c = pi / sqrt(k_n/m12 - (gamma_n/2 m12)^2), e_n = exp(-gamma_n t_c / 2 m12).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine.h"
#include "physics/contact/contact_duration.h"

namespace mikromakro::test {
namespace {

constexpr double radius = 3.71e-3;  // small disc of the paper's cell [m]
constexpr double speed = 0.02;      // of approach [m/s]: overlap / radius stays below 1 %
constexpr double density = 6.36;    // rho h [kg/m^2]
constexpr double k_n = 352.1;       // [N/m]
const double mass = density * M_PI * radius * radius;
const double m12 = mass / 2;

struct Rebound {
  double restitution, duration;
};

/// Lets two discs collide; they touch for the first time `phase` steps after a step.
Rebound collide(double gamma_n, double dt, double phase, const std::string& integrator) {
  const double start = phase * dt * speed;
  const double t_c = physics::contact_duration(k_n, gamma_n, m12);
  const int steps = static_cast<int>(std::ceil(1.5 * t_c / dt)) + 2;
  Engine engine;
  engine.run(scene("model disc/linear tangential off", {.k_n = k_n, .gamma_n = gamma_n}));
  engine.run(disc(1, 0, 0, radius, density) + disc(2, 2 * radius + start, 0, radius, density));
  engine.run(motion(1, speed / 2, 0) + motion(2, -speed / 2, 0));
  engine.run(fmt::format("fix integrate all {}\ntimestep {:.17g}\nrun {}\n", integrator, dt, steps));
  const auto discs = engine.discs();
  const double v_after = discs.at(2).v_x - discs.at(1).v_x;
  const double gap = discs.at(2).x - discs.at(1).x - 2 * radius;
  const double t_exit = steps * dt - gap / v_after;
  return {v_after / speed, t_exit - phase * dt};
}

/// Relative errors over the phases of first contact and of separation within a step.
struct Errors {
  double rms_restitution, rms_duration, mean_restitution, scatter_restitution;
};

/// Both phases have to be varied: where t_c/dt is a whole number the errors of onset and release cancel.
Errors errors_over_phases(double gamma_n, double steps_per_contact, const std::string& integrator) {
  const double t_c = physics::contact_duration(k_n, gamma_n, m12);
  const double e_n = physics::restitution(k_n, gamma_n, m12);
  constexpr int phases = 8;
  double sum = 0, sum_squared = 0, sum_squared_duration = 0;
  for (int onset = 0; onset < phases; ++onset) {
    for (int release = 0; release < phases; ++release) {
      // Multiples of 1/8 keep the release, like the onset, in the middle of eighths of a step.
      const double steps = steps_per_contact + static_cast<double>(release) / phases;
      const auto rebound = collide(gamma_n, t_c / steps, (onset + 0.5) / phases, integrator);
      const double error = rebound.restitution / e_n - 1;
      sum += error;
      sum_squared += error * error;
      sum_squared_duration += std::pow(rebound.duration / t_c - 1, 2);
    }
  }
  constexpr int trials = phases * phases;
  const double mean = sum / trials;
  return {std::sqrt(sum_squared / trials), std::sqrt(sum_squared_duration / trials), mean,
          std::sqrt(sum_squared / trials - mean * mean)};
}

double order(double coarse, double fine, double ratio) {
  return std::log(coarse / fine) / std::log(ratio);
}

TEST(HeadOnCollision, MassOfADiscIsArealDensityTimesArea) {
  Engine engine;
  engine.run(scene("model disc/linear tangential off", {}) + disc(1, 0, 0, radius, density));
  // One multiplication order against another: rounding only.
  EXPECT_NEAR(engine.discs().at(1).mass / mass, 1, 1e-14);
}

TEST(HeadOnCollision, ElasticReboundConvergesWithOrderTwoInTheTimeStep) {
  const auto coarse = errors_over_phases(0, 40, "nve/disc"), fine = errors_over_phases(0, 160, "nve/disc");
  // Order 2 of velocity Verlet; the kink of the force at first contact adds terms of the same order with a
  // phase.
  EXPECT_NEAR(order(coarse.rms_restitution, fine.rms_restitution, 4), 2, 0.25);
  EXPECT_NEAR(order(coarse.rms_duration, fine.rms_duration, 4), 2, 0.25);
  // omega dt = pi/40: (omega dt)^2 / 24 = 2.6e-4 is the textbook frequency error of Verlet.
  EXPECT_NEAR(coarse.rms_duration / 2.6e-4, 1, 0.5);
}

// With the dashpot the force jumps by gamma_n v at onset and by gamma_n v e_n at release. A step counts the
// force as acting from half a step before to half a step after it, so each jump is misplaced by a time that
// is uniform in
// +- dt/2: a relative error of the velocity of +- gamma_n dt / 2 m12, standard deviation gamma_n dt / (m12
// sqrt(12)), twice.
double scatter_of_the_jumps(double dt) {
  return 0.19 * dt / m12 / std::sqrt(6);
}

TEST(HeadOnCollision, DashpotOfTheSameInstantIsUnbiasedToOrderTwo) {
  const double t_c = physics::contact_duration(k_n, 0.19, m12);
  Errors errors[3];
  const double steps[3] = {50, 100, 200};
  for (int k = 0; k < 3; ++k) {
    errors[k] = errors_over_phases(0.19, steps[k], "nve/disc");
    std::printf(
        "t_c/dt = %3.0f, velocities of the same instant: e_n off by %+.2e on average, scatter %.2e (jumps: "
        "%.2e)\n",
        steps[k], errors[k].mean_restitution, errors[k].scatter_restitution,
        scatter_of_the_jumps(t_c / steps[k]));
    // First order remains in the scatter alone, and it is the jumps'; 10 % for the 8 x 8 phases and higher
    // orders.
    EXPECT_NEAR(errors[k].scatter_restitution / scatter_of_the_jumps(t_c / steps[k]), 1, 0.1);
  }
  EXPECT_NEAR(order(errors[0].mean_restitution, errors[2].mean_restitution, 4), 2, 0.3);
}

TEST(HeadOnCollision, DashpotOfHalfStepVelocitiesIsBiasedToOrderOneAsInTheStockIntegrator) {
  const auto coarse = errors_over_phases(0.19, 50, "nve/disc velocity half_step");
  const auto fine = errors_over_phases(0.19, 200, "nve/disc velocity half_step");
  std::printf("half-step velocities: e_n off by %+.2e at t_c/50, %+.2e at t_c/200\n", coarse.mean_restitution,
              fine.mean_restitution);
  EXPECT_NEAR(order(-coarse.mean_restitution, -fine.mean_restitution, 4), 1, 0.15);
  const auto stock = errors_over_phases(0.19, 50, "nve/sphere");
  // The same scheme in another order of operations: equal to the rounding of 75 steps.
  EXPECT_NEAR(stock.mean_restitution / coarse.mean_restitution, 1, 1e-9);
}

}  // namespace
}  // namespace mikromakro::test
