// SPDX-License-Identifier: GPL-2.0-or-later
// Eq. 20, stiffness and micropolar quantities on lattices whose values can be written down.
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
const Eigen::Matrix2d undeformed = Eigen::Matrix2d::Identity();

RingSetup whole_patch(double height, double k_n) {
  RingSetup setup;
  setup.edges = {0, 40};
  setup.height = height;
  setup.options.bulk_types = {1};
  setup.fields = {"all"};
  setup.field_options.normal_stiffness = k_n;
  return setup;
}

// One free disc and its neighbours (wall discs) on the x axis of the rings, so that e_r = e_x, e_phi = e_y.
RingSetup on_x_axis(double k_n) {
  RingSetup setup = whole_patch(1, k_n);
  setup.centre = {-20, 0};
  return setup;
}

// A disc of radius a at the origin with wall discs around it at the given places.
Frame make_star(double a, double k_n, const std::vector<Eigen::Vector2d>& places) {
  Frame frame;
  frame.particles = {make_disc(1, {0, 0}, a)};
  for (const Eigen::Vector2d& place : places) {
    const int index = static_cast<int>(frame.particles.size());
    frame.particles.push_back(make_disc(index + 1, place, a, 2));
    frame.contacts.push_back(make_contact(frame, 0, index, k_n));
  }
  return frame;
}

// a = 2, overlap 0.04 at all six contacts of each disc: Delta = -0.04 n, l = 2 n. eps = -0.04/2 times the
// identity; with sigma = -nu/(pi a^2 h) 3 k_n 0.04 a: E = tr sigma/tr eps = 3 k_n nu/(pi h), that is E h/k_n
// = 3 nu/pi = tr F/(2 pi). eps does not depend on the basis, so any number of discs and shells will do.
TEST(ElasticLattice, IsotropicCompressionGivesOverlapOverRadius) {
  const LatticeSetup lattice{2, 3.96, 100, 4, undeformed};
  const RingAverage average(make_lattice(lattice), whole_patch(0.5, 100));
  expect_measured(average.at("eps_rr"), -0.02, rounding);
  expect_measured(average.at("eps_phiphi"), -0.02, rounding);
  expect_measured(average.at("eps_rphi"), 0, rounding);
  expect_measured(average.at("eps_phir"), 0, rounding);
  const double nu = 37 * 4.0 / 1600;
  expect_measured(average.at("E"), 3 * nu / pi, rounding);
  // Both deviators are 0 to rounding, and their quotient, as the axes, would be any number.
  EXPECT_TRUE(std::isnan(average.at("G")));
  EXPECT_TRUE(std::isnan(average.at("angle_eps")));
  expect_measured(2 * pi * average.at("E"), average.at("tr_F"), rounding);
  // No springs and no tangential forces.
  expect_measured(average.at("M_zr"), 0, rounding);
  EXPECT_EQ(average.at("kappa_zr"), 0);
  EXPECT_TRUE(std::isnan(average.at("mu_c")));
}

// Without k_n E is in Pa: 3 k_n nu/(pi h) with k_n = 100, h = 0.5.
TEST(ElasticLattice, StiffnessIsInPascalWithoutNormalStiffness) {
  const RingAverage average(make_lattice({2, 3.96, 100, 4, undeformed}), whole_patch(0.5, 0));
  expect_measured(average.at("E") / (600 * 37 * 4.0 / 1600 / pi), 1, rounding);
  EXPECT_TRUE(std::isnan(average.at("kappa_zr")));
  EXPECT_EQ(average.notes().at(0), "curvature: no tangential springs and no --kn, not defined");
}

// Square lattice: overlaps 0.06 along x, 0.02 along y, a = 1. The two directions do not mix: eps_rr = -0.06,
// eps_phiphi = -0.02. F = nu 2 diag(1, 1), sigma = -2 k_n/V diag(0.06, 0.02): G = dev sigma/dev eps = 2
// k_n/V, V = 1600 pi; in units of k_n/h, h = 1: 2/(1600 pi).
TEST(ElasticLattice, SquareLatticeUnderUniaxialCompression) {
  const Frame frame = make_star(1, 30, {{1.94, 0}, {-1.94, 0}, {0, 1.98}, {0, -1.98}});
  const RingAverage average(frame, on_x_axis(30));
  expect_measured(average.at("eps_rr"), -0.06, rounding);
  expect_measured(average.at("eps_phiphi"), -0.02, rounding);
  expect_measured(average.at("eps_rphi"), 0, rounding);
  expect_measured(average.at("E") * 1600 * pi, 2, rounding);
  expect_measured(average.at("G") * 1600 * pi, 2, rounding);
  expect_measured(average.at("dev_eps"), 0.04, rounding);
  expect_measured(average.at("angle_eps"), 0, rounding);
  expect_measured(average.at("eps_major"), -0.06, rounding);
  expect_measured(average.at("eps_minor"), -0.02, rounding);
  EXPECT_TRUE(std::isnan(average.at("angle_F")) || average.at("dev_F") < rounding);
}

// The same square turned by 45 degrees, compressed along one diagonal only (overlaps 0.06 and 0): eps = -0.03
// in all four places, the major axis at 45 degrees, principal values -0.06 and 0.
TEST(ElasticLattice, SquareLatticeAcrossTheAxesIsSheared) {
  const double c = std::numbers::sqrt2 / 2;
  const Frame frame =
      make_star(1, 30, {{1.94 * c, 1.94 * c}, {-1.94 * c, -1.94 * c}, {-2 * c, 2 * c}, {2 * c, -2 * c}});
  const RingAverage average(frame, on_x_axis(30));
  for (const std::string name : {"eps_rr", "eps_rphi", "eps_phir", "eps_phiphi"})
    expect_measured(average.at(name), -0.03, rounding, name);
  expect_measured(average.at("angle_eps"), 45, 100 * rounding);
  expect_measured(average.at("angle_sigma"), 45, 100 * rounding);
  expect_measured(average.at("eps_major"), -0.06, rounding);
  expect_measured(average.at("eps_minor"), 0, rounding);
}

// Triangular lattice, extended by the factor 1 + e along x before it is compressed to d = 1.96: contacts
// along x have overlap o_1 = 2 - d (1 + e), the four others o_2 = 2 - d q with q^2 = ((1 + e)^2 + 3)/4, and
// the cosine c = (1 + e)/(2 q) to x. Sums over the contacts of a disc of radius 1:
//   sum Delta l = -diag(2 o_1 + 4 o_2 c^2, 4 o_2 s^2), sum l l = diag(2 + 4 c^2, 4 s^2)
// eps_yy = -o_2, eps_xx = -(o_1 + 2 o_2 c^2)/(1 + 2 c^2): the mean of the overlaps with their weights.
TEST(ElasticLattice, TriangularLatticeUnderUniaxialExtension) {
  LatticeSetup lattice{1, 1.96, 50, 1, undeformed};
  const double e = 0.01;
  lattice.gradient(0, 0) = 1 + e;
  const RingAverage average(make_lattice(lattice), on_x_axis(50));
  const double q = std::sqrt((1 + e) * (1 + e) + 3) / 2;
  const double c2 = (1 + e) * (1 + e) / (4 * q * q);
  const double o1 = 2 - 1.96 * (1 + e);
  const double o2 = 2 - 1.96 * q;
  expect_measured(average.at("eps_rr"), -(o1 + 2 * o2 * c2) / (1 + 2 * c2), rounding);
  expect_measured(average.at("eps_phiphi"), -o2, rounding);
  expect_measured(average.at("eps_rphi"), 0, rounding);
  // Two of six contacts at 0 and 180 degrees, four at +-theta: a_2 = 2 dev F/tr F.
  expect_measured(average.at("contact_angle_h2_amplitude"), 2 * average.at("dev_F") / average.at("tr_F"),
                  rounding);
}

// Contacts along one line do not fix eps across it; nor do no contacts at all. Nothing is 0 or inf.
TEST(ElasticLattice, SingularFabricGivesNan) {
  const double c = std::cos(0.3);
  const double s = std::sin(0.3);
  const Frame line = make_star(1, 30, {{1.94 * c, 1.94 * s}, {-1.98 * c, -1.98 * s}});
  const Frame alone = make_star(1, 30, {});
  for (const Frame& frame : {line, alone}) {
    const RingAverage average(frame, on_x_axis(30));
    for (const std::string name :
         {"eps_rr", "eps_phiphi", "kappa_zr", "kappa_zphi", "E", "G", "mu_c", "dev_eps", "angle_eps"})
      EXPECT_TRUE(std::isnan(average.at(name))) << name;
  }
}

// Discs of a triangular lattice (d = 1.98, a = 1) have turned by theta = g x, g = (0.03, -0.02): slip xi of p
// against q = p + d n is a (theta_p + theta_q) = 2 theta_p + d g.n. The disc at the origin has theta = 0:
//   sum (l x Delta) l = -sum xi n = -d sum (g.n) n = -3 d g,  sum l l = 3:  kappa = -d g
// With springs k_t = 40: f_t = -k_t xi, M = -40 * 3 d g/V, V = 1600 pi: mu_c = 120/(1600 pi).
TEST(ElasticLattice, GradientOfTheSpinGivesCurvatureAndCoupleStress) {
  Frame frame = make_lattice({1, 1.98, 100, 1, undeformed});
  const Eigen::Vector2d g{0.03, -0.02};
  for (Contact& contact : frame.contacts) {
    const auto theta = [&](int index) {
      return g.dot(frame.particles[static_cast<std::size_t>(index)].position);
    };
    const Eigen::Vector2d tangent{-contact.normal[1], contact.normal[0]};
    contact.spring = theta(contact.index1) + theta(contact.index2);
    contact.force -= 40 * contact.spring * tangent;
  }
  const RingAverage with_springs(frame, on_x_axis(100));
  expect_measured(with_springs.at("kappa_zr"), -1.98 * 0.03, rounding);
  expect_measured(with_springs.at("kappa_zphi"), 1.98 * 0.02, rounding);
  expect_measured(with_springs.at("M_zr") * 1600 * pi, -120 * 1.98 * 0.03, rounding);
  expect_measured(with_springs.at("M_zphi") * 1600 * pi, 120 * 1.98 * 0.02, rounding);
  expect_measured(with_springs.at("mu_c") * 1600 * pi, 120, 120 * rounding);
  EXPECT_EQ(with_springs.notes().at(0), "curvature: Delta_t = -xi t, from the tangential springs");

  // Without springs Delta_t = f_t/k_n: the same curvature times k_t/k_n = 0.4.
  for (Contact& contact : frame.contacts) contact.spring = 0;
  const RingAverage by_forces(frame, on_x_axis(100));
  expect_measured(by_forces.at("kappa_zr"), -1.98 * 0.03 * 0.4, rounding);
  expect_measured(by_forces.at("mu_c") * 1600 * pi, 300, 300 * rounding);
  EXPECT_EQ(by_forces.notes().at(0), "curvature: no tangential springs, Delta_t = f_t/k_n");
}

// All discs turned by the same angle: xi = 2 theta everywhere, which no curvature fits.
TEST(ElasticLattice, UniformSpinHasNoCurvature) {
  Frame frame = make_lattice({1, 1.98, 100, 3, undeformed});
  for (Contact& contact : frame.contacts) contact.spring = 0.05;
  const RingAverage average(frame, whole_patch(1, 100));
  expect_measured(average.at("kappa_zr"), 0, rounding);
  expect_measured(average.at("kappa_zphi"), 0, rounding);
}

}  // namespace
}  // namespace mikromakro
