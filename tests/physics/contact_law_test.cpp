// SPDX-License-Identifier: GPL-2.0-or-later
// The contact law of docs/conventions.md (Latzel2001 2.2) as a pure function. Numbers are chosen so that
// every product is exact or off by one rounding.
#include "physics/contact/contact_law.h"
#include "physics/contact/spring_step.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mikromakro::physics {
namespace {

// f_n = 1000 * 0.002 = 2 N at rest, cap = 0.5 * 2 = 1 N.
constexpr ContactParameters parameters{.normal_stiffness = 1000,
                                       .normal_damping = 4,
                                       .tangential_stiffness = 500,
                                       .tangential_damping = 8,
                                       .friction = 0.5};
constexpr double overlap = 0.002, cap = 1, dt = 1e-4;
constexpr double rounding = 1e-15;  // of numbers of order 1

template <Tangential tangential, bool no_attraction = false>
ContactForce force(const ContactState& state, double time = dt) {
  return contact_force<Effects{tangential, no_attraction}>(parameters, state, state.v_t * time);
}

TEST(NormalForce, IsSpringPlusDashpotOnTheRateOfTheOverlap) {
  EXPECT_NEAR(force<Tangential::none>({overlap, 0, 0, 0}).f_n, 2, rounding);
  EXPECT_NEAR(force<Tangential::none>({overlap, 0.25, 0, 0}).f_n, 3, rounding);   // approach repels more
  EXPECT_NEAR(force<Tangential::none>({overlap, -0.25, 0, 0}).f_n, 1, rounding);  // separation less
}

TEST(NormalForce, AttractsOnFastSeparationUnlessThatIsCutOff) {
  EXPECT_NEAR(force<Tangential::none>({overlap, -1, 0, 0}).f_n, -2, rounding);
  EXPECT_EQ((force<Tangential::none, true>({overlap, -1, 0, 0}).f_n), 0);
  EXPECT_NEAR((force<Tangential::none, true>({overlap, 0.25, 0, 0}).f_n), 3, rounding);
}

TEST(NormalForce, ComesWithoutTangentialForceIfThereIsNone) {
  const auto f = force<Tangential::none>({overlap, 0, 0.3, 0.1});
  EXPECT_EQ(f.f_t, 0);
  EXPECT_EQ(f.xi, 0);
}

TEST(NormalForce, WithoutDashpotIsTheSpringAlone) {
  constexpr Effects undamped{Tangential::none, false, Normal::linear, false};
  EXPECT_NEAR((contact_force<undamped>(parameters, {overlap, 0.25, 0, 0}, 0).f_n), 2, rounding);
}

// Hertz: a_12 = 0.008 m and the overlap 0.002 m: sqrt(1.6e-5) = 0.004, f_n = 1000 * 0.004 * 0.002 = 8e-3 N.
constexpr double reduced = 0.008;
constexpr Effects hertz{Tangential::none, false, Normal::hertz, false},
    damped_hertz{Tangential::none, false, Normal::hertz, true},
    viscous_hertz{Tangential::viscous_coulomb, false, Normal::hertz, false};

TEST(HertzForce, IsTheStiffnessTimesTheRootOfRadiusTimesOverlapTimesTheOverlap) {
  EXPECT_NEAR((contact_force<hertz>(parameters, {overlap, 0.25, 0, 0, reduced}, 0).f_n), 8e-3, rounding);
  // Four times the overlap: eight times the force.
  EXPECT_NEAR((contact_force<hertz>(parameters, {4 * overlap, 0, 0, 0, reduced}, 0).f_n), 64e-3, rounding);
}

TEST(HertzForce, AddsTheSameDashpotAsTheLinearLaw) {
  EXPECT_NEAR((contact_force<damped_hertz>(parameters, {overlap, 0.25, 0, 0, reduced}, 0).f_n), 1 + 8e-3,
              rounding);
}

TEST(HertzForce, CapsFriction) {
  // mu f_n = 4e-3 N; gamma_t v_t = 0.8 N is above it, 8e-4 N below.
  EXPECT_NEAR((contact_force<viscous_hertz>(parameters, {overlap, 0, 0.1, 0, reduced}, 0).f_t), -4e-3,
              rounding);
  EXPECT_NEAR((contact_force<viscous_hertz>(parameters, {overlap, 0, 1e-4, 0, reduced}, 0).f_t), -8e-4,
              rounding);
}

TEST(HertzForce, OfAForgottenRadiusIsNotANumber) {
  EXPECT_TRUE(std::isnan(contact_force<hertz>(parameters, {overlap, 0, 0, 0}, 0).f_n));
}

TEST(ReducedRadius, OfTwoDiscsOfADiscOnAFlatWallAndInsideAnArc) {
  EXPECT_DOUBLE_EQ(reduced_radius(3, 6), 2);
  EXPECT_NEAR(reduced_radius(3, 3e16), 3, 1e-15);
  EXPECT_DOUBLE_EQ(reduced_radius(3, -6), 6);  // 1/3 - 1/6 = 1/6
}

TEST(Combinations, OfEffectsAreAllDifferent) {
  for (int one = 0; one < effect_combinations; ++one) {
    for (int other = 0; other < one; ++other)
      EXPECT_FALSE(effects_of_combination(one) == effects_of_combination(other)) << one << " " << other;
  }
}

TEST(ViscousCoulomb, BothBranchesOfEquation1OpposeTheSlip) {
  // gamma_t |v_t| = 0.8 < 1; at v_t = 0.2 it would be 1.6 > 1.
  EXPECT_NEAR(force<Tangential::viscous_coulomb>({overlap, 0, 0.1, 0}).f_t, -0.8, rounding);
  EXPECT_NEAR(force<Tangential::viscous_coulomb>({overlap, 0, -0.1, 0}).f_t, 0.8, rounding);
  EXPECT_NEAR(force<Tangential::viscous_coulomb>({overlap, 0, 0.2, 0}).f_t, -cap, rounding);
  EXPECT_NEAR(force<Tangential::viscous_coulomb>({overlap, 0, -0.2, 0}).f_t, cap, rounding);
}

TEST(ViscousCoulomb, CapTakesTheMagnitudeOfTheTotalNormalForce) {
  // v_n = -1: f_n = 2 - 4 = -2, cap 1; v_n = 0.25: f_n = 3, cap 1.5; cut off: f_n = 0, no friction.
  EXPECT_NEAR(force<Tangential::viscous_coulomb>({overlap, -1, 1, 0}).f_t, -1, rounding);
  EXPECT_NEAR(force<Tangential::viscous_coulomb>({overlap, -1, 0.05, 0}).f_t, -0.4, rounding);
  EXPECT_NEAR(force<Tangential::viscous_coulomb>({overlap, 0.25, 1, 0}).f_t, -1.5, rounding);
  EXPECT_EQ((force<Tangential::viscous_coulomb, true>({overlap, -1, 1, 0}).f_t), 0);
}

TEST(Slip, OfAStepIsTheOneOfVelocityVerlet) {
  // Any accelerations a_k of the slip: v_(k+1/2) = v_(k-1/2) + a_k dt, predicted v_(k+1) = v_(k+1/2) + a_k dt
  // / 2.
  double half_step = 1, slip_rate = 1;
  for (const double kick : {0.3, -0.2, 0.05, 1.7}) {
    half_step += kick;
    slip_rate = slip_rate_of_half_step(slip_rate, half_step + kick / 2);
    EXPECT_NEAR(slip_rate, half_step, 2 * rounding);
  }
}

TEST(Slip, OfTheFirstStepStartsWhereTheDiscsTouched) {
  // overlap / v_n = 0.25 dt, or longer ago than a step: then dt; where the discs separate already: dt.
  EXPECT_NEAR(slip_since_onset({0.25 * dt * 3, 3, 7, 0}, dt), 7 * 0.25 * dt, 1e-19);
  EXPECT_NEAR(slip_since_onset({5 * dt * 3, 3, 7, 0}, dt), 7 * dt, 1e-19);
  EXPECT_NEAR(slip_since_onset({0.25 * dt * 3, -3, 7, 0}, dt), 7 * dt, 1e-19);
  EXPECT_NEAR(slip_since_onset({0.25 * dt * 3, 0, 7, 0}, dt), 7 * dt, 1e-19);
}

TEST(Spring, SticksBelowTheCap) {
  // xi = 0.0005 + 3 * 1e-4 = 0.0008, k_t xi = 0.4.
  const auto f = force<Tangential::spring>({overlap, 0, 3, 0.0005});
  EXPECT_NEAR(f.xi, 0.0008, 1e-18);
  EXPECT_NEAR(f.f_t, -0.4, rounding);
  // While the dashpot attracts, f_n = -2, the cap is 1 as well.
  EXPECT_NEAR(force<Tangential::spring>({overlap, -1, 3, 0.0005}).f_t, -0.4, rounding);
}

TEST(Spring, SlidesAtTheCapAndIsLeftAtTheCap) {
  // xi = 0.0018 + 0.0005 = 0.0023, k_t xi = 1.15 > 1: f_t = -1, k_t xi = 1.
  const auto f = force<Tangential::spring>({overlap, 0, 5, 0.0018});
  EXPECT_NEAR(f.f_t, -cap, rounding);
  EXPECT_NEAR(f.xi, cap / 500, 1e-18);
}

TEST(Spring, UnloadsAlongTheCapWhereTheNormalForceShrinks) {
  // A contact at rest that slid at f_n = 2 keeps k_t xi = mu f_n while f_n falls to 1.5, 1, 0.5, and does not
  // slide back when f_n grows again.
  double xi = cap / 500;
  for (const double f_n : {1.5, 1.0, 0.5}) {
    const auto f = force<Tangential::spring>({f_n / 1000, 0, 0, xi});
    EXPECT_NEAR(f.f_t, -0.5 * f_n, rounding);
    EXPECT_NEAR(f.xi, 0.5 * f_n / 500, 1e-18);
    xi = f.xi;
  }
  EXPECT_NEAR(force<Tangential::spring>({overlap, 0, 0, xi}).f_t, -0.25, rounding);
}

TEST(Spring, ReversedSlidingReloadsFromCapToCapOverASlipOfTwiceTheCap) {
  double xi = 0;
  for (int k = 0; k < 100; ++k) xi = force<Tangential::spring>({overlap, 0, 1, xi}).xi;  // 0.01 m: slides
  ASSERT_NEAR(xi, 0.002, 1e-18);
  // Back by s: f_t = -cap + k_t s up to s = 2 cap / k_t = 0.004 m = 40 steps, then +cap.
  for (int k = 1; k <= 60; ++k) {
    const auto f = force<Tangential::spring>({overlap, 0, -1, xi});
    EXPECT_NEAR(f.f_t, std::min(-cap + 500 * k * dt, cap), 40 * rounding) << k;  // 40 sums
    xi = f.xi;
  }
  EXPECT_NEAR(xi, -0.002, 1e-18);
}

TEST(DampedSpring, AddsTheDashpotWhileItSticks) {
  // xi = 0.0005 + 1e-5, -k_t xi - gamma_t v_t = -0.255 - 0.64.
  const auto f = force<Tangential::damped_spring>({overlap, 0, 0.08, 0.00051 - 8e-6});
  EXPECT_NEAR(f.xi, 0.00051, 1e-18);
  EXPECT_NEAR(f.f_t, -0.255 - 0.64, rounding);
}

TEST(DampedSpring, LeavesTheSpringWhatTheDashpotDoesNotTakeOfTheCap) {
  // trial = -500 * 0.0016 - 0.8 = -1.6: f_t = -1, k_t xi = 1 - 0.8 = 0.2.
  const auto f = force<Tangential::damped_spring>({overlap, 0, 0.1, 0.0016 - 1e-5});
  EXPECT_NEAR(f.f_t, -cap, rounding);
  EXPECT_NEAR(f.xi, 0.2 / 500, 1e-18);
}

TEST(DampedSpring, IsNeverLongerThanTheCapAllows) {
  // gamma_t v_t = 4 alone: the rest for the spring would be 1 - 4 = -3, limited to -1.
  const auto f = force<Tangential::damped_spring>({overlap, 0, 0.5, 0.001});
  EXPECT_NEAR(f.f_t, -cap, rounding);
  EXPECT_NEAR(f.xi, -cap / 500, 1e-18);
}

TEST(SpringAtRest, IsNotMovedByAnEvaluationOverNoTime) {
  EXPECT_EQ(force<Tangential::spring>({overlap, 0, 7, 0.001}, 0).xi, 0.001);
  EXPECT_EQ(force<Tangential::damped_spring>({overlap, 0, 0.01, 0.001}, 0).xi, 0.001);
}

template <Tangential tangential>
void expect_second_evaluation_to_repeat_the_first(const ContactState& state) {
  const auto first = force<tangential>(state);
  const auto second = force<tangential>({state.overlap, state.v_n, state.v_t, first.xi}, 0);
  EXPECT_NEAR(second.f_t, first.f_t, 2 * rounding);
  EXPECT_NEAR(second.xi, first.xi, 1e-18);
}

TEST(SpringAtRest, EvaluatedAgainOverNoTimeRepeatsTheForce) {
  for (const double v_t : {-5.0, -0.5, -0.1, 0.0, 0.01, 0.1, 5.0}) {
    // 0.003: the normal force has fallen, and the slip may have turned round while the contact still slides.
    for (const double xi : {-0.003, -0.0019, 0.0, 0.0012, 0.002, 0.003}) {
      expect_second_evaluation_to_repeat_the_first<Tangential::spring>({overlap, 0.1, v_t, xi});
      expect_second_evaluation_to_repeat_the_first<Tangential::damped_spring>({overlap, 0.1, v_t, xi});
    }
  }
}

/// v_t and xi keep their sign when the particles change places (both n and t turn over), so only a mirror
/// image changes it: the force is odd in (v_t, xi).
template <Tangential tangential>
void expect_odd_in_slip(double v_n, double v_t, double xi) {
  const auto f = force<tangential>({overlap, v_n, v_t, xi}),
             mirrored = force<tangential>({overlap, v_n, -v_t, -xi});
  EXPECT_EQ(f.f_n, mirrored.f_n);
  EXPECT_EQ(f.f_t, -mirrored.f_t);
  EXPECT_EQ(f.xi, -mirrored.xi);
}

TEST(MirrorImage, TurnsTangentialForceAndSpringAround) {
  for (const double v_t : {0.01, 0.3, 5.0}) {
    expect_odd_in_slip<Tangential::viscous_coulomb>(-0.2, v_t, 0);
    expect_odd_in_slip<Tangential::spring>(-0.2, v_t, 0.0005);
    expect_odd_in_slip<Tangential::damped_spring>(-0.2, v_t, 0.0005);
  }
}

struct Body {
  double x, y, v_x, v_y, omega, radius;
};
struct Action {
  double f_x, f_y, torque;
};

/// Force and torque on `one` from `other`, written out from the conventions in contact_law.h.
Action act(const Body& one, const Body& other, double xi) {
  const double distance = std::hypot(other.x - one.x, other.y - one.y);
  const double n_x = (other.x - one.x) / distance, n_y = (other.y - one.y) / distance;
  const double gap = one.radius + other.radius - distance;
  const double w_x = one.v_x - other.v_x, w_y = one.v_y - other.v_y;
  const double arm_one = one.radius - gap / 2, arm_other = other.radius - gap / 2;
  const double v_t = -w_x * n_y + w_y * n_x + one.omega * arm_one + other.omega * arm_other;
  const auto f = force<Tangential::damped_spring>({gap, w_x * n_x + w_y * n_y, v_t, xi});
  return {-f.f_n * n_x - f.f_t * n_y, -f.f_n * n_y + f.f_t * n_x, arm_one * f.f_t};
}

TEST(Exchange, OfTheParticlesTurnsTheForceAroundAndConservesAngularMomentum) {
  const Body one{0.1, 0.2, 0.03, -0.02, 1.5, 0.01}, other{0.112, 0.209, -0.01, 0.01, -0.7, 0.006};
  const auto on_one = act(one, other, 0.0003), on_other = act(other, one, 0.0003);
  EXPECT_NEAR(on_one.f_x, -on_other.f_x, rounding);
  EXPECT_NEAR(on_one.f_y, -on_other.f_y, rounding);
  // Orbital torque of the pair plus both spin torques vanishes: the lever arms meet in the contact point.
  const double orbital = (one.x - other.x) * on_one.f_y - (one.y - other.y) * on_one.f_x;
  EXPECT_GT(std::abs(on_one.torque), 1e-3);                          // there is something to balance
  EXPECT_NEAR(orbital + on_one.torque + on_other.torque, 0, 1e-17);  // rounding of 1e-2 m * 1 N
}

}  // namespace
}  // namespace mikromakro::physics
