// Duration and restitution of a contact (seed 2.2): t_c = pi / sqrt(k_n/m12 - (gamma_n/2 m12)^2),
// e_n = exp(-gamma_n t_c / 2 m12).
#include "physics/contact_duration.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mikromakro::physics {
namespace {

// Discs of the seed's cell: rho = 1060 kg/m^3, h = 6 mm, diameters 7.42 and 8.99 mm; k_n, gamma_n.
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

TEST(ContactDuration, OverdampedIsTheUndampedTimeScale) {
  // gamma/2 m12 = 5 is critical: the square root would be 0, beyond it imaginary.
  EXPECT_NEAR(contact_duration(50, 20, 2), M_PI / 5, 1e-15);
  EXPECT_NEAR(contact_duration(50, 200, 2), M_PI / 5, 1e-15);
}

TEST(ReducedMass, IsHalfForEqualMassesAndTheLighterOneAgainstAWall) {
  EXPECT_DOUBLE_EQ(reduced_mass(3, 3), 1.5);
  EXPECT_DOUBLE_EQ(reduced_mass(3, 6), reduced_mass(6, 3));
  EXPECT_NEAR(reduced_mass(3, 3e15), 3, 3e-14);
}

}  // namespace
}  // namespace mikromakro::physics
