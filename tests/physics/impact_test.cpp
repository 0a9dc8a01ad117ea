// SPDX-License-Identifier: GPL-2.0-or-later
// Impacts of two discs without an engine: the order of the error of a time step, for each scheme. The pair is
// the small discs of the paper's cell; closed forms are those of contact_duration.h.
#include "physics/impact/impact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/contact/contact_duration.h"

namespace mikromakro::physics {
namespace {

constexpr double radius = 3.71e-3, k_n = 352.1, gamma_n = 0.19;
const double mass = 6.36 * M_PI * radius * radius, m12 = mass / 2;
constexpr Effects normal_only{}, with_spring{Tangential::spring}, equation_1{Tangential::viscous_coulomb},
    hertz{Tangential::none, false, Normal::hertz};

/// At 1e-4 m/s the overlap is 2e-5 of a radius: closed forms of a fixed normal hold to that.
Impact impact(double damping, double v_t) {
  return {{k_n, damping, 0.8 * k_n, 0.15, 0.44}, radius, mass, 1e-4, v_t,
          contact_duration(k_n, damping, m12)};
}

double order(double coarse, double fine) {
  return std::log2(std::abs(coarse / fine)) / 2;
}

/// From t_c/50 to t_c/200.
template <Effects effects>
double order_of_rms(const Impact& one, Scheme scheme, Quantity quantity) {
  const auto exact = exact_rebound<effects>(one);
  return order(error_over_phases<effects>(one, 50, scheme, exact).rms[quantity],
               error_over_phases<effects>(one, 200, scheme, exact).rms[quantity]);
}

TEST(RateOfStep, SumsUpToTheDurationOfTheContact) {
  // A disc that comes in at 2 m/s, a step of 0.1 s: with the overlaps 0.2 (s + k) m the rates of ten steps
  // add up to 2 (s + 9.5) m/s, the way from the onset to half a step after the last one over dt. 2e-14:
  // rounding of ten terms.
  for (const double s : {1e-9, 0.2, 0.5, 0.8, 1.0}) {
    for (const double v_n : {2.0, -2.0}) {
      double sum = 0;
      for (int k = 0; k < 10; ++k) sum += rate_of_step({0.2 * (s + k), v_n, 0, 0}, 10);
      EXPECT_NEAR(sum, v_n * (s + 9.5), 2e-14) << s;
    }
  }
}

TEST(RateOfStep, DoesNotJump) {
  // Slope at most 3/2 in s: 1e-6 of overlap per 0.2 m.
  for (double overlap = 1e-6; overlap < 1; overlap += 1e-3) {
    const double here = rate_of_step({overlap, 2, 0, 0}, 10),
                 there = rate_of_step({overlap + 1e-6, 2, 0, 0}, 10);
    EXPECT_LE(std::abs(here - there), 1.5 * 2 * 1e-6 / 0.2 * (1 + 1e-6)) << overlap;
  }
}

TEST(RateOfStep, IsTheRateInTheMiddleOfAContactAndForAnInstant) {
  EXPECT_EQ(rate_of_step({0.41, 2, 0, 0}, 10), 2);
  EXPECT_EQ(rate_of_step({0.41, -2, 0, 0}, 10), -2);
  EXPECT_EQ(rate_of_step({1e-9, 0, 0, 0}, 10), 0);
  EXPECT_EQ(rate_of_step({1e-9, -2, 0, 0}, std::numeric_limits<double>::infinity()), -2);
}

TEST(ForceOfStep, KeepsFrictionBelowItsCapAndTheSpring) {
  // k_n overlap = 0.1 N, gamma_n v_n = 0.4 N for half of it: s = 1/3, 3/2 s = 1/2. f_n = 0.5 becomes 0.3 N.
  const ContactParameters p{
      .normal_stiffness = 100, .normal_damping = 4, .tangential_stiffness = 500, .friction = 0.5};
  const ContactState s{1e-3, 0.1, 1, 0};
  const auto now = contact_force<with_spring>(p, s, 1e-3),
             step = force_of_step<with_spring>(p, s, now, 1e2 / 3);
  EXPECT_NEAR(now.f_n, 0.5, 1e-15);
  EXPECT_NEAR(now.f_t, -0.25, 1e-15);
  EXPECT_NEAR(step.f_n, 0.3, 1e-15);
  EXPECT_NEAR(step.f_t, -0.15, 1e-15);  // at the cap before, at the cap after
  EXPECT_EQ(step.xi, now.xi);
}

TEST(ForceOfStep, IsTheForceOfTheInstantInTheMiddleOfAContactToTheLastBit) {
  const ContactParameters p{
      .normal_stiffness = 100, .normal_damping = 4, .tangential_stiffness = 500, .friction = 0.5};
  const ContactState s{0.0113, 0.1, 0.3, 0};
  const auto now = contact_force<with_spring>(p, s, 1e-5), step = force_of_step<with_spring>(p, s, now, 33);
  EXPECT_EQ(step.f_n, now.f_n);
  EXPECT_EQ(step.f_t, now.f_t);
}

TEST(ForceOfStep, OfNoForceIsNone) {
  const ContactParameters p{
      .normal_stiffness = 100, .normal_damping = 4, .tangential_stiffness = 500, .friction = 0.5};
  // 100 * 1e-3 = 4 * 0.025: the dashpot's pull cancels the spring's push.
  const ContactState s{1e-3, -0.025, 1, 0};
  const auto now = contact_force<with_spring>(p, s, 1e-3);
  ASSERT_EQ(now.f_n, 0);
  EXPECT_EQ(force_of_step<with_spring>(p, s, now, 10).f_t, 0);
}

TEST(Impact, AgreesWithTheClosedForms) {
  const auto damped = exact_rebound<normal_only>(impact(gamma_n, 0)),
             elastic = exact_rebound<normal_only>(impact(0, 0));
  EXPECT_NEAR(damped[restitution_of_impact], restitution(k_n, gamma_n, m12),
              1e-7);  // what exact_rebound promises
  EXPECT_NEAR(damped[duration_of_impact], 1, 1e-7);
  EXPECT_NEAR(elastic[restitution_of_impact], 1, 1e-7);
  EXPECT_NEAR(elastic[energy_left], 1, 1e-7);
}

TEST(Impact, OfHalfStepVelocitiesIsOfFirstOrder) {
  EXPECT_NEAR(order_of_rms<normal_only>(impact(gamma_n, 0), Scheme::half_step, restitution_of_impact), 1,
              0.1);
  EXPECT_NEAR(order_of_rms<normal_only>(impact(gamma_n, 0), Scheme::half_step, duration_of_impact), 1, 0.1);
}

TEST(Impact, OfTheSameInstantIsOfFirstOrderByTheJumpsOfTheDashpot) {
  EXPECT_NEAR(order_of_rms<normal_only>(impact(gamma_n, 0), Scheme::same_instant, restitution_of_impact), 1,
              0.1);
  EXPECT_NEAR(order_of_rms<with_spring>(impact(gamma_n, 1e-4), Scheme::same_instant, slip_after), 1, 0.1);
}

TEST(Impact, WithTheShareOfTheStepInContactIsOfSecondOrder) {
  const auto head_on = impact(gamma_n, 0), oblique = impact(gamma_n, 1e-4);
  // 0.3: terms of order 3 at t_c/50.
  for (const auto quantity : {restitution_of_impact, duration_of_impact, energy_left}) {
    EXPECT_NEAR(order_of_rms<normal_only>(head_on, Scheme::share_of_step, quantity), 2, 0.3);
    EXPECT_NEAR(order_of_rms<with_spring>(oblique, Scheme::share_of_step, quantity), 2, 0.3);
    EXPECT_NEAR(order_of_rms<equation_1>(oblique, Scheme::share_of_step, quantity), 2, 0.3);
  }
  EXPECT_NEAR(order_of_rms<with_spring>(oblique, Scheme::share_of_step, slip_after), 2, 0.3);
  EXPECT_NEAR(order_of_rms<equation_1>(oblique, Scheme::share_of_step, slip_after), 2, 0.3);
}

TEST(Impact, OfHertzsLawWithDashpotIsOfSecondOrderToo) {
  Impact one = impact(gamma_n, 0);
  one.law.normal_stiffness = 1e7;  // t_c of an elastic impact at 1e-4 m/s: 4.6 ms
  one.law.normal_damping = 0.05;
  one.duration = hertz_contact_duration(hertz_stiffness(1e7, radius / 2), m12, 1e-4);
  EXPECT_NEAR(order_of_rms<hertz>(one, Scheme::same_instant, restitution_of_impact), 1, 0.15);
  EXPECT_NEAR(order_of_rms<hertz>(one, Scheme::share_of_step, restitution_of_impact), 2, 0.3);
}

TEST(Impact, WithoutDashpotIsTheSameInAllSchemesToTheLastBit) {
  const auto one = impact(0, 0);
  EXPECT_EQ(rebound<normal_only>(one, 50, 0.3, Scheme::half_step),
            rebound<normal_only>(one, 50, 0.3, Scheme::share_of_step));
}

TEST(Impact, ThatNeverEndsIsNotANumber) {
  EXPECT_TRUE(
      std::isnan(rebound<normal_only>(impact(2, 0), 50, 0.5, Scheme::share_of_step)[restitution_of_impact]));
}

}  // namespace
}  // namespace mikromakro::physics
