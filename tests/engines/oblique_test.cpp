// SPDX-License-Identifier: GPL-2.0-or-later
// Oblique impacts of two equal discs inside the engine against closed forms. The normal force is elastic, so
// the contact lasts t_c = pi sqrt(m12/k_n) and J_n = 2 m12 v_n. With I = m a^2 / 2 a tangential force f_t on
// both rims changes the slip rate by 3 f_t / m12: the tangential mass is m12 / 3.
//
// The closed forms hold for small overlaps and turns of the normal: with v_n = 1e-6 m/s the lever arm is off
// by overlap / 2a = 1e-7 and the normal turns by v_t t_c / 2a = 3e-7 v_t / v_n; both are below every
// tolerance here.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine.h"
#include "physics/contact/contact_duration.h"

namespace mikromakro::test {
namespace {

constexpr double radius = 3.71e-3;  // small disc of the paper's cell [m]
constexpr double density = 6.36;    // rho h [kg/m^2]
constexpr double k_n = 352.1;       // [N/m]
constexpr double v_n = 1e-6;        // of approach [m/s]
const double mass = density * M_PI * radius * radius;
const double m12 = mass / 2;
const double t_c = physics::contact_duration(k_n, 0, m12);
const std::string spring = "tangential disc/cundall_strack",
                  damped_spring = spring + " tangential_damping on", viscous = "tangential disc/viscous";

struct Law {
  std::string tangential;
  double k_t, gamma_t, mu;
};

/// Velocities in units of v_n; the slip rate is (v_1 - v_2).t + a (omega_1 + omega_2).
struct Outcome {
  double v_n, slip, spin_1, spin_2, energy_ratio;
};

double energy(const std::map<int, Disc>& discs) {
  double sum = 0;
  for (const auto& [id, d] : discs) {
    sum += (d.mass * (d.v_x * d.v_x + d.v_y * d.v_y) + d.inertia() * d.omega * d.omega) / 2;
  }
  return sum;
}

/// Two discs meet with the slip rate v_t v_n, `onset` steps after a step; disc 1 brings the part `rim` of the
/// slip as its spin.
Outcome impact(const Law& law, double v_t, double steps_per_contact, double onset, double rim = 0) {
  const double dt = t_c / steps_per_contact, across = (1 - rim) * v_t * v_n / 2;
  Engine engine;
  engine.run(scene("model disc/linear " + law.tangential,
                   {.k_n = k_n, .gamma_n = 0, .k_t = law.k_t, .gamma_t = law.gamma_t, .mu = law.mu}, 0.02));
  engine.run(disc(1, 0, 0, radius, density) + disc(2, 2 * radius + onset * dt * v_n, 0, radius, density));
  engine.run(motion(1, v_n / 2, across, rim * v_t * v_n / radius) + motion(2, -v_n / 2, -across));
  const double before = energy(engine.discs());
  engine.run(fmt::format("fix integrate all nve/disc\ntimestep {:.17g}\nrun {}\n", dt,
                         static_cast<int>(1.1 * steps_per_contact) + 3));
  const auto discs = engine.discs();
  const auto &one = discs.at(1), &two = discs.at(2);
  return {(two.v_x - one.v_x) / v_n, (one.v_y - two.v_y + radius * (one.omega + two.omega)) / v_n,
          one.omega * radius / v_n, two.omega * radius / v_n, energy(discs) / before};
}

/// Error of the slip rate after the impact in units of the one before, over the phases of onset and release
/// within a step.
struct Errors {
  double mean, scatter, rms;
};

Errors errors_over_phases(const Law& law, double v_t, double expected, double steps_per_contact) {
  constexpr int phases = 8, trials = phases * phases;
  double sum = 0, squares = 0;
  for (int onset = 0; onset < phases; ++onset) {
    for (int release = 0; release < phases; ++release) {
      const double steps = steps_per_contact + static_cast<double>(release) / phases;
      const double error = impact(law, v_t, steps, (onset + 0.5) / phases).slip / v_t - expected;
      sum += error / trials;
      squares += error * error / trials;
    }
  }
  return {sum, std::sqrt(squares - sum * sum), std::sqrt(squares)};
}

double order(double coarse, double fine, double ratio) {
  return std::log(std::abs(coarse / fine)) / std::log(ratio);
}

void report(const char* what, double steps, const Errors& e) {
  std::printf("%s, t_c/dt = %3.0f: v_t' / v_t off by %+.2e on average, scatter %.2e\n", what, steps, e.mean,
              e.scatter);
}

// Sticking throughout, the slip oscillates with omega_t^2 = 3 k_t / m12: v_t' = v_t cos(pi sqrt(3 k_t /
// k_n)).
constexpr double never_slides = 1e6;

TEST(StickingSpring, HalfAnOscillationReversesTheSlip) {
  // k_t = k_n / 3: f_t / f_n is constant, both end together at zero, nothing is cut off: order 2 in every
  // phase.
  const Law law{spring, k_n / 3, 0, never_slides};
  const auto coarse = errors_over_phases(law, 1, -1, 40), fine = errors_over_phases(law, 1, -1, 160);
  report("k_t = k_n/3", 40, coarse);
  EXPECT_NEAR(order(coarse.rms, fine.rms, 4), 2, 0.25);
  EXPECT_LT(coarse.rms, 5e-4);  // (omega dt)^2 / 24 = 2.6e-4 of Verlet; onset and release are of its size
}

TEST(StickingSpring, WholeOscillationRestoresTheSlip) {
  const Law law{spring, 4 * k_n / 3, 0, never_slides};
  const auto coarse = errors_over_phases(law, 1, 1, 40), fine = errors_over_phases(law, 1, 1, 160);
  report("k_t = 4 k_n/3", 40, coarse);
  EXPECT_NEAR(order(coarse.rms, fine.rms, 4), 2, 0.25);
  EXPECT_LT(coarse.rms, 2e-3);  // (omega_t dt)^2 is four times as large
}

// In general the spring is still stretched when the discs part, and the force falls from k_t xi to zero. A
// step counts it as acting from half a step before to half a step after it: misplaced by a time that is
// uniform in
// +- dt/2, an error of omega_t sin(omega_t t_c) dt / sqrt(12) of v_t.
TEST(StickingSpring, OfAnyStiffnessIsUnbiasedToOrderTwo) {
  for (const double ratio : {0.2, 0.8}) {
    const double angle = M_PI * std::sqrt(3 * ratio);
    const Law law{spring, ratio * k_n, 0, never_slides};
    const auto coarse = errors_over_phases(law, 1, std::cos(angle), 40);
    const auto fine = errors_over_phases(law, 1, std::cos(angle), 160);
    report(fmt::format("k_t = {} k_n", ratio).c_str(), 40, coarse);
    EXPECT_NEAR(order(coarse.mean, fine.mean, 4), 2, 0.3);
    // 10 % for the 8 x 8 phases and higher orders.
    EXPECT_NEAR(coarse.scatter / (angle / 40 * std::abs(std::sin(angle)) / std::sqrt(12)), 1, 0.1);
    EXPECT_NEAR(order(coarse.scatter, fine.scatter, 4), 1, 0.1);
  }
}

// Sliding throughout, J_t = -mu J_n = -2 mu m12 v_n: v_t' = v_t - 6 mu v_n, and each disc gets the spin
// a J_t / I = -2 mu v_n / a. The spring slides from the start where k_t v_t > mu k_n v_n: force and cap grow
// linearly at onset. Eq. 1 slides where gamma_t v_t exceeds mu max(f_n) = mu v_n sqrt(k_n m12).
const Law slides_as_spring{spring, k_n, 0, 0.1}, slides_viscously{viscous, 0, 10, 0.1};

void expect_gross_sliding(const Law& law, double v_t) {
  for (const double onset : {0.1, 0.5, 0.9}) {
    const auto after = impact(law, v_t, 50, onset);
    // J_n of the steps that were done: m12 (v_n + v_n'). The rest is the turn of the normal and the lever
    // arm.
    const double spin = -law.mu * (1 + after.v_n) * std::copysign(1, v_t);
    EXPECT_NEAR(after.slip, v_t + 3 * spin, 3e-6);
    EXPECT_NEAR(after.spin_1, spin, 3e-6);
    EXPECT_NEAR(after.spin_2, spin, 3e-6);
  }
}

TEST(GrossSliding, TakesMuTimesTheNormalImpulseAtTheRims) {
  expect_gross_sliding(slides_as_spring, 2);
  expect_gross_sliding(slides_as_spring, -2);
  expect_gross_sliding(slides_viscously, 2);
  expect_gross_sliding(slides_viscously, -2);
}

TEST(GrossSliding, ConvergesWithOrderTwo) {
  for (const auto& law : {slides_as_spring, slides_viscously}) {
    const auto coarse = errors_over_phases(law, 2, 1 - 6 * 0.1 / 2, 25);
    const auto fine = errors_over_phases(law, 2, 1 - 6 * 0.1 / 2, 100);
    report(law.tangential.c_str(), 25, coarse);
    EXPECT_NEAR(order(coarse.rms, fine.rms, 4), 2, 0.25);
  }
}

TEST(ViscousForce, SlowsTheSlipExponentially) {
  // Eq. 1 below the cap: v_t' = v_t exp(-3 gamma_t t_c / m12); here 1/e. The force jumps at onset (by gamma_t
  // v_t) and at release, each misplaced by a time uniform in +- dt/2: scatter 3 gamma_t dt / (m12 sqrt(12)),
  // twice.
  const Law law{viscous, 0, m12 / (3 * t_c), never_slides};
  const auto coarse = errors_over_phases(law, 1, std::exp(-1), 25),
             fine = errors_over_phases(law, 1, std::exp(-1), 100);
  report("viscous", 25, coarse);
  // At this gamma_t the terms of order 2 nearly cancel in the mean: only a bound on the order.
  EXPECT_GT(order(coarse.mean, fine.mean, 4), 1.7);
  EXPECT_NEAR(fine.scatter / (std::exp(-1) / 100 / std::sqrt(6)), 1, 0.1);
}

/// Largest relative gain of energy over angles from head-on to grazing, spins and phases.
double largest_gain(const Law& law, double steps_per_contact) {
  double gain = -1;
  for (double v_t = 0.1; v_t < 40; v_t *= 1.5) {
    for (const double rim : {0.0, 1.0}) {
      for (int phase = 0; phase < 4; ++phase) {
        const auto after = impact(law, v_t, steps_per_contact + phase / 4.0, (phase + 0.5) / 4, rim);
        gain = std::max(gain, after.energy_ratio - 1);
      }
    }
  }
  return gain;
}

TEST(GrazingImpact, NeverGainsEnergyBeyondTheSquareOfTheTimeStep) {
  const double gamma_t = m12 / (3 * t_c);
  for (const auto& law : {Law{spring, 0.2 * k_n, 0, 0.5}, Law{spring, k_n, 0, 0.5},
                          Law{damped_spring, 0.8 * k_n, gamma_t, 0.5}, Law{viscous, 0, 0.15, 0.5}}) {
    const double coarse = largest_gain(law, 25), fine = largest_gain(law, 100);
    std::printf("%s: largest gain of energy %.1e at t_c/25, %.1e at t_c/100\n", law.tangential.c_str(),
                coarse, fine);
    // The elastic normal impact alone gives back its energy to (omega dt)^2 / 12, either way.
    EXPECT_LT(coarse, std::pow(M_PI / 25, 2) / 12);
    EXPECT_LT(fine, std::pow(M_PI / 100, 2) / 12);
  }
}

}  // namespace
}  // namespace mikromakro::test
