// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lattice_frame.h"
#include "measured_error.h"

namespace mikromakro {
namespace {

constexpr double pi = std::numbers::pi;
// Some 10^2 terms of size 1 are added, each with a rounding of 1e-16: 1e-12 leaves a factor of 100.
constexpr double rounding = 1e-12;

const AveragingOptions free_discs{{1}, Branch::radius};

// Isotropic compression: spacing d = 1.98 for radius 1, so overlap = 0.02 at all six contacts of each of the
// 37 free discs (4 shells of which the outermost is wall). One ring 0..20 around the patch, h = 0.5, holds
// all of them: w = 1.
//   V = 400 pi h, V^p = pi h:                         nu = 37/400
//   sum_c n (x) n of six directions, 60 degrees apart = 3 I:  F = nu 3 I
//   f = -k_n 0.02 n on the disc, l = 1 n:             sigma = -(37/V) 3 k_n 0.02 I
TEST(TriangularLattice, IsotropicCompressionAsWorkedByHand) {
  const LatticeSetup lattice{1, 1.98, 100, 4, Eigen::Matrix2d::Identity()};
  const RingAverage average(make_lattice(lattice), {{0, 20}, {0, 0}, 0.5, "sliced", free_discs});
  const double nu = 37.0 / 400;
  expect_measured(average.at("nu"), nu, rounding);
  expect_measured(average.at("nu_3"), nu, rounding);
  expect_measured(average.at("coordination"), 6, rounding);
  expect_measured(average.at("F_rr"), 3 * nu, rounding);
  expect_measured(average.at("F_phiphi"), 3 * nu, rounding);
  expect_measured(average.at("F_rphi"), 0, rounding);
  expect_measured(average.at("F_phir"), 0, rounding);
  const double pressure = 37 * 3 * 100 * 0.02 / (400 * pi * 0.5);
  expect_measured(average.at("sigma_rr"), -pressure, rounding * pressure);
  expect_measured(average.at("sigma_phiphi"), -pressure, rounding * pressure);
  expect_measured(average.at("sigma_rphi"), 0, rounding * pressure);
  expect_measured(average.at("sigma_phir"), 0, rounding * pressure);
}

// The contact point is overlap/2 = 0.01 inside the disc: l = 0.99 n instead of 1 n.
TEST(TriangularLattice, BranchToTheContactPointIsShorterByHalfTheOverlap) {
  const Frame frame = make_lattice({1, 1.98, 100, 3, Eigen::Matrix2d::Identity()});
  const RingAverage radius(frame, {{0, 20}, {0, 0}, 1, "sliced", {{1}, Branch::radius}});
  const RingAverage contact(frame, {{0, 20}, {0, 0}, 1, "sliced", {{1}, Branch::contact}});
  expect_measured(contact.at("sigma_rr") / radius.at("sigma_rr"), 0.99, rounding);
}

struct Dyads {
  Eigen::Matrix2d fabric = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d stress = Eigen::Matrix2d::Zero();
};

// Simple shear x -> x + g y of the lattice d. The three branches of a disc (and their opposites) become
//   b_1 = d (1, 0),  b_2 = d (1/2 + g s, s),  b_3 = d (-1/2 + g s, s),  s = sqrt(3)/2,
// with |b_1| = d, |b_2|^2 = d^2 (1 + g s + g^2 s^2), |b_3|^2 = d^2 (1 - g s + g^2 s^2) since s^2 = 3/4. Each
// disc has
//   sum_c n (x) n     =  2 sum_i b_i (x) b_i / |b_i|^2
//   sum_c f (x) l     = -2 sum_i k_n (2a - |b_i|) a b_i (x) b_i / |b_i|^2
// in the x-y basis, the same for all discs.
Dyads sheared_disc(double d, double g, double k_n) {
  const double s = 0.5 * std::numbers::sqrt3;
  const double length[] = {d, d * std::sqrt(1 + g * s + g * g * s * s),
                           d * std::sqrt(1 - g * s + g * g * s * s)};
  const Eigen::Vector2d branch[] = {{d, 0}, {d * (0.5 + g * s), d * s}, {d * (-0.5 + g * s), d * s}};
  Dyads dyads;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Matrix2d dyad = 2 * branch[i] * branch[i].transpose() / (length[i] * length[i]);
    dyads.fabric += dyad;
    dyads.stress -= k_n * (2 - length[i]) * dyad;
  }
  return dyads;
}

// A symmetric tensor T in the polar basis at the angle phi: T_rr = t + q cos 2phi + u sin 2phi, T_phiphi = t
// - q cos 2phi - u sin 2phi, T_rphi = T_phir = -q sin 2phi + u cos 2phi, with t = (T_xx + T_yy)/2, q = (T_xx
// - T_yy)/2, u = T_xy. Summed over discs the angles enter by C = sum cos 2phi and S = sum sin 2phi only.
void expect_polar(const RingAverage& average, const std::string& name, const Eigen::Matrix2d& disc_tensor,
                  const Eigen::Vector3d& n_c_s) {
  const double t = 0.5 * disc_tensor.trace();
  const double q = 0.5 * (disc_tensor(0, 0) - disc_tensor(1, 1));
  const double u = disc_tensor(0, 1);
  const double deviator = q * n_c_s[1] + u * n_c_s[2];
  const double off = -q * n_c_s[2] + u * n_c_s[1];
  const double size = rounding * std::abs(n_c_s[0] * t);
  expect_measured(average.at(name + "_rr"), n_c_s[0] * t + deviator, size);
  expect_measured(average.at(name + "_phiphi"), n_c_s[0] * t - deviator, size);
  expect_measured(average.at(name + "_rphi"), off, size);
  expect_measured(average.at(name + "_phir"), off, size);
}

// One free disc at 45 degrees from the centre of the rings (C = 0, S = 1), 3 (1, 1) away; two shells, so six
// wall discs. V = pi (6^2 - 2^2) h with h = 1 holds the disc whole; V^p = pi.
TEST(TriangularLattice, SimpleShearOfOneDiscAt45DegreesAsWorkedByHand) {
  LatticeSetup lattice{1, 1.96, 50, 1, Eigen::Matrix2d::Identity()};
  lattice.gradient(0, 1) = 0.02;
  const RingAverage average(make_lattice(lattice), {{2, 6}, {-3, -3}, 1, "sliced", free_discs});
  const Dyads disc = sheared_disc(1.96, 0.02, 50);
  const double volume = 32 * pi;
  expect_measured(average.at("nu"), 1.0 / 32, rounding);
  expect_polar(average, "F", disc.fabric * pi / volume, {1, 0, 1});
  expect_polar(average, "sigma", disc.stress / volume, {1, 0, 1});
}

// 19 free discs around an off-centre point: C and S from the positions, cos 2phi = (x^2 - y^2)/r^2, sin 2phi
// = 2xy/r^2.
TEST(TriangularLattice, SimpleShearOfAPatchAsWorkedByHand) {
  LatticeSetup lattice{1, 1.96, 50, 3, Eigen::Matrix2d::Identity()};
  lattice.gradient(0, 1) = 0.02;
  const Frame frame = make_lattice(lattice);
  const Eigen::Vector2d centre{-8, -2};
  Eigen::Vector3d n_c_s = Eigen::Vector3d::Zero();
  for (const Particle& particle : frame.particles) {
    if (particle.type != 1) continue;
    const Eigen::Vector2d arm = particle.position - centre;
    n_c_s += Eigen::Vector3d(1, (arm[0] * arm[0] - arm[1] * arm[1]) / arm.squaredNorm(),
                             2 * arm[0] * arm[1] / arm.squaredNorm());
  }
  ASSERT_EQ(n_c_s[0], lattice_bulk_discs(lattice));
  const RingAverage average(frame, {{0, 30}, centre, 0.25, "sliced", free_discs});
  const Dyads disc = sheared_disc(1.96, 0.02, 50);
  const double volume = 900 * pi * 0.25;
  expect_measured(average.at("nu"), 19.0 / 900, rounding);
  expect_polar(average, "F", disc.fabric * pi * 0.25 / volume, n_c_s);
  expect_polar(average, "sigma", disc.stress / volume, n_c_s);
}

// Thin rings across the discs: V nu, V F and V sigma summed over rings are those of the whole patch.
TEST(TriangularLattice, RingsAddUpToTheWhole) {
  const Frame frame = make_lattice({1, 1.98, 100, 4, Eigen::Matrix2d::Identity()});
  const auto edges = equal_ring_edges(0, 20, 300);
  const RingAverage rings(frame, {edges, {0.3, 0.1}, 1, "sliced", free_discs});
  const RingAverage whole(frame, {{0, 20}, {0.3, 0.1}, 1, "sliced", free_discs});
  for (const std::string name : {"nu", "F_rr", "F_phiphi", "sigma_rr", "sigma_phiphi"}) {
    double sum = 0;
    for (int i = 0; i < 300; ++i) {
      const auto k = static_cast<std::size_t>(i);
      sum += rings.at(name, i) * (edges[k + 1] * edges[k + 1] - edges[k] * edges[k]) / 400;
    }
    expect_measured(sum / whole.at(name), 1, rounding, name);
  }
}

// tr F = nu C holds in every ring, since C is weighted by volume.
TEST(TriangularLattice, TraceOfFabricIsSolidFractionTimesCoordinationInEveryRing) {
  const RingAverage rings(make_lattice({1, 1.98, 100, 4, Eigen::Matrix2d::Identity()}),
                          {equal_ring_edges(0, 9, 30), {1, 0}, 1, "sliced", {}});
  for (int i = 0; i < 30; ++i) {
    const double product = rings.at("nu", i) * rings.at("coordination", i);
    expect_measured(rings.at("F_rr", i) + rings.at("F_phiphi", i), product, rounding);
  }
}

}  // namespace
}  // namespace mikromakro
