// SPDX-License-Identifier: GPL-2.0-or-later
// Cells that are hard on a simulation: far above freezing, without contact, a wheel a hundred times faster, a
// disc squeezed between the rings. Criteria are in docs/results/stability.md; ManySteps are labelled long.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine.h"
#include "fix.h"

namespace mikromakro::test {
namespace {

constexpr double r_i = 0.03, r_o = 0.06, a = 3.71e-3, height = 0.006;

std::string rings(double omega, const std::string& rest = "") {
  return fmt::format(
      "fix cell all couette/2d center 0 0 inner smooth 3 {} outer smooth 4 {} omega_inner {} height {} {}\n",
      r_i, rest.empty() ? r_o : 2 * r_o, omega, height, rest);
}

/// Discs between smooth rings, compacted within 0.4 s, under the law with a spring.
std::string packed(int discs) {
  return scene("model disc/linear tangential disc/cundall_strack", {}, 0.14, 4) +
         fmt::format("create_discs ring 0 0 {} {} seed 5 density 6.36 velocity 0.05 discs {} 1 {}\n", r_i,
                     2 * r_o, discs, a) +
         "fix integrate all nve/disc\ncompute contacts all contact/disc\ntimestep 4e-5\n" +
         rings(0, fmt::format("compact {} 0.4", r_o)) + "run 10000\nunfix cell\n";
}

double value(Engine& engine, int number) {
  return engine.fix("cell").compute_vector(number - 1);
}

double kinetic_energy(const std::map<int, Disc>& discs) {
  double sum = 0;
  for (const auto& [id, d] : discs)
    sum += (d.mass * (d.v_x * d.v_x + d.v_y * d.v_y) + d.inertia() * d.omega * d.omega) / 2;
  return sum;
}

/// All discs are there, between the rings (up to the overlap), and all numbers are numbers.
void expect_in_the_cell(const std::map<int, Disc>& discs, std::size_t count, double overlap) {
  ASSERT_EQ(discs.size(), count);
  for (const auto& [id, d] : discs) {
    const double r = std::hypot(d.x, d.y);
    EXPECT_TRUE(std::isfinite(d.v_x + d.v_y + d.omega + d.f_x + d.f_y + d.torque)) << id;
    EXPECT_GT(r, r_i + a - overlap) << id;
    EXPECT_LT(r, r_o - a + overlap) << id;
  }
}

int discs_at(double solid_fraction) {
  return static_cast<int>(solid_fraction * (r_o * r_o - r_i * r_i) / (a * a));
}

// nu = 0.95, above the densest plane packing but for overlaps: the discs are locked, the wheel can only slip.
// They cannot move faster than its rim, nor have more energy than all of them at that speed; the torque stays
// within Coulomb's bound.
TEST(FrozenCell, LetsTheWheelSlipOverManySteps) {
  const int count = discs_at(0.95);
  Engine engine;
  engine.run(packed(count) + rings(0.1));
  double most = 0, torque = 0, bound = 0;
  for (int part = 0; part < 10; ++part) {
    engine.run("run 100000\n");
    most = std::max(most, kinetic_energy(engine.discs()));
    torque = std::abs(value(engine, 1));
    bound = 0.44 * value(engine, 3) * 2 * std::numbers::pi * r_i * r_i * height;
    EXPECT_LE(torque, bound * (1 + 1e-9));
  }
  const double mass = 6.36 * std::numbers::pi * a * a,
               at_the_rim = 0.75 * count * mass * 0.1 * r_i * 0.1 * r_i;
  std::printf(
      "frozen: kinetic energy at most %.1e of all discs rolling at the rim's speed; torque %.3f of mu p\n",
      most / at_the_rim, torque / bound);
  EXPECT_LT(most, at_the_rim);
  expect_in_the_cell(engine.discs(), count, 0.5 * a);
  EXPECT_GT(value(engine, 3), 0);
}

// nu = 0.3: the wheel has swept its rim free and carries nothing, to the last bit. The outer ring carries the
// centrifugal force of discs that still move along it, sum m v^2/r, on average over many contact durations:
// discs swing on it, which leaves 5 % at most. The kinetic energy includes that of spins.
TEST(LooseCell, ComesToCarryNoStress) {
  const int count = discs_at(0.3);
  Engine engine;
  engine.run(packed(count) + rings(0.1) + "run 400000\n");
  constexpr int samples = 500;
  double pressing = 0, centrifugal = 0;
  for (int k = 0; k < samples; ++k) {
    EXPECT_EQ(value(engine, 1), 0);
    EXPECT_EQ(value(engine, 3), 0);
    pressing += value(engine, 4) * 2 * std::numbers::pi * r_o * height / samples;
    centrifugal += 2 * kinetic_energy(engine.discs()) / (r_o - a) / samples;
    engine.run("run 20 pre no post no\n");
  }
  std::printf("loose: force on the outer ring %.1e N, at most %.1e N centrifugal\n", pressing, centrifugal);
  EXPECT_LE(pressing, 1.05 * centrifugal);
  expect_in_the_cell(engine.discs(), count, 1e-4 * a);
}

// 10 1/s, the rim at 0.3 m/s. From the start of a run the work of the wheel is what the discs have gained and
// lost.
TEST(FastWheel, KeepsAccountOfItsEnergy) {
  const int count = discs_at(0.8);
  Engine engine;
  engine.run(packed(count) + rings(10) + "fix energy all energy/disc\nrun 0\n");
  const auto energy = [&] { return engine.fix("energy").compute_scalar(); };
  const double start = energy();
  double work = 0, before = value(engine, 9);
  for (int k = 0; k < 25000; ++k) {
    engine.run("run 1 pre no post no\n");
    const double power = value(engine, 9);
    work += 4e-5 * 0.5 * (before + power);
    before = power;
  }
  std::printf("fast wheel: work %.3e J, account off by %.1e of it\n", work, (energy() - start) / work - 1);
  EXPECT_GT(work, 10 * start);
  EXPECT_NEAR((energy() - start) / work, 1, 0.01);  // as promised for other scenes
  expect_in_the_cell(engine.discs(), count, 0.5 * a);
}

// A disc wider than the gap, 1 % of its radius on either side, rolls like a ball in its bearing: its centre
// at half the rim's speed, its spin so that neither ring slips. Lever arms are r_i + c and r_o - c with c the
// distance to a wall.
TEST(SqueezedDisc, RollsBetweenTheRings) {
  const double radius = (r_o - r_i) / 2 * 1.01, middle = (r_i + r_o) / 2;
  Engine engine;
  engine.run(scene("model disc/linear tangential disc/cundall_strack tangential_damping on", {}, 0.14, 4) +
             disc(1, middle, 0, radius) +
             "fix integrate all nve/disc\ncompute contacts all contact/disc\ntimestep 4e-5\n" + rings(1) +
             "run 100000\n");
  const auto d = engine.discs().at(1);
  const double speed = std::hypot(d.v_x, d.v_y), r = std::hypot(d.x, d.y);
  std::printf("squeezed disc: speed off by %.1e, place by %.1e of the gap\n", speed / (r_i / 2) - 1,
              (r - middle) / (r_o - r_i));
  EXPECT_NEAR(speed, r_i / 2, 1e-3 * r_i / 2);  // m v^2/r over k_n shifts it by less
  EXPECT_NEAR(r, middle, 1e-3 * (r_o - r_i));
  EXPECT_NEAR(d.omega * (r_o - r_i) / 2, -r_i / 2, 1e-3 * r_i / 2);
  EXPECT_EQ(engine.contacts().size(), 2U);
}

}  // namespace
}  // namespace mikromakro::test
