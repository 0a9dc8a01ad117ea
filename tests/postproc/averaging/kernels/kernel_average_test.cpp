// SPDX-License-Identifier: GPL-2.0-or-later
// Averages with kernels: what is weighted how.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "averaging/volumes/grid_volumes.h"
#include "fields/tensor_parts.h"
#include "measured_error.h"
#include "model/error.h"
#include "ring_average.h"
#include "shear_cell_frame.h"

namespace mikromakro {
namespace {

constexpr double sigma = 0.6;

// Integral of the standard normal density up to u, and that of this.
double below(double u) {
  return 0.5 * std::erfc(-u / std::numbers::sqrt2);
}
double integral_of_below(double u) {
  return u * below(u) + std::exp(-0.5 * u * u) / std::sqrt(2 * std::numbers::pi);
}

// Part of a Gauss kernel at x between low and high, and its mean for x from a to b.
double part(double x, double low, double high) {
  return below((high - x) / sigma) - below((low - x) / sigma);
}
double mean_part(double a, double b, double low, double high) {
  const auto integral = [&](double x) {
    return sigma * (integral_of_below((low - x) / sigma) - integral_of_below((high - x) / sigma));
  };
  return (integral(b) - integral(a)) / (b - a);
}

// Two discs of radius 0.5, 0.9 apart along x, and a wall on the left that the first one overlaps by 0.1.
// Forces on disc 1: (-3, 1) of disc 2, (2, 0.5) of the wall.
Frame pair_at_a_wall() {
  Frame frame;
  frame.particles = {make_disc(1, {0.4, 0.3}, 0.5), make_disc(2, {1.3, 0.3}, 0.5)};
  frame.particles[0].velocity = {2, 0};
  frame.contacts = {make_contact(frame, 0, 1, 1), {1, -1, 0, -1, {-1, 0}, 0.1, {2, 0.5}, 0}};
  frame.contacts[0].force = {-3, 1};
  return frame;
}

// Cell 0.2..1, 0..0.5 of thickness 2.
VolumeAverage cell_average(const std::string& weight, Branch branch = Branch::by_weight) {
  AverageSetup setup;
  setup.weight = weight;
  setup.options.branch = branch;
  setup.fields = {"all"};
  setup.field_options = {1, 0, 0};
  return {pair_at_a_wall(),
          std::make_unique<const GridVolumes>(std::vector<double>{0.2, 1}, std::vector<double>{0, 0.5}, 2),
          setup};
}

// w = part(x) part(y) for discs and the wall's contact point; the branches run along x from the centres: to
// the contact points 0.4 -> 0.85, 1.3 -> 0.85, 0.4 -> 0, or with l = a_p n to 0.9, 0.8, -0.1. Line integrals
// by 5 points: 1e-8.
TEST(KernelAverage, OfAPairAtAWallAsWorkedByHand) {
  const double p_y = part(0.3, 0, 0.5);
  const double w_1 = part(0.4, 0.2, 1) * p_y;
  const double w_2 = part(1.3, 0.2, 1) * p_y;
  const double area = 0.8 * 0.5;
  const auto average = cell_average("gauss:0.6");
  expect_measured(average.at("nu"), std::numbers::pi / 4 * (w_1 + w_2) / area, 1e-12);
  expect_measured(average.at("nu_2"), std::numbers::pi / 4 * w_1 / area, 1e-12);
  expect_measured(average.at("v_x"), 2 * w_1 / (w_1 + w_2), 1e-12);
  expect_measured(average.at("coordination"), (2 * w_1 + w_2) / (w_1 + w_2), 1e-12);
  expect_measured(average.at("F_xx"), std::numbers::pi / 4 * (2 * w_1 + w_2) / area, 1e-12);
  const double volume = 2 * area;
  const double at_wall = part(0, 0.2, 1) * p_y / volume;
  expect_measured(average.at("wall_force_density_x"), 2 * at_wall, 1e-12);
  expect_measured(average.at("wall_force_density_y"), 0.5 * at_wall, 1e-12);
  const auto line = [&](double a, double b) { return mean_part(a, b, 0.2, 1) * p_y * (b - a) / volume; };
  const double pair = line(0.4, 0.85) - line(1.3, 0.85);
  expect_measured(average.at("sigma_xx"), -3 * pair + 2 * line(0.4, 0), 1e-8);
  expect_measured(average.at("sigma_yx"), pair + 0.5 * line(0.4, 0), 1e-8);
  const auto to_radius = cell_average("gauss:0.6", Branch::radius);
  const double long_pair = line(0.4, 0.9) - line(1.3, 0.8);
  expect_measured(to_radius.at("sigma_xx"), -3 * long_pair + 2 * line(0.4, -0.1), 1e-8);
}

// With sliced and centre weights l = a_p n stays the default, and walls count as their discs do: disc 1 is in
// the cell by its centre, disc 2 is not.
TEST(KernelAverage, OtherWeightsKeepTheirBranchAndCountAtTheDisc) {
  const auto average = cell_average("centre");
  const double volume = 2 * 0.8 * 0.5;
  expect_measured(average.at("sigma_xx"), (-3 * 0.5 + 2 * -0.5) / volume, 1e-14);
  expect_measured(average.at("wall_force_density_x"), 2 / volume, 1e-14);
}

TEST(KernelAverage, FarFromEverythingAreNan) {
  const VolumeAverage average(
      pair_at_a_wall(),
      std::make_unique<const GridVolumes>(std::vector<double>{10, 11}, std::vector<double>{0, 1}, 1),
      {"gauss:0.6", {}, {"all"}, {1, 0, 0}});
  EXPECT_EQ(average.at("nu"), 0);
  EXPECT_EQ(average.at("sigma_xx"), 0);
  for (const std::string name : {"coordination", "v_x", "eps_xx", "E"})
    EXPECT_TRUE(std::isnan(average.at(name))) << name;
}

class KernelsOnTheShearCell : public testing::TestWithParam<std::string> {
 protected:
  RingSetup cell() const {
    RingSetup setup = shear_cell_rings();
    setup.weight = GetParam();
    return setup;
  }
};
INSTANTIATE_TEST_SUITE_P(Weights, KernelsOnTheShearCell,
                         testing::Values("gauss:0.004", "lucy:0.008", "wendland:0.008", "tophat:0.004"),
                         [](const auto& each) { return each.param.substr(0, each.param.find(':')); });

// Both are counted by the discs' own shares; n is a unit vector to 15 digits in the file.
TEST_P(KernelsOnTheShearCell, TraceOfFabricIsSolidFractionTimesCoordination) {
  const RingAverage average(read_shear_cell(), cell());
  for (int i = 0; i < shear_cell_ring_count; ++i)
    expect_measured(average.at("tr_F", i), average.at("nu", i) * average.at("coordination", i), 1e-12);
}

// The identity of docs/conventions.md with the fabric of the fit, pi h/V times its sum of w l (x) l, in place
// of F: algebra, as long as both sums of eps and the stress are weighted alike. With either branch.
TEST_P(KernelsOnTheShearCell, StiffnessIdentityHoldsWithTheFabricOfTheFit) {
  const RingSetup setup = cell();
  for (const Branch branch : {Branch::contact, Branch::radius}) {
    const Averager averager(std::make_unique<const RingVolumes>(setup.centre, setup.edges, setup.height),
                            make_weight(setup.weight),
                            make_fields({"stress", "elastic_strain", "stiffness"}, setup.field_options),
                            {setup.options.bulk_types, branch});
    const Frame frame = with_elastic_normal_forces(read_shear_cell());
    const Rows sums = averager.frame_sums(frame);
    const Rows values = averager.values(sums);
    const RingVolumes rings(setup.centre, setup.edges, setup.height);
    for (Eigen::Index i = 0; i < sums.rows(); ++i) {
      // Behind the four sums of stress and the four of Delta (x) l.
      const Eigen::Array4d dyad{sums(i, 8), sums(i, 9), sums(i, 9), sums(i, 10)};
      const Eigen::Array4d fabric = std::numbers::pi * setup.height / rings.measure()[i] * dyad;
      const TensorRow f{fabric.data(), 4};
      const TensorRow b = numbers_of(values, i, 0, 4);
      const double d_f = deviator(f) / trace(f);
      const double d_b = deviator(b) / -trace(b);
      const double angle = (principal_angle(b, true) - principal_angle(f, false)) * std::numbers::pi / 180;
      const double slope = (1 - d_f * d_f) / (1 - d_b * d_f * std::cos(2 * angle));
      expect_measured(2 * std::numbers::pi * values(i, 8) / (trace(f) * slope), 1, 1e-9);
    }
  }
}

// All of the packing and all reaches inside one ring: sums do not depend on the weight, but for branches.
TEST_P(KernelsOnTheShearCell, SumsOverAllOfThePackingAreThoseOfSlices) {
  RingSetup setup = cell();
  setup.edges = {0, 0.4};
  setup.options.branch = Branch::contact;
  const Frame frame = read_shear_cell();
  const RingAverage kernel(frame, setup);
  setup.weight = "sliced";
  const RingAverage sliced(frame, setup);
  for (const std::string name : {"nu", "nu_3", "coordination", "v_phi", "F_rr", "sigma_rr", "sigma_phir",
                                 "M_zr", "eps_rphi", "kappa_zphi", "E", "wall_force_density_r"}) {
    const double expected = sliced.at(name);
    expect_measured(kernel.at(name) / expected, 1, 1e-9, name);
  }
}

TEST(KernelWeights, WithoutAWidthAreBadInput) {
  for (const std::string name : {"gauss", "lucy:", "wendland:0", "tophat:-1", "gauss:wide", "gauss:1x",
                                 "gauss:inf", "gauss:nan", "box:1", ""})
    EXPECT_THROW(make_weight(name), Error) << name;
  EXPECT_NO_THROW(make_weight("gauss:4e-3"));
}

}  // namespace
}  // namespace mikromakro
