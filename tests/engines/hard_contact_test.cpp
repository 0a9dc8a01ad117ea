// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts and packings that are hard on a simulation; on one rank and on two. Criteria are in
// docs/results/stability.md; ManySteps are labelled long.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine.h"
#include "fix.h"

namespace mikromakro::test {
namespace {

constexpr double a = 3.71e-3, density = 6.36, g = 9.81;
const double mass = density * M_PI * a * a;
const std::string spring = "model disc/linear tangential disc/cundall_strack";

std::string walls(double size, const std::string& top = "fixed") {
  return fmt::format(
      "fix walls all biaxial/2d type 1 left -{0} fixed right {0} fixed bottom -{0} fixed top {0} {1}\n", size,
      top);
}

// Below the angle of friction a block neither creeps nor loses its spring. The stock `fix nve` leaves spins
// alone.
TEST(StaticFriction, HoldsABlockOnASlopeOverManySteps) {
  const double angle = 0.3, size = 0.05;
  Engine engine;
  engine.run(scene(spring + " tangential_damping on", {}, 0.1, 1) + disc(1, 0, a - size, a) +
             fmt::format("fix gravity all gravity {} vector {:.17g} {:.17g} 0\n", g, std::sin(angle),
                         -std::cos(angle)) +
             walls(size) +
             "fix integrate all nve\ncompute contacts all contact/disc\ntimestep 4e-5\nrun 10000\n");
  const auto before = engine.discs().at(1);
  engine.run("run 1000000\n");
  const auto after = engine.discs().at(1);
  const auto contact = engine.contacts().at({-3, 1});
  std::printf("slope, 1e6 steps: moved by %.1e m, f_t off by %.1e\n", after.x - before.x,
              contact.f_t / (-mass * g * std::sin(angle)) - 1);
  EXPECT_NEAR(after.x, before.x, 1e-16);  // an ulp of the position
  EXPECT_NEAR(contact.f_t / (-mass * g * std::sin(angle)), 1, 1e-10);
}

/// A pair that slides while both drift along x from `x` on; after 30 steps, 0.7 mm further.
Contact slid(double x) {
  Engine engine;
  engine.run(scene(spring, {.gamma_n = 0}, 0.05, 1, "p p p"));
  engine.run(disc(1, x, 0, a) + disc(2, x, 2 * a - 2e-4, a) + motion(1, 1, 0) + motion(2, 1.3, 0));
  engine.run("fix integrate all nve/disc\ncompute contacts all contact/disc\ntimestep 2e-5\nrun 30\n");
  return engine.contacts().at({1, 2});
}

// Across the border of two ranks (x = 0) and of the periodic box (x = 0.05) as in the middle of a rank.
// Overlaps of 2e-4 m between places of 0.05 m are rounded to 4e-14 of themselves, 30 times.
TEST(SlidingContact, CrossesTheBordersOfRanksAndOfThePeriodicBox) {
  const auto inside = slid(0.02);
  ASSERT_NEAR(std::abs(inside.f_t), 0.44 * inside.f_n, 1e-12);  // it slides
  for (const double x : {-0.0003, 0.0497}) {
    const auto across = slid(x);
    EXPECT_NEAR(across.xi / inside.xi, 1, 1e-11) << x;
    EXPECT_NEAR(across.f_n / inside.f_n, 1, 1e-11) << x;
    EXPECT_NEAR(across.f_t / inside.f_t, 1, 1e-11) << x;
  }
}

/// Discs of radii from `small` to `large` with random velocities in a closed box, all effects on; energy and
/// heat over the energy at the start.
double energy_kept(double small, double large, int count, double size, double dt, int steps,
                   const std::string& more = "") {
  Engine engine;
  engine.run(
      scene(spring + " tangential_damping on", {.gamma_n = 0.05, .gamma_t = 0.02}, 2 * size, 2) + more +
      fmt::format("create_discs box -{0} {0} -{0} {0} seed 11 density 6.36 velocity 0.5 discs {1} 1 {2} "
                  "discs {1} 2 {3}\n",
                  size, count, small, large) +
      walls(size) +
      fmt::format("fix integrate all nve/disc\ntimestep {:.17g}\nfix energy all energy/disc\nrun 0\n", dt));
  const auto energy = [&](int number) { return engine.fix("energy").compute_vector(number); };
  double start = 0;
  for (int k = 0; k < 5; ++k) start += energy(k);
  engine.run(fmt::format("run {}\n", steps));
  double sum = 0, heat = energy(3) + energy(4);
  for (int k = 0; k < 5; ++k) sum += energy(k);
  EXPECT_GT(heat, 0.3 * start);  // there is something to account for
  EXPECT_GE(heat, 0);
  return sum / start;
}

// t_c/50 of the smallest pair: t_c ~ radius. 1 % of the energy, as promised for the box.
TEST(SizeRatio, OfThreeAndOfTenKeepsTheAccountOfEnergy) {
  for (const double ratio : {3.0, 10.0}) {
    const double small = 4e-3 / ratio;
    const double kept = energy_kept(small, 4e-3, 40, 0.04, 4e-5 * small / a, 20000);
    std::printf("sizes 1:%g: energy and heat %.5f of the start\n", ratio, kept);
    EXPECT_NEAR(kept, 1, 0.01);
  }
}

TEST(StiffnessContrast, OfAHundredKeepsTheAccountOfEnergy) {
  const double kept =
      energy_kept(a, a, 25, 0.04, 4e-6, 100000,
                  "unfix kn\nfix kn all property/global kn peratomtypepair 2 352.1 3521 3521 35210\n");
  std::printf("stiffness 1:100: energy and heat %.5f of the start\n", kept);
  EXPECT_NEAR(kept, 1, 1e-3);  // of an impact at t_c/48 velocity Verlet misses (pi/48)^2/12 = 3.6e-4
}

// A square lattice of overlaps of 20 % of the radius bursts: no energy comes from nowhere, none is lost sight
// of.
TEST(LargeOverlaps, AtTheStartAreElasticEnergyAndNoMore) {
  Engine engine;
  std::string discs;
  int id = 0;
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column)
      discs += disc(++id, (column - 2.5) * 1.8 * a, (row - 2.5) * 1.8 * a + 1e-5 * column, a);
  }
  engine.run(scene(spring, {}, 0.12, 1) + discs + walls(0.06) +
             "fix integrate all nve/disc\ntimestep 4e-5\nfix energy all energy/disc\nrun 0\n");
  const auto energy = [&] { return engine.fix("energy").compute_scalar(); };
  const double start = energy(), elastic = engine.fix("energy").compute_vector(1);
  EXPECT_EQ(start, elastic);
  double off = 0;
  for (int part = 0; part < 40; ++part) {
    engine.run("run 250\n");
    off = std::max(off, std::abs(energy() / start - 1));
  }
  std::printf("20 %% overlaps: account of energy off by %.1e at most\n", off);
  EXPECT_LT(off, 0.01);
  EXPECT_EQ(engine.discs().size(), 36U);
}

}  // namespace
}  // namespace mikromakro::test
