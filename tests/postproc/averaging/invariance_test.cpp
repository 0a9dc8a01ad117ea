// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <random>

#include "lattice_frame.h"
#include "measured_error.h"

namespace mikromakro {
namespace {

RingSetup rings_with(const std::string& weight) {
  RingSetup setup;
  setup.weight = weight;
  setup.edges = {0, 1.5, 3, 4.5, 6, 7.5};
  setup.options.bulk_types = {1};
  setup.fields = {"all"};
  setup.field_options = {50, 0.3, 0};
  return setup;
}

// For each kind of weight; the kernels reach over several rings.
class RingAverages : public testing::TestWithParam<std::string> {
 protected:
  const RingSetup rings = rings_with(GetParam());

  void expect_same(const Frame& one, const Frame& two, double tolerance) const;
};
INSTANTIATE_TEST_SUITE_P(Weights, RingAverages,
                         testing::Values("sliced", "centre", "gauss:0.8", "lucy:2", "wendland:2",
                                         "tophat:1.3"),
                         [](const auto& each) { return each.param.substr(0, each.param.find(':')); });

// A sheared lattice with random velocities, spins, springs and tangential forces: nothing in it is symmetric.
Frame disordered_frame() {
  LatticeSetup lattice{1, 1.96, 50, 4, Eigen::Matrix2d::Identity()};
  lattice.gradient << 1, 0.02, 0.005, 1.001;
  Frame frame = make_lattice(lattice);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (Particle& particle : frame.particles) {
    particle.velocity = {uniform(random), uniform(random)};
    particle.spin = uniform(random);
  }
  for (Contact& contact : frame.contacts) {
    contact.force += Eigen::Vector2d(uniform(random), uniform(random));
    contact.spring = 0.1 * uniform(random);
  }
  return frame;
}

// By how much columns magnify rounding: directions and G are quotients of deviators, 1e-2 of their tensors
// here; the exponential fit ends where the sum of squares no longer falls, at 1e-8 of its parameters.
double conditioning(const std::string& name) {
  if (name.ends_with("_fit")) return 10000;
  return name.find("angle") != name.npos || name == "G" ? 100 : 1;
}

void expect_same_tables(const Table& first, const Table& second, double tolerance) {
  for (Eigen::Index row = 0; row < first.rows.rows(); ++row) {
    for (Eigen::Index column = 0; column < first.rows.cols(); ++column) {
      const double value = first.rows(row, column);
      const std::string& name = first.columns[static_cast<std::size_t>(column)].name;
      if (std::isnan(value) && std::isnan(second.rows(row, column))) continue;
      const double size = std::fmax(1.0, std::abs(value)) * conditioning(name);
      expect_measured(value / size, second.rows(row, column) / size, tolerance, name);
    }
  }
}

void RingAverages::expect_same(const Frame& one, const Frame& two, double tolerance) const {
  expect_same_tables(RingAverage(one, rings).table(), RingAverage(two, rings).table(), tolerance);
}

// Relative to values above 1; the sums run over 10^2 terms: 1e-12.
TEST_P(RingAverages, DoNotChangeWhenEverythingIsTurned) {
  const Frame frame = disordered_frame();
  Frame turned = frame;
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(0.7).toRotationMatrix();
  for (Particle& particle : turned.particles) {
    particle.position = turn * particle.position;
    particle.velocity = turn * particle.velocity;
  }
  for (Contact& contact : turned.contacts) {
    contact.normal = turn * contact.normal;
    contact.force = turn * contact.force;
  }
  // Not the disc at the centre of the rings, where the polar basis has no direction: out of the average it
  // goes.
  Frame hollow = frame;
  for (Frame* each : {&hollow, &turned}) {
    for (Particle& particle : each->particles)
      if (particle.position.norm() < 1e-9) particle.type = 2;
  }
  expect_same(hollow, turned, 1e-12);
}

// Shifted by 100: positions lose two digits, which the areas of slices see.
TEST_P(RingAverages, DoNotChangeWhenEverythingIsShifted) {
  const Frame frame = disordered_frame();
  Frame shifted = frame;
  const Eigen::Vector2d shift{100, -40};
  for (Particle& particle : shifted.particles) particle.position += shift;
  RingSetup there = rings;
  there.centre = shift;
  expect_same_tables(RingAverage(frame, rings).table(), RingAverage(shifted, there).table(), 1e-11);
}

TEST_P(RingAverages, DoNotChangeWhenDiscsAreNumberedAndListedOtherwise) {
  const Frame frame = disordered_frame();
  Frame other = frame;
  const int count = static_cast<int>(frame.particles.size());
  std::reverse(other.particles.begin(), other.particles.end());
  std::rotate(other.contacts.begin(), other.contacts.begin() + 17, other.contacts.end());
  for (Particle& particle : other.particles) particle.id = 100000 - 3 * particle.id;
  for (Contact& contact : other.contacts) {
    contact.index1 = count - 1 - contact.index1;
    contact.index2 = count - 1 - contact.index2;
  }
  expect_same(frame, other, 1e-12);
}

// The order of the sums stays and a sign is exact: the same to the last bit.
TEST_P(RingAverages, DoNotChangeWhenTheDiscsOfEveryRowAreSwapped) {
  const Frame frame = disordered_frame();
  Frame swapped = frame;
  for (Contact& contact : swapped.contacts) {
    std::swap(contact.id1, contact.id2);
    std::swap(contact.index1, contact.index2);
    contact.normal = -contact.normal;
    contact.force = -contact.force;
  }
  expect_same(frame, swapped, 0);
}

}  // namespace
}  // namespace mikromakro
