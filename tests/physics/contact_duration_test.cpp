// SPDX-License-Identifier: GPL-2.0-or-later
// Duration and restitution of a contact (Latzel2001 2.2): t_c = pi / sqrt(k_n/m12 - (gamma_n/2 m12)^2),
// e_n = exp(-gamma_n t_c / 2 m12).
#include "physics/contact/contact_duration.h"
#include "physics/contact/laws/linear.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mikromakro::physics {
namespace {

// Discs of the paper's cell: rho = 1060 kg/m^3, h = 6 mm, diameters 7.42 and 8.99 mm; k_n, gamma_n.
constexpr double areal_density = 1060 * 6e-3;  // [kg/m^2]
const double small = areal_density * M_PI * 3.71e-3 * 3.71e-3;
const double large = areal_density * M_PI * 4.495e-3 * 4.495e-3;
constexpr double k_n = 352.1, gamma_n = 0.19;

TEST(ContactDuration, OfTheCouetteDiscsIsWhatTheConventionsQuote) {
  // m = 6.36 * 4.3241e-5 = 2.7501e-4 kg, m12 = 1.3751e-4 kg, k/m12 = 2.5606e6, (gamma/2m12)^2 = 4.773e5:
  // t_c = pi / sqrt(2.0833e6) = 2.1766e-3 s, e_n = exp(-690.87 * 2.1766e-3) = 0.2223.
  EXPECT_NEAR(contact_duration(k_n, gamma_n, reduced_mass(small, small)), 2.18e-3,
              0.005e-3);                                                            // quoted to 3 digits
  EXPECT_NEAR(restitution(k_n, gamma_n, reduced_mass(small, small)), 0.22, 0.005);  // quoted to 2 digits
  EXPECT_NEAR(contact_duration(k_n, gamma_n, reduced_mass(small, large)), 2.33e-3, 0.005e-3);
  EXPECT_NEAR(restitution(k_n, gamma_n, reduced_mass(small, large)), 0.26, 0.005);
}

TEST(ContactDuration, TimeStepOfTheSeedIsAboutAFiftiethOfTheShortestContact) {
  EXPECT_NEAR(contact_duration(k_n, gamma_n, reduced_mass(small, small)) / 4e-5, 54.4, 0.1);
}

TEST(ContactDuration, OfRoundNumbers) {
  // k/m12 = 25, (gamma/2 m12)^2 = 9: t_c = pi/4, e_n = exp(-3 pi/4).
  EXPECT_NEAR(contact_duration(50, 12, 2), M_PI / 4, 1e-15);
  EXPECT_NEAR(restitution(50, 12, 2), std::exp(-3 * M_PI / 4), 1e-15);
  EXPECT_DOUBLE_EQ(restitution(50, 0, 2), 1);
}

TEST(DampingOfRestitution, IsTheInverseOfTheRestitution) {
  // The numbers above: k = 50, m12 = 2, gamma = 12 have e_n = exp(-3 pi/4).
  EXPECT_NEAR(damping_of_restitution(50, std::exp(-3 * M_PI / 4), 2), 12, 1e-14);
  EXPECT_EQ(damping_of_restitution(50, 1, 2), 0);
}

TEST(ContactDuration, OverdampedIsTheUndampedTimeScale) {
  // gamma/2 m12 = 5 is critical: the square root would be 0, beyond it imaginary.
  EXPECT_NEAR(contact_duration(50, 20, 2), M_PI / 5, 1e-15);
  EXPECT_NEAR(contact_duration(50, 200, 2), M_PI / 5, 1e-15);
}

// pi sqrt(m12/k) of the stiffer spring: four times as stiff, half as long.
TEST(ContactDuration, IsThatOfTheTangentialSpringIfThatIsStiffer) {
  ContactParameters material;
  material.normal_stiffness = 50;
  const Collision pair{2, 1, 0, 0};
  const double normal = LinearNormal::duration(material, pair);
  EXPECT_NEAR(normal, M_PI / 5, 1e-15);
  material.tangential_stiffness = 40;
  EXPECT_EQ(LinearNormal::duration(material, pair), normal);
  material.tangential_stiffness = 200;
  EXPECT_NEAR(LinearNormal::duration(material, pair), normal / 2, 1e-15);
}

// Hertz: m12 d2x/dt2 = -k_H x^(3/2), dx/dt = v at first contact.
constexpr double k_h = 3e4, m12 = 1.4e-4;  // [N/m^(3/2)], [kg]

TEST(HertzContact, LargestOverlapHoldsTheKineticEnergy) {
  // int_0^d k_H x^(3/2) dx = 2/5 k_H d^(5/2).
  const double d = hertz_largest_overlap(k_h, m12, 0.3);
  EXPECT_NEAR(0.4 * k_h * std::pow(d, 2.5) / (m12 * 0.3 * 0.3 / 2), 1, 1e-14);
}

TEST(HertzContact, LastsThreePointTwoOneEight) {
  // The constant of Hertz's impact, 3.2181 (m^2/(k^2 v))^(1/5), quoted to four digits.
  EXPECT_NEAR(hertz_contact_duration(1, 1, 1), 3.2181, 5e-5);
  // A factor 32 of the velocity halves it, one of the mass multiplies it by four.
  EXPECT_NEAR(hertz_contact_duration(k_h, m12, 32 * 0.3) / hertz_contact_duration(k_h, m12, 0.3), 0.5, 1e-14);
  EXPECT_NEAR(hertz_contact_duration(k_h, 32 * m12, 0.3) / hertz_contact_duration(k_h, m12, 0.3), 4, 1e-13);
}

TEST(HertzContact, LastsAsLongAsTheEquationOfMotionTells) {
  // Energy: dx/dt = v sqrt(1 - (x/d)^(5/2)), so with x = d sin(theta)^(4/5) half the contact lasts
  // 4/5 d/v int_0^(pi/2) sin(theta)^(-1/5) dtheta. theta = u^5 takes out the singularity at 0: midpoint rule,
  // error ~ 1/n^2.
  const double v = 0.3, d = hertz_largest_overlap(k_h, m12, v);
  constexpr int n = 4000;
  const double end = std::pow(M_PI / 2, 0.2);
  double sum = 0;
  for (int k = 0; k < n; ++k) {
    const double u = end * (k + 0.5) / n;
    sum += std::pow(std::sin(std::pow(u, 5)), -0.2) * 5 * std::pow(u, 4) * end / n;
  }
  EXPECT_NEAR(2 * 0.8 * d / v * sum / hertz_contact_duration(k_h, m12, v), 1, 1e-6);
}

TEST(HertzContact, SlopeIsTheDerivativeOfTheForce) {
  // Central difference: truncation h^2/(24 x^2) = 4e-10, rounding 1e-16 x/h = 1e-12.
  const double x = 1e-4, h = 1e-8;
  const double slope = k_h * (std::pow(x + h, 1.5) - std::pow(x - h, 1.5)) / (2 * h);
  EXPECT_NEAR(hertz_tangent_stiffness(k_h, x) / slope, 1, 1e-9);
  EXPECT_DOUBLE_EQ(hertz_stiffness(6, 0.25), 3);
}

TEST(ReducedMass, IsHalfForEqualMassesAndTheLighterOneAgainstAWall) {
  EXPECT_DOUBLE_EQ(reduced_mass(3, 3), 1.5);
  EXPECT_DOUBLE_EQ(reduced_mass(3, 6), reduced_mass(6, 3));
  EXPECT_NEAR(reduced_mass(3, 3e15), 3, 3e-14);
}

}  // namespace
}  // namespace mikromakro::physics
