// SPDX-License-Identifier: GPL-2.0-or-later
// While nobody looks between two steps, state waits in rows beside the engine's arrays: it must be the same
// state, to the last bit, as where somebody looks at every step, or acts within every step; on any number of
// ranks.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "engine.h"
#include "engine/engine_access.h"
#include "fix.h"
#include "law/disc_law.h"
#include "neighbor.h"

namespace mikromakro::test {
namespace {

/// Among the lines of a script: the fix that integrates fuses no steps.
const std::string fused_off = "# fused off\n";

struct Outcome {
  std::map<int, Disc> discs;
  std::map<std::pair<int, int>, Contact> contacts;
  int lists_built;
  double taken_by_bottom;
  std::vector<double> walls;  // all numbers of fix biaxial/2d or couette/2d
};

/// 1000 steps of a scene, in which neighbour lists are built several times: what `set_up` makes, and `lines`,
/// what else there is. `walls`: the fix that has so many numbers.
Outcome run(const std::string& tangential, const std::string& set_up, const std::string& lines,
            const char* walls, int numbers) {
  Engine engine;
  std::string script = scene("model disc/linear tangential " + tangential, {}, 0.12, 4, "f f p", "0.0006") +
                       "timestep 4e-5\ncompute contacts all contact/disc\n" + set_up + lines + "run 1000\n";
  const std::string integration = " nve/disc";
  if (lines.find(fused_off) != std::string::npos)
    script.insert(script.find(integration) + integration.size(), " fused off");
  engine.run(script);
  const bool bottom = lines.find("fix bottom ") != std::string::npos;
  Outcome found{engine.discs(),
                engine.contacts(),
                static_cast<int>(engine.lammps().neighbor->ncalls),
                bottom ? engine.fix("bottom").compute_scalar() : 0.0,
                {}};
  for (int k = 0; k < numbers; ++k) found.walls.push_back(engine.fix(walls).compute_vector(k));
  return found;
}

const std::string discs_in_ring =
    "create_discs ring 0 0 0.04 0.1 seed 7 density 6.36 velocity 0.3 discs 200 1 0.004 discs 30 2 0.005\n";

/// A ring cell that is pressed together and sheared fast; the outer ring comes to rest after 600 steps.
Outcome shear(const std::string& tangential, const std::string& lines, bool rings_come_first = false) {
  const std::string discs = "fix integrate free nve/disc\n",
                    rings =
                        "fix cell wall couette/2d center 0 0 inner rough inner 0.04 outer rough outer 0.1 "
                        "omega_inner 4 compact 0.08 0.024\n";
  return run(tangential,
             "create_ring 0 0 0.04 number 40 type 3 radius 0.0025 density 6.36\n"
             "create_ring 0 0 0.1 number 110 type 4 radius 0.0025 density 6.36\n" +
                 discs_in_ring +
                 "group inner type 3\ngroup outer type 4\ngroup wall type 3 4\ngroup free type 1 2\n"
                 "neigh_modify exclude group wall wall\n" +
                 (rings_come_first ? rings + discs : discs + rings),
             lines, "cell", 9);
}

/// Between smooth rings, of which the wheel turns and the outer one presses.
Outcome shear_smoothly(const std::string& tangential, const std::string& lines) {
  return run(tangential,
             discs_in_ring +
                 "fix integrate all nve/disc\nfix cell all couette/2d center 0 0 inner smooth 3 0.04 outer "
                 "smooth 4 0.1 omega_inner 20 compact 0.077 0.024\n",
             lines, "cell", 9);
}

/// In a box whose walls press and shear, all in their own way; some discs are glued to the plane.
Outcome press(const std::string& tangential, const std::string& lines) {
  return run(
      tangential,
      "create_discs box -0.08 0.08 -0.08 0.08 seed 7 density 6.36 velocity 0.5 discs 150 1 0.004 discs 30 2 "
      "0.005\n"
      "group glued id <= 20\nvelocity glued set 0 0 0\ngroup moving subtract all glued\n"
      "fix integrate moving nve/disc\n"
      "fix box all biaxial/2d type 3 left -0.08 strain rate 0.2 right 0.08 stress 30 mass 0.02 damping 0.5 "
      "bottom -0.08 fixed top 0.08 strain cosine 0.06 0.03\n",
      lines, "box", 27);
}

/// Two discs that nothing is near, and that fly towards each other.
Outcome meet(const std::string& tangential, const std::string& lines) {
  return run(tangential,
             disc(1, -0.011, 0, 0.004, 6.36, 1) + disc(2, 0.011, 0.002, 0.004, 6.36, 1) +
                 motion(1, 0.5, 0, 0) + motion(2, -0.5, 0, 0) + "fix integrate all nve/disc\n",
             lines, "", 0);
}

/// Three rings of discs at rest that overlap by a fifth of their diameter, and burst; most leave the box.
Outcome burst(const std::string& tangential, const std::string& lines) {
  return run(tangential,
             "create_ring 0 0 0.03 number 47 type 1 radius 0.0025 density 6.36\n"
             "create_ring 0 0 0.034 number 53 type 1 radius 0.0025 density 6.36\n"
             "create_ring 0 0 0.038 number 59 type 1 radius 0.0025 density 6.36\n"
             "fix integrate all nve/disc\ntimestep 1.2e-4\nthermo_modify lost ignore\n",
             lines, "", 0);
}

void expect_same_bits(const Outcome& a, const Outcome& b) {
  ASSERT_EQ(a.discs.size(), b.discs.size());
  for (const auto& [id, d] : a.discs) {
    const auto& e = b.discs.at(id);
    EXPECT_EQ(d.x, e.x) << id;
    EXPECT_EQ(d.y, e.y) << id;
    EXPECT_EQ(d.v_x, e.v_x) << id;
    EXPECT_EQ(d.v_y, e.v_y) << id;
    EXPECT_EQ(d.omega, e.omega) << id;
    EXPECT_EQ(d.f_x, e.f_x) << id;
    EXPECT_EQ(d.torque, e.torque) << id;
  }
  ASSERT_EQ(a.contacts.size(), b.contacts.size());
  for (const auto& [ids, c] : a.contacts) EXPECT_EQ(c.xi, b.contacts.at(ids).xi) << ids.first;
  EXPECT_EQ(a.walls, b.walls);
  EXPECT_EQ(a.taken_by_bottom, b.taken_by_bottom);
}

int contacts_with_walls(const Outcome& found) {
  return static_cast<int>(std::count_if(
      found.contacts.begin(), found.contacts.end(),
      [](const auto& contact) { return contact.first.first <= 0 || contact.first.second <= 0; }));
}

const std::string look_at_each_step = "compute energy all ke\nfix look all ave/time 1 1 1 c_energy\n";
const std::string look_at_each_third = "compute energy all ke\nfix look all ave/time 3 1 3 c_energy\n";
const std::string act_in_each_step = "fix nothing all addforce 0 0 0\n";

class OpenState : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(OfEachLaw, OpenState,
                         testing::Values("off", "disc/viscous", "disc/cundall_strack",
                                         "disc/cundall_strack tangential_damping on"),
                         [](const auto& info) { return "law_" + std::to_string(info.index); });

// No tolerance: the same arithmetic on the same numbers.
TEST_P(OpenState, IsTheStateThatIsLookedAt) {
  const auto open = shear(GetParam(), ""), closed = shear(GetParam(), look_at_each_step);
  EXPECT_GT(open.lists_built, 5);
  EXPECT_GT(open.contacts.size(), 200);
  EXPECT_EQ(open.lists_built, closed.lists_built);
  expect_same_bits(open, closed);
  expect_same_bits(open, shear(GetParam(), look_at_each_third));
}

TEST_P(OpenState, IsTheStateInWhichOthersAct) {
  expect_same_bits(shear(GetParam(), ""), shear(GetParam(), act_in_each_step));
}

TEST_P(OpenState, IsTheStateWithoutFusedSteps) {
  expect_same_bits(shear(GetParam(), ""), shear(GetParam(), fused_off));
  expect_same_bits(press(GetParam(), ""), press(GetParam(), fused_off));
  expect_same_bits(shear_smoothly(GetParam(), ""), shear_smoothly(GetParam(), fused_off));
}

TEST_P(OpenState, IsTheStateOfTwoThatMeetFromAfar) {
  const auto open = meet(GetParam(), "");
  EXPECT_LT(open.discs.at(1).v_x, 0);
  expect_same_bits(open, meet(GetParam(), look_at_each_step));
}

// Ranks that trust each other's answers for some steps learn in time that discs have become fast.
TEST_P(OpenState, IsTheStateOfABurst) {
  const auto open = burst(GetParam(), "");
  EXPECT_GT(open.lists_built, 10);
  expect_same_bits(open, burst(GetParam(), look_at_each_step));
}

// The file that is written on the way changes when neighbour lists are built, in both runs alike.
TEST_P(OpenState, IsWrittenToRestartFiles) {
  const std::string start = testing::TempDir() + "open_state_" + std::to_string(getpid()) + "_";
  const auto restarts = "restart 400 " + start + "*\n";
  expect_same_bits(shear(GetParam(), restarts), shear(GetParam(), restarts + look_at_each_step));
  for (const char* step : {"400", "800"}) std::remove((start + step).c_str());
}

/// Contacts act before wall discs are moved on, whoever comes first.
TEST_P(OpenState, DoesNotDependOnTheOrderOfFixes) {
  expect_same_bits(shear(GetParam(), ""), shear(GetParam(), "", true));
}

/// The bottom acts on what lies in the rows.
TEST_P(OpenState, IsTheStateOnABottomWithFriction) {
  const std::string bottom = "fix bottom free bottom/friction 0.05 9.81\n";
  const auto open = shear(GetParam(), bottom), closed = shear(GetParam(), bottom + look_at_each_step);
  expect_same_bits(open, closed);
  EXPECT_GT(open.taken_by_bottom, 0);
}

/// So do smooth walls, which move discs at rest, and look for those that have come near.
TEST_P(OpenState, IsTheStateBetweenSmoothRings) {
  const auto open = shear_smoothly(GetParam(), "");
  EXPECT_GT(contacts_with_walls(open), 20);
  EXPECT_GT(open.lists_built, 5);
  expect_same_bits(open, shear_smoothly(GetParam(), look_at_each_step));
  const std::string bottom = "fix bottom all bottom/friction 0.05 9.81\n";
  expect_same_bits(shear_smoothly(GetParam(), bottom),
                   shear_smoothly(GetParam(), bottom + look_at_each_third));
}

TEST_P(OpenState, IsTheStateInABox) {
  const auto open = press(GetParam(), "");
  EXPECT_GT(contacts_with_walls(open), 5);
  EXPECT_GT(open.lists_built, 5);
  expect_same_bits(open, press(GetParam(), look_at_each_step));
  expect_same_bits(open, press(GetParam(), act_in_each_step));
}

TEST(OpenStateOrNot, DependsOnWhoActsWithinAStep) {
  Engine engine;
  engine.run(scene("model disc/linear tangential off", {}, 0.1));
  engine.run(disc(1, 0, 0, 0.005) + disc(2, 0.009, 0, 0.005) + "fix integrate all nve/disc\nrun 0\n");
  const auto& law = *styles::active_disc_law(engine.lammps());
  EXPECT_TRUE(law.steps_may_be_open());
  engine.run("fix fall all gravity 9.81 vector 0 -1 0\nrun 1\n");
  EXPECT_FALSE(law.steps_may_be_open());
  engine.run("unfix fall\nfix bottom all bottom/friction 0.05 9.81\nrun 1\n");
  EXPECT_TRUE(law.steps_may_be_open());
  engine.run(
      "fix walls all biaxial/2d type 1 left -0.09 fixed right 0.09 fixed bottom -0.09 fixed top 0.09 fixed\n"
      "run 1\n");
  EXPECT_TRUE(law.steps_may_be_open());
  engine.run(
      "fix cell all couette/2d center 0.0045 -0.03 inner smooth 1 0.01 outer smooth 1 0.05 omega_inner 1\n"
      "run 1\n");
  EXPECT_TRUE(law.steps_may_be_open());
}

}  // namespace
}  // namespace mikromakro::test
