// SPDX-License-Identifier: GPL-2.0-or-later
// Other fixes and commands, which set velocities, radii, places and forces: in steps that they act in, the
// engine's arrays hold what the stock integrators leave there, and contacts, near pairs and the forces with
// which a run goes on follow. Values from formulas; on one rank and on two.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "engine.h"
#include "engine/engine_access.h"
#include "law/disc_law.h"

namespace mikromakro::test {
namespace {

const std::string linear = "model disc/linear tangential off damping off";

/// Two discs of radius 4 mm, by default without friction and at rest.
std::string pair_of_discs(double distance, const std::string& law = linear, double skin = 0.001) {
  return scene(law, {}, 0.1, 1, "f f p", std::to_string(skin)) + disc(1, 0, 0, 0.004) +
         disc(2, distance, 0, 0.004) + "compute contacts all contact/disc\ntimestep 2e-5\n";
}

const std::string integration = "fix integrate all nve/disc\n";

/// LAMMPS wants to know beforehand that radii will change.
std::string with_growing_discs(std::string script) {
  const std::string usual = "atom_style granular\n";
  if (std::string(styles::engine_family) == "LAMMPS")
    script.replace(script.find(usual), usual.size(), "atom_style sphere 1\n");
  return script;
}

/// Whoever sets velocities within a step sets those of the half step, as with the stock integrators. A wall
/// at 0.095 turns the disc that reaches it.
TEST(Outside, SetsVelocitiesWithinAStep) {
  if (std::string(styles::engine_family) != "LAMMPS") GTEST_SKIP() << "the engine has no fix wall/reflect";
  Engine engine;
  engine.run(scene(linear, {}, 0.1, 1) + disc(1, 0.09, 0, 0.004) + motion(1, 0.5, 0.1) + "timestep 1e-5\n" +
             integration + "fix wall all wall/reflect xhi 0.095\nrun 2000\n");
  // 0.005 m to the wall, 0.005 m back.
  const auto disc = engine.discs().at(1);
  EXPECT_EQ(disc.v_x, -0.5);
  EXPECT_EQ(disc.v_y, 0.1);
  EXPECT_NEAR(disc.x, 0.09, 1e-14);
}

/// A force that is added at the end of the step and depends on the velocity reads the one of the half step:
/// v_(n+1/2) = v_(n-1/2) - dt g/m v_(n-1/2), as with the stock integrators.
TEST(Outside, ReadsVelocitiesOfTheHalfStep) {
  constexpr double dt = 1e-4, g = 0.2;
  Engine engine;
  engine.run(scene(linear, {}, 0.1, 1) + disc(1, 0, 0, 0.004) + motion(1, 0.1, 0) + "timestep 1e-4\n" +
             integration + "fix drag all viscous 0.2\nrun 10\n");
  const double m = engine.discs().at(1).mass;
  double half_step = 0.1 * (1 - dt * g / 2 / m), force = 0;
  for (int k = 0; k < 10; ++k) {
    if (k > 0) half_step += dt * force / m;
    force = -g * half_step;
  }
  EXPECT_NEAR(engine.discs().at(1).v_x, half_step + dt * force / 2 / m, 1e-15);
}

/// Discs grow by 1e-7 m in a step: in their own, 20 um apart, they touch from step 101 on, in step 1000 they
/// are pressed by as much as the stock law gives, 5.4 um, and fly apart.
TEST(Outside, MakesDiscsGrow) {
  for (const char* law :
       {"model disc/linear tangential off", "model disc/linear tangential disc/cundall_strack"}) {
    Engine engine;
    engine.run(with_growing_discs(pair_of_discs(0.00802, law)) + integration +
               "variable d equal 0.008+step*2e-7\nfix grow all adapt 1 atom diameter v_d\nrun 100\n");
    EXPECT_EQ(engine.contacts().size(), 0);
    // Nothing has moved yet: in step 102 the overlap is that of the radii, 2 (0.004 + 1.02e-5) - 0.00802.
    engine.run("run 2\n");
    ASSERT_EQ(engine.contacts().size(), 1);
    EXPECT_NEAR(engine.contacts().at({1, 2}).overlap, 4e-7, 1e-9);
    EXPECT_NEAR(engine.contacts().at({1, 2}).f_x, -352.1 * 4e-7, 0.1 * 352.1 * 4e-7);
    engine.run("run 898\n");
    EXPECT_LT(engine.discs().at(1).v_x, -0.004);
    EXPECT_GT(engine.discs().at(2).v_x, 0.004);
  }
}

/// Beyond what the lists of the start look for: 0.41 mm between the discs, a skin of 1 mm, both grow by 0.3
/// mm.
TEST(Outside, MakesDiscsGrowAsFarAsTheSkinReaches) {
  Engine engine;
  engine.run(with_growing_discs(pair_of_discs(0.00841)) + integration +
             "variable d equal 0.008+step*2e-6\nfix grow all adapt 1 atom diameter v_d\nrun 300\n");
  EXPECT_LT(engine.discs().at(1).v_x, -0.01);
}

/// A disc that is taken away has no force on its neighbour any more: v stays what it was.
TEST(BetweenRuns, NeighboursAreDeleted) {
  Engine engine;
  engine.run(pair_of_discs(0.0075) + integration + "run 2\n");
  const double v = engine.discs().at(2).v_x;
  engine.run("group one id 1\ndelete_atoms group one compress no\nrun 3\n");
  EXPECT_GT(v, 0);
  EXPECT_EQ(engine.discs().at(2).v_x, v);
}

/// k_n is halved: the first half-kick is already that of the new force.
TEST(BetweenRuns, ConstantsChange) {
  Engine engine;
  engine.run(pair_of_discs(0.0075) + integration + "run 2\n");
  const auto before = engine.discs().at(2);
  engine.run("unfix kn\nfix kn all property/global kn peratomtypepair 1 176.05\npair_coeff * *\nrun 1\n");
  const auto after = engine.discs().at(2);
  // Forces of both instants with the new constant.
  const double kick = 2e-5 / 2 / after.mass, f = before.f_x / 2;
  EXPECT_NEAR(after.v_x, before.v_x + kick * (f + after.f_x), 1e-12 * after.v_x);
}

/// A force that acts no more does not act in the first half-kick either.
TEST(BetweenRuns, ForcesAreTakenAway) {
  Engine engine;
  engine.run(scene(linear, {}, 0.1, 1) + disc(1, 0, 0, 0.004) + "timestep 1e-4\n" + integration +
             "fix fall all gravity 9.81 vector 0 -1 0\nrun 10\n");
  const double v = engine.discs().at(1).v_y;
  EXPECT_NEAR(v, -9.81e-3, 1e-15);
  engine.run("unfix fall\nrun 10\n");
  EXPECT_EQ(engine.discs().at(1).v_y, v);
}

/// And one that begins to act does so from the first half-kick on.
TEST(BetweenRuns, ForcesAreAdded) {
  Engine engine;
  engine.run(scene(linear, {}, 0.1, 1) + disc(1, 0, 0, 0.004) + "timestep 1e-4\n" + integration +
             "run 10\nfix fall all gravity 9.81 vector 0 -1 0\nrun 10\n");
  EXPECT_NEAR(engine.discs().at(1).v_y, -9.81e-3, 1e-15);
}

/// Discs that are displaced, turned into larger ones, or made faster between two runs go on from there.
TEST(BetweenRuns, DiscsAreDisplaced) {
  Engine engine;
  engine.run(pair_of_discs(0.0079) + integration +
             "run 5\ngroup second id 2\ndisplace_atoms second move 0.001 0 0 units box\n");
  const auto before = engine.discs().at(2);
  engine.run("run 5\n");
  EXPECT_EQ(engine.discs().at(2).v_x, before.v_x);
  engine.run("set group all diameter 0.01\nrun 1\n");
  const auto after = engine.discs().at(2);
  EXPECT_GT(after.f_x, 0);
  EXPECT_GT(after.v_x, before.v_x);
  engine.run("velocity second set 0 0 0 units box\nrun 1\n");
  EXPECT_LT(engine.discs().at(2).v_x, after.v_x);
}

bool steps_may_be_open(Engine& engine) {
  return styles::active_disc_law(engine.lammps())->steps_may_be_open();
}

TEST(FusedSteps, CanBeSwitchedOff) {
  Engine engine;
  engine.run(pair_of_discs(0.01) + "fix integrate all nve/disc fused off\nrun 1\n");
  EXPECT_FALSE(steps_may_be_open(engine));
  engine.run("unfix integrate\nfix integrate all nve/disc fused on velocity predicted\nrun 1\n");
  EXPECT_TRUE(steps_may_be_open(engine));
}

/// Whoever acts within a step closes it, whatever his name.
TEST(FusedSteps, AreClosedByWhoeverActsWithinThem) {
  Engine engine;
  engine.run(with_growing_discs(pair_of_discs(0.01)) + integration + "variable d equal 0.008\nrun 1\n");
  EXPECT_TRUE(steps_may_be_open(engine));
  for (const char* fix : {"adapt 1 atom diameter v_d", "addforce 0 0 0", "viscous 0.0",
                          "setforce NULL NULL 0.0", "enforce2d"}) {
    engine.run(std::string("fix other all ") + fix + "\nrun 0\n");
    EXPECT_FALSE(steps_may_be_open(engine)) << fix;
    engine.run("unfix other\nrun 0\n");
    EXPECT_TRUE(steps_may_be_open(engine)) << fix;
  }
}

}  // namespace
}  // namespace mikromakro::test
