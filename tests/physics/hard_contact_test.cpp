// SPDX-License-Identifier: GPL-2.0-or-later
// The contact law where it is hard on a simulation: slips that are tiny or change their sign, grazing
// impacts, large overlaps, heavy damping. Criteria are in docs/results/stability.md.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "physics/contact/contact_duration.h"
#include "physics/contact/contact_energy.h"
#include "physics/impact/impact.h"

namespace mikromakro::physics {
namespace {

constexpr double radius = 3.71e-3, k_n = 352.1;
const double mass = 6.36 * M_PI * radius * radius, m12 = mass / 2;
const ContactParameters parameters{k_n, 0.19, 0.8 * k_n, 0.15, 0.44};

/// The least that a contact takes out of the motion in a step, over the largest energy in it: under slips of
/// any size and either sign, while f_n goes up and down.
template <Tangential tangential>
double least_dissipation(double fastest) {
  constexpr Effects effects{tangential};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  constexpr double dt = 4e-5;
  double least = 0, largest = 0, xi = 0;
  for (int k = 0; k < 1000000; ++k) {
    const double slip_rate = fastest * uniform(random) * std::pow(10, -9 * std::abs(uniform(random)));
    const double overlap = 1e-5 * (1 + 0.9 * std::sin(1e-3 * k));
    const ContactState state{overlap, 0, slip_rate, xi};
    const auto force = contact_force<effects>(parameters, state, slip_rate * dt);
    const double stored = spring_energy(parameters, force.xi) - spring_energy(parameters, xi);
    const double lost = tangential_power(force.f_t, slip_rate) * dt - stored;
    largest = std::max({largest, std::abs(stored), spring_energy(parameters, xi)});
    least = std::min(least, lost);
    xi = force.xi;
  }
  return largest > 0 ? least / largest : least;
}

// Work on the contact and what its spring gives and takes are rounded to 1e-16 of the spring's energy. Beside
// a tangential dashpot that holds only where the dashpot alone stays below the cap, gamma_t v_t < mu f_n
// (0.44 * 3.5e-4 N / 0.15 kg/s = 1e-3 m/s): beyond, the law stretches its spring against the slip.
TEST(Dissipation, IsNeverNegativeInAnyStep) {
  const double viscous = least_dissipation<Tangential::viscous_coulomb>(1),
               spring = least_dissipation<Tangential::spring>(1),
               damped = least_dissipation<Tangential::damped_spring>(1e-3);
  std::printf("least dissipation: Eq. 1 %.1e J, spring %.1e, with dashpot %.1e of the spring's energy\n",
              viscous, spring, damped);
  EXPECT_EQ(viscous, 0);
  EXPECT_GT(spring, -1e-15);
  EXPECT_GT(damped, -1e-15);
}

// A block on a plane, held by f_n = 0.02 N. Under Eq. 1 it comes to rest like exp(-gamma_t t/m): its slip
// keeps its sign. Under the spring it swings about its place, with less and less amplitude where there is a
// dashpot.
TEST(SlidingToRest, DoesNotChatterUnderEquation1) {
  double v = 0.1;
  for (int k = 0; k < 100000 && v != 0; ++k) {
    const auto force =
        contact_force<Effects{Tangential::viscous_coulomb}>(parameters, {0.02 / k_n, 0, v, 0}, 0);
    const double next = v + 4e-5 / mass * force.f_t;
    ASSERT_GE(next, 0) << k;
    ASSERT_LE(next, v) << k;
    v = next;
  }
  EXPECT_LT(v, 1e-320);  // down to the smallest numbers that there are
}

TEST(SlidingToRest, SwingsOutUnderADampedSpring) {
  double v = 0.1, xi = 0, last_top = 1;
  int tops = 0;
  for (int k = 0; k < 20000; ++k) {
    const double slip = 4e-5 * v;
    const auto force =
        contact_force<Effects{Tangential::damped_spring}>(parameters, {0.02 / k_n, 0, v, xi}, slip);
    xi = force.xi;
    const double next = v + 4e-5 / mass * force.f_t;
    if ((next > 0) != (v > 0)) {
      EXPECT_LT(std::abs(xi), last_top) << k;
      last_top = std::abs(xi);
      ++tops;
    }
    v = next;
    if (last_top < 1e-18) break;
  }
  EXPECT_GT(tops, 5);
  EXPECT_LT(last_top, 1e-18);
}

/// Largest gain of kinetic energy over angles from head-on to grazing, 16 phases.
template <Effects effects>
double largest_gain(const ContactParameters& law, double steps) {
  double gain = -1;
  for (double v_t = 0.1; v_t < 1000; v_t *= 1.5) {
    const Impact impact{law, radius, mass, 1e-6, v_t * 1e-6, contact_duration(k_n, law.normal_damping, m12)};
    for (int onset = 0; onset < 4; ++onset) {
      for (int release = 0; release < 4; ++release) {
        const auto after =
            rebound<effects>(impact, steps + release / 4.0, (onset + 0.5) / 4, Scheme::same_instant);
        gain = std::max(gain, after[energy_left] - 1);
      }
    }
  }
  return gain;
}

// (omega dt)^2/12 is the error of an elastic rebound, either way; with a dashpot there is nothing to gain.
TEST(GrazingImpact, GainsNoEnergy) {
  ContactParameters elastic = parameters;
  elastic.normal_damping = 0;
  for (const double steps : {20.0, 50.0, 200.0}) {
    const double bound = std::pow(M_PI / steps, 2) / 12;
    const double spring = largest_gain<Effects{Tangential::spring}>(elastic, steps),
                 viscous = largest_gain<Effects{Tangential::viscous_coulomb}>(elastic, steps);
    const double damped = std::max({largest_gain<Effects{Tangential::spring}>(parameters, steps),
                                    largest_gain<Effects{Tangential::damped_spring}>(parameters, steps),
                                    largest_gain<Effects{Tangential::viscous_coulomb}>(parameters, steps)});
    std::printf("t_c/%.0f: largest gain %.1e (spring), %.1e (Eq. 1), with dashpot %.1e; bound %.1e\n", steps,
                spring, viscous, damped, bound);
    EXPECT_LT(spring, bound);
    EXPECT_LT(viscous, bound);
    EXPECT_LT(damped, 0);
  }
}

// Restitution from 0.9 down to where the contact is nearly critical: between 0 and 1, and falling.
TEST(HeavyDamping, NeverGivesBackMoreThanLighterOne) {
  for (const double steps : {10.0, 50.0}) {
    double before = 1;
    for (const double e_n : {0.9, 0.6, 0.3, 0.1, 0.03}) {
      ContactParameters law = parameters;
      law.normal_damping = damping_of_restitution(k_n, e_n, m12);
      const Impact impact{law, radius, mass, 1e-4, 0, contact_duration(k_n, law.normal_damping, m12)};
      const double after =
          rebound<Effects{}>(impact, steps, 0.5, Scheme::same_instant)[restitution_of_impact];
      EXPECT_GT(after, 0) << e_n;
      EXPECT_LT(after, before) << e_n;
      before = after;
    }
  }
}

// From rest with an overlap of 20 % of the radius: what comes out is what was stored, 4 k_n a^2/100 / 2, to
// the error of order 2 of a quarter of a swing, (omega dt)^2/4.
TEST(LargeOverlap, GivesBackItsElasticEnergy) {
  using Pair = FreePair<Effects{}>;
  ContactParameters law = parameters;
  law.normal_damping = 0;
  const double apart = 1.8 * radius, dt = contact_duration(k_n, 0, m12) / 50;
  Pair pair(
      law, {Pair::Disc{{{0, 0}, {0, 0}, 0, radius}, mass}, Pair::Disc{{{apart, 0}, {0, 0}, 0, radius}, mass}},
      dt, Scheme::same_instant);
  for (int k = 0; k < 100; ++k) pair.step();
  const double stored = k_n * std::pow(0.2 * radius, 2) / 2;
  EXPECT_LT(pair.state().overlap, 0);
  EXPECT_NEAR(pair.kinetic_energy() / stored, 1, std::pow(M_PI / 50, 2) / 2);
}

}  // namespace
}  // namespace mikromakro::physics
