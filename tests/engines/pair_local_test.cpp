// SPDX-License-Identifier: GPL-2.0-or-later
// The stock `compute pair/gran/local` with the disc laws. It evaluates the law again at the end of the step,
// without moving the spring: positions are those of the step's forces, velocities the final ones. So its
// forces equal the applied ones exactly where the law does not depend on velocities; the dashpots differ by
// gamma times the change of the velocity since the evaluation.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "compute.h"
#include "engine.h"
#include "engine/engine_access.h"
#include "modify.h"
#include "packing.h"
#include "pair_gran_disc.h"

namespace mikromakro::test {
namespace {

struct Row {
  double f_x, f_y, xi, slip_rate;
};
using Rows = std::map<std::pair<int, int>, Row>;

/// Rows of `compute local all pair/gran/local id force history`: the force acts on the smaller id.
Rows local_rows(Engine& engine) {
  auto* compute = engine.lammps().modify->find_compute_id("local");
  compute->compute_local();
  Rows rows;
  for (int k = 0; k < compute->size_local_rows; ++k) {
    const double* row = compute->array_local[k];
    const int id1 = static_cast<int>(row[0]), id2 = static_cast<int>(row[1]);
    const double sign = id1 < id2 ? 1 : -1;
    rows[{std::min(id1, id2), std::max(id1, id2)}] = {sign * row[3], sign * row[4],
                                                      compute->size_local_cols > 6 ? row[6] : 0,
                                                      compute->size_local_cols > 7 ? row[7] : 0};
  }
  return rows;
}

const std::string spring = "model disc/linear tangential disc/cundall_strack",
                  hertz_spring = "model disc/hertz tangential disc/cundall_strack damping off";

struct Comparison {
  double force = 0, xi = 0;  // largest differences, of the rms force and of the longest spring
};

Comparison compare(const std::string& law, const Material& material, const std::string& integrator) {
  Engine engine;
  engine.run(scene(law, material, packing_box, 2, "p p p", "0.002") + packing(20, 0.05));
  engine.run("compute contacts all contact/disc\ncompute local all pair/gran/local id force" +
             std::string(law.find("cundall_strack") != std::string::npos ? " history\n" : "\n"));
  engine.run(fmt::format("fix integrate all {}\ntimestep 4e-5\nrun 50\n", integrator));
  const auto applied = engine.contacts();
  const auto rows = local_rows(engine);
  EXPECT_EQ(rows.size(), applied.size());
  EXPECT_GT(rows.size(), 800U);
  Comparison largest;
  double squares = 0, longest = 1e-30;
  for (const auto& [ids, c] : applied) {
    const auto& row = rows.at(ids);
    largest.force = std::max(largest.force, std::hypot(row.f_x - c.f_x, row.f_y - c.f_y));
    largest.xi = std::max(largest.xi, std::abs(row.xi - c.xi));
    squares += (c.f_x * c.f_x + c.f_y * c.f_y) / static_cast<double>(applied.size());
    longest = std::max(longest, std::abs(c.xi));
  }
  return {largest.force / std::sqrt(squares), largest.xi / longest};
}

TEST(ComputePairGranLocal, EqualsTheAppliedForcesWhereTheLawHasNoDashpot) {
  for (const auto& law : {std::string("model disc/linear tangential off"), spring, hertz_spring}) {
    for (const auto* integrator : {"nve/disc", "nve/disc velocity half_step"}) {
      const auto difference =
          compare(law, {.k_n = law == hertz_spring ? 1e6 : 352.1, .gamma_n = 0}, integrator);
      EXPECT_LE(difference.force, 1e-12);  // rounding
      EXPECT_EQ(difference.xi, 0);         // the same number
    }
  }
}

TEST(ComputePairGranLocal, DiffersByTheDashpotsOfTheFinalVelocities) {
  const auto predicted = compare(spring, {}, "nve/disc"),
             half_step = compare(spring, {}, "nve/disc velocity half_step");
  std::printf(
      "pair/gran/local against applied forces: %.1e of the rms force, with half-step velocities %.1e\n",
      predicted.force, half_step.force);
  EXPECT_EQ(predicted.xi, 0);
  // gamma_n a dt / 2 with accelerations of the order of f/m: gamma_n dt / m12 = 5 % for half-step velocities;
  // the prediction leaves the change of the acceleration in a step, omega dt = 6 % of that.
  EXPECT_GT(half_step.force, 5 * predicted.force);
  EXPECT_LT(half_step.force, 0.5);
}

TEST(HertzLaw, IsWhatTheEnginesOtherStylesAskFor) {
  Engine engine;
  engine.run(
      scene("model disc/hertz tangential disc/cundall_strack limitForce on damping off", {.k_n = 1e6}));
  auto* law = dynamic_cast<styles::PairGranDisc*>(styles::active_disc_law(engine.lammps()));
  ASSERT_NE(law, nullptr);
  EXPECT_EQ(law->stressStrainExponent(), 1.5);
  EXPECT_TRUE(law->contact_match("normal", "disc/hertz"));
  EXPECT_FALSE(law->contact_match("normal", "disc/linear"));
}

}  // namespace
}  // namespace mikromakro::test
