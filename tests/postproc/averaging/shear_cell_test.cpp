// SPDX-License-Identifier: GPL-2.0-or-later
// Identities that hold in every ring of a real, disordered packing: a snapshot of the shear cell.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "measured_error.h"
#include "shear_cell_frame.h"

namespace mikromakro {
namespace {

constexpr int rings = shear_cell_ring_count;

// 2 pi E h/k_n = tr F (1 - d_F^2)/(1 - d_B d_F cos 2(phi_B - phi_F)), d = dev/tr (docs/conventions.md):
// algebra of Eqs. 16 and 20 when f = k_n Delta; then B is sigma up to a factor. 10^3 terms of sums and a
// division each: 1e-9 leaves plenty.
TEST(ShearCell, StiffnessIdentityHoldsInEveryRingForElasticNormalForces) {
  const RingAverage average(with_elastic_normal_forces(read_shear_cell()), shear_cell_rings());
  for (int i = 0; i < rings; ++i) {
    const auto at = [&](const std::string& name) { return average.at(name, i); };
    const double d_f = at("dev_F") / at("tr_F");
    const double d_b = at("dev_sigma") / -at("tr_sigma");
    const double angle = (at("angle_sigma") - at("angle_F")) * std::numbers::pi / 180;
    const double slope = (1 - d_f * d_f) / (1 - d_b * d_f * std::cos(2 * angle));
    expect_measured(2 * std::numbers::pi * at("E") / (at("tr_F") * slope), 1, 1e-9);
  }
}

// eps knows nothing of the forces: E with all forces over E with the elastic ones is the quotient of tr
// sigma. What it differs from 1 by is the dashpots' share of the pressure, below 1 % at this slow shear.
TEST(ShearCell, DifferenceWithAllForcesIsTheShareOfTheDashpots) {
  const Frame frame = read_shear_cell();
  const RingAverage all(frame, shear_cell_rings());
  const RingAverage elastic(with_elastic_normal_forces(frame), shear_cell_rings());
  double largest = 0;
  for (int i = 0; i < rings; ++i) {
    const double share = all.at("tr_sigma", i) / elastic.at("tr_sigma", i) - 1;
    expect_measured(all.at("E", i) / elastic.at("E", i) - 1, share, 1e-12);
    largest = std::fmax(largest, std::abs(share));
  }
  RecordProperty("dashpot_share", fmt::format("{:.1e}", largest));
  EXPECT_GT(largest, 0);
  EXPECT_LT(largest, 0.01);
}

// n is a unit vector to 15 digits in the file.
TEST(ShearCell, TraceOfFabricIsSolidFractionTimesCoordinationInEveryRing) {
  const RingAverage average(read_shear_cell(), shear_cell_rings());
  for (int i = 0; i < rings; ++i)
    expect_measured(average.at("tr_F", i), average.at("nu", i) * average.at("coordination", i), 1e-12);
}

// The second harmonic of the contact directions is the deviator of the fabric: a_2 = 2 dev F/tr F, same axis.
// The axis has the rounding of F over its deviator, 1e-2 of F at least.
TEST(ShearCell, SecondHarmonicOfContactDirectionsIsTheFabric) {
  const RingAverage average(read_shear_cell(), shear_cell_rings());
  for (int i = 0; i < rings; ++i) {
    expect_measured(average.at("contact_angle_h2_amplitude", i),
                    2 * average.at("dev_F", i) / average.at("tr_F", i), 1e-12);
    expect_measured(average.at("contact_angle_h2_angle", i), average.at("angle_F", i), 1e-9);
  }
}

// f_t = -k_t xi without sliding and dashpots: M and kappa have the same sign, mu_c > 0, in every ring.
TEST(ShearCell, RotationalStiffnessIsPositive) {
  const RingAverage average(read_shear_cell(), shear_cell_rings());
  for (int i = 0; i < rings; ++i) EXPECT_GT(average.at("mu_c", i), 0) << i;
}

}  // namespace
}  // namespace mikromakro
