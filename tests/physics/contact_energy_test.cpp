// SPDX-License-Identifier: GPL-2.0-or-later
#include "physics/contact/contact_energy.h"

#include <gtest/gtest.h>

namespace mikromakro::physics {
namespace {

constexpr Effects linear{}, hertz{.normal = Normal::hertz};
const ContactParameters material{1000, 0.2, 800, 0.15, 0.5};

/// The elastic force summed over overlaps up to that of the state, by Simpson's rule.
template <Effects effects>
double work_of_compression(ContactState s) {
  const double end = s.overlap;
  constexpr int steps = 20000;
  double sum = 0;
  for (int k = 0; k <= steps; ++k) {
    s.overlap = end * k / steps;
    sum += (k == 0 || k == steps ? 1 : k % 2 == 1 ? 4 : 2) * elastic_force<effects>(material, s);
  }
  return sum * end / steps / 3;
}

// Simpson's rule is exact for the linear force; at the root's end of Hertz's it errs by about steps^(-5/2).
TEST(NormalEnergy, IsTheWorkOfCompression) {
  const ContactState state{1e-4, 0, 0, 0, 2e-3};
  EXPECT_NEAR(normal_energy<linear>(material, state) / work_of_compression<linear>(state), 1, 1e-12);
  EXPECT_NEAR(normal_energy<hertz>(material, state) / work_of_compression<hertz>(state), 1, 1e-9);
}

TEST(SpringEnergy, ByHand) {
  EXPECT_DOUBLE_EQ(spring_energy(material, -1e-3), 4e-4);
}

// gamma_n v_n^2; where attraction is cut off, less: f_n = 0 leaves -k_n overlap v_n, the energy given back to
// no one.
TEST(DashpotPower, ByHand) {
  const ContactState state{1e-4, -3, 0, 0};
  EXPECT_NEAR(dashpot_power<linear>(material, state, 0.1 - 0.6), 1.8, 1e-15);
  EXPECT_NEAR(dashpot_power<linear>(material, state, 0), 0.3, 1e-15);
}

TEST(TangentialPower, IsPositiveAgainstTheSlip) {
  EXPECT_EQ(tangential_power(-2, 3), 6);
}

}  // namespace
}  // namespace mikromakro::physics
