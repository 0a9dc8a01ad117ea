// SPDX-License-Identifier: GPL-2.0-or-later
// Head-on collisions under Hertz's law inside the engine: duration against the closed form 3.2181
// (m12^2/(k_H^2 v))^(1/5), restitution with the dashpot against an integration of the equation of motion.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine.h"
#include "engine/engine_access.h"
#include "law/disc_law.h"
#include "physics/contact/contact_duration.h"

namespace mikromakro::test {
namespace {

// A small and a large disc of the paper's cell; the law is as stiff as the cell's linear one at the largest
// overlap.
constexpr double a_1 = 3.71e-3, a_2 = 4.495e-3, density = 6.36, speed = 0.02;
constexpr double k_n = 1e6;  // [N/m^2]
const double m12 = physics::reduced_mass(density * M_PI * a_1 * a_1, density* M_PI* a_2* a_2);
const double k_h = physics::hertz_stiffness(k_n, physics::reduced_radius(a_1, a_2));

struct Rebound {
  double restitution, duration;
};

/// m12 d2x/dt2 = -k_H x^(3/2) - gamma_n dx/dt from x = 0 at the velocity `at` until x = 0 again, by
/// Runge-Kutta of order
/// 4. The root at x = 0 leaves an error of (step/duration)^(5/2) = 1e-11 of one step; the end is found by a
/// straight line within the last step, which adds (step/duration)^2 = 1e-9.
Rebound integrate_impact(double gamma_n, double at = speed) {
  const double dt = physics::hertz_contact_duration(k_h, m12, at) / 30000;
  const auto acceleration = [&](double x, double v) {
    return (-k_h * std::pow(std::max(x, 0.0), 1.5) - gamma_n * v) / m12;
  };
  double x = 0, v = at, t = 0;
  while (true) {
    const double a1 = acceleration(x, v), v2 = v + dt / 2 * a1;
    const double a2 = acceleration(x + dt / 2 * v, v2), v3 = v + dt / 2 * a2;
    const double a3 = acceleration(x + dt / 2 * v2, v3), v4 = v + dt * a3;
    const double a4 = acceleration(x + dt * v3, v4);
    const double x_next = x + dt / 6 * (v + 2 * v2 + 2 * v3 + v4);
    const double v_next = v + dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    if (x_next <= 0) {
      const double part = x / (x - x_next);
      return {-(v + part * (v_next - v)) / at, t + part * dt};
    }
    x = x_next, v = v_next, t += dt;
  }
}

/// Lets two discs collide; they touch for the first time `phase` steps after a step.
Rebound collide(const std::string& law, double gamma_n, double dt, double phase) {
  const double start = phase * dt * speed;
  const int steps = static_cast<int>(std::ceil(2 * physics::hertz_contact_duration(k_h, m12, speed) / dt));
  Engine engine;
  engine.run(scene("model disc/hertz tangential off" + law, {.k_n = k_n, .gamma_n = gamma_n}));
  engine.run(disc(1, 0, 0, a_1, density) + disc(2, a_1 + a_2 + start, 0, a_2, density));
  engine.run(motion(1, speed / 2, 0) + motion(2, -speed / 2, 0));
  engine.run(fmt::format("fix integrate all nve/disc\ntimestep {:.17g}\nrun {}\n", dt, steps));
  const auto discs = engine.discs();
  const double v_after = discs.at(2).v_x - discs.at(1).v_x;
  const double gap = discs.at(2).x - discs.at(1).x - a_1 - a_2;
  return {v_after / speed, steps * dt - gap / v_after - phase * dt};
}

/// Over the phases of first contact and of separation within a step: relative errors of the restitution, and
/// of the duration.
struct Errors {
  double mean, scatter, rms, rms_duration;
};

Errors errors_over_phases(const std::string& law, double gamma_n, double steps_per_contact) {
  const auto exact = integrate_impact(gamma_n);
  constexpr int phases = 8, trials = phases * phases;
  double sum = 0, squares = 0, squares_duration = 0;
  for (int onset = 0; onset < phases; ++onset) {
    for (int release = 0; release < phases; ++release) {
      const double steps = steps_per_contact + static_cast<double>(release) / phases;
      const auto rebound = collide(law, gamma_n, exact.duration / steps, (onset + 0.5) / phases);
      const double error = rebound.restitution / exact.restitution - 1;
      sum += error / trials;
      squares += error * error / trials;
      squares_duration += std::pow(rebound.duration / exact.duration - 1, 2) / trials;
    }
  }
  return {sum, std::sqrt(squares - sum * sum), std::sqrt(squares), std::sqrt(squares_duration)};
}

double order(double coarse, double fine, double ratio) {
  return std::log(std::abs(coarse / fine)) / std::log(ratio);
}

TEST(HertzImpact, IntegrationOfTheTestReproducesTheClosedForm) {
  const auto exact = integrate_impact(0);
  EXPECT_NEAR(exact.duration / physics::hertz_contact_duration(k_h, m12, speed), 1, 2e-9);
  EXPECT_NEAR(exact.restitution, 1, 2e-9);
}

TEST(HertzImpact, ElasticReboundConvergesInTheTimeStep) {
  const auto coarse = errors_over_phases(" damping off", 0, 25),
             fine = errors_over_phases(" damping off", 0, 100);
  std::printf("elastic: e_n off by rms %.1e, t_c by %.1e at t_c/25; %.1e, %.1e at t_c/100\n", coarse.rms,
              coarse.rms_duration, fine.rms, fine.rms_duration);
  // Verlet keeps the energy up to terms in f^2 dt^2 and v^2 df/dx dt^2; at both ends, within a step of x = 0,
  // df/dx ~ (v dt)^(1/2) is left of them: order 5/2. The frequency is off by order 2.
  EXPECT_NEAR(order(coarse.rms, fine.rms, 4), 2.5, 0.2);
  EXPECT_NEAR(order(coarse.rms_duration, fine.rms_duration, 4), 2, 0.3);
}

TEST(HertzImpact, WithDashpotIsUnbiasedToOrderTwo) {
  constexpr double gamma_n = 0.05;
  const auto exact = integrate_impact(gamma_n), faster = integrate_impact(gamma_n, 1.01 * speed);
  // The dashpot's force jumps at onset and at release; each jump is misplaced by a time that is uniform in
  // +- dt/2, an error of the velocity of gamma_n dt/(m12 sqrt(12)). The one at onset changes e_n as well,
  // which grows with the velocity: s = 1 + dln e_n/dln v.
  const double s = 1 + std::log(faster.restitution / exact.restitution) / std::log(1.01);
  EXPECT_GT(s, 1);
  Errors errors[2];
  for (int k = 0; k < 2; ++k) {
    const double steps = 50 << (2 * k);
    errors[k] = errors_over_phases("", gamma_n, steps);
    const double scatter = gamma_n * exact.duration / steps / m12 * std::sqrt((1 + s * s) / 12);
    std::printf("dashpot, t_c/dt = %3.0f: e_n = %.4f off by %+.2e on average, scatter %.2e (jumps: %.2e)\n",
                steps, exact.restitution, errors[k].mean, errors[k].scatter, scatter);
    EXPECT_NEAR(errors[k].scatter / scatter, 1, 0.1);  // 8 x 8 phases and higher orders
  }
  EXPECT_NEAR(order(errors[0].mean, errors[1].mean, 4), 2, 0.3);
}

TEST(HertzImpact, WithoutDashpotHasTheForceOfADashpotOfZero) {
  const double dt = physics::hertz_contact_duration(k_h, m12, speed) / 50;
  // x + 0 v is x: the same numbers.
  EXPECT_EQ(collide(" damping off", 0.19, dt, 0.5).restitution, collide("", 0, dt, 0.5).restitution);
}

TEST(HertzLaw, KnowsItsSettings) {
  Engine engine;
  engine.run(
      scene("model disc/hertz tangential disc/cundall_strack limitForce on damping off", {.k_n = k_n}));
  const auto* law = styles::active_disc_law(engine.lammps());
  ASSERT_NE(law, nullptr);
  EXPECT_EQ(law->effects(),
            (physics::Effects{physics::Tangential::spring, true, physics::Normal::hertz, false}));
}

}  // namespace
}  // namespace mikromakro::test
