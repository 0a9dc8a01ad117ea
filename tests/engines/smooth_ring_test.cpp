// SPDX-License-Identifier: GPL-2.0-or-later
// fix couette/2d with smooth rings in the engine; on one rank and on more.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "engine.h"
#include "fix.h"
#include "modify.h"

namespace mikromakro::test {
namespace {

// Walls along circles of radius 0.1 and 0.3 about (0.05, -0.02); a disc of radius 0.02.
constexpr double c_x = 0.05, c_y = -0.02, a = 0.02, inner = 0.1, outer = 0.3;
const char* const laws[] = {"off", "disc/viscous", "disc/cundall_strack",
                            "disc/cundall_strack tangential_damping on limitForce on"};

std::string box(const std::string& tangential) {
  return scene("model disc/linear tangential " + tangential, {}, 0.5, 4);
}
std::string rings(const std::string& rest) {
  return fmt::format(
      "fix integrate all nve/disc\ntimestep 4e-5\ncompute contacts all contact/disc\n"
      "fix cell all couette/2d center {} {} inner smooth 3 {} outer smooth 4 {} {}\n",
      c_x, c_y, inner, outer, rest);
}
/// A disc at the distance r from the centre of the rings, in the direction phi.
std::string disc_at(int id, double r, double phi, double radius = a) {
  return disc(id, c_x + r * std::cos(phi), c_y + r * std::sin(phi), radius);
}

double cell_value(Engine& engine, int number) {
  auto* modify = engine.lammps().modify;
  return modify->fix[modify->find_fix("cell")]->compute_vector(number - 1);
}

double fix_value(Engine& engine, const char* id, int number) {
  auto* modify = engine.lammps().modify;
  return modify->fix[modify->find_fix(id)]->compute_vector(number - 1);
}

// Overlap 1e-4, spin s = 2 1/s: the wheel gets f_n = k_n 1e-4 inwards, and gamma_t s (a - 1e-4) tangentially,
// below the cap, at its own radius.
TEST(SmoothRing, LoadsOfOneDiscPressedOnTheWheel) {
  Engine engine;
  engine.run(box("disc/viscous") + disc_at(1, inner + a - 1e-4, 0) + motion(1, 0, 0, 2) +
             rings("omega_inner 0 height 0.006") + "run 0\n");
  const double f_t = -0.15 * 2 * (a - 1e-4);
  // Positions are rounded to 1e-17 m, the overlap of 1e-4 m to 1e-13 of itself.
  EXPECT_NEAR(cell_value(engine, 1), inner * f_t, 1e-14);
  EXPECT_NEAR(cell_value(engine, 3), 352.1 * 1e-4 / (2 * std::numbers::pi * inner * 0.006), 1e-9);
  EXPECT_EQ(cell_value(engine, 2), 0.0);
  EXPECT_EQ(cell_value(engine, 4), 0.0);
  // On the disc: away from the wheel, against its rim, whose lever arm is a - overlap.
  const auto d = engine.discs().at(1);
  EXPECT_NEAR(d.f_x, 352.1 * 1e-4, 1e-13);
  EXPECT_NEAR(d.f_y, -f_t, 1e-14);
  EXPECT_NEAR(d.torque, (a - 1e-4) * f_t, 1e-15);
}

// The ring turns with omega = 3: its rim slides along the resting disc with 3 * 0.3 m/s, above the cap
// mu k_n 1e-4.
TEST(SmoothRing, LoadsOfTheOuterRingThatTurns) {
  Engine engine;
  engine.run(box("disc/viscous") + disc_at(1, outer - a + 1e-4, 0.5) + rings("omega_inner 0 omega_outer 3") +
             "run 0\n");
  EXPECT_NEAR(cell_value(engine, 4), 352.1 * 1e-4 / (2 * std::numbers::pi * outer), 1e-12);
  EXPECT_NEAR(cell_value(engine, 2), -outer * 0.15 * 0.9 * (0.44 * 352.1 * 1e-4 / (0.15 * 0.9)), 1e-12);
  EXPECT_EQ(cell_value(engine, 1), 0.0);
}

TEST(SmoothRing, ContactsAreRowsWithTheIdsOfTheRings) {
  Engine engine;
  engine.run(box("disc/cundall_strack") + disc_at(1, inner + a - 1e-4, 1) + disc_at(2, outer - a + 2e-4, 2) +
             disc_at(3, 0.2, 0) + rings("omega_inner 0") + "run 0\n");
  const auto contacts = engine.contacts();
  ASSERT_EQ(contacts.size(), 2U);
  // Rows are turned so that the smaller id, the wall's, comes first: the normal points into the cell.
  const auto &at_wheel = contacts.at({0, 1}), &at_ring = contacts.at({-5, 2});
  EXPECT_NEAR(at_wheel.n_x, std::cos(1), 1e-15);
  EXPECT_NEAR(at_wheel.n_y, std::sin(1), 1e-15);
  EXPECT_NEAR(at_wheel.x1, c_x + inner * std::cos(1), 1e-16);
  EXPECT_NEAR(at_wheel.y1, c_y + inner * std::sin(1), 1e-16);
  EXPECT_NEAR(at_wheel.overlap, 1e-4, 1e-16);
  EXPECT_NEAR(at_wheel.f_n, 352.1 * 1e-4, 1e-13);
  EXPECT_NEAR(at_wheel.f_x, -352.1 * 1e-4 * std::cos(1), 1e-13);  // on the wheel
  EXPECT_NEAR(at_ring.n_x, -std::cos(2), 1e-15);
  EXPECT_NEAR(at_ring.x1, c_x + outer * std::cos(2), 1e-16);
  EXPECT_NEAR(at_ring.overlap, 2e-4, 1e-16);
}

/// m r x v + I omega about the centre of the rings.
double angular_momentum(const Disc& d) {
  return d.mass * ((d.x - c_x) * d.v_y - (d.y - c_y) * d.v_x) + d.inertia() * d.omega;
}

// Torques on the rings, added over the steps, are what the disc has lost: velocity Verlet keeps this to
// rounding where first and last step are free of contacts. The disc hits the outer ring, then the wheel, then
// the ring.
class AngularMomentum : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(OfEachLaw, AngularMomentum, testing::ValuesIn(laws),
                         [](const auto& info) { return "law_" + std::to_string(info.index); });

TEST_P(AngularMomentum, OfTheDiscGoesToTheRings) {
  constexpr int steps = 14000;
  Engine engine;
  engine.run(box(GetParam()) + disc_at(1, outer - a - 1e-3, 0) + motion(1, 1.5, 0.5, 20) +
             rings("omega_inner 3 omega_outer -1") +
             fmt::format("fix torques all ave/time 1 {0} {0} f_cell[1] f_cell[2]\n", steps));
  const double before = angular_momentum(engine.discs().at(1));
  engine.run(fmt::format("run {}\n", steps));
  ASSERT_TRUE(engine.contacts().empty());
  const double on_wheel = fix_value(engine, "torques", 1) * steps * 4e-5,
               on_ring = fix_value(engine, "torques", 2) * steps * 4e-5;
  const double lost = before - angular_momentum(engine.discs().at(1));
  if (std::string(GetParam()) != "off") {
    EXPECT_GT(std::abs(on_wheel), 1e-3 * std::abs(before));
    EXPECT_GT(std::abs(on_ring), 1e-3 * std::abs(before));
  }
  EXPECT_NEAR(on_wheel + on_ring, lost, 1e-12 * std::abs(before));  // rounding of 14000 steps
}

/// A cell that is compacted and sheared by smooth rings.
std::string packed_cell(const std::string& tangential) {
  return box(tangential) +
         fmt::format(
             "create_discs ring {} {} {} {} seed 7 density 6.36 velocity 0.1 discs 150 1 0.012 discs 40 2 "
             "0.016\n",
             c_x, c_y, inner, outer) +
         rings("omega_inner 2 omega_outer -1 compact 0.23 0.3");
}

class SmoothRingRanks : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Laws, SmoothRingRanks, testing::Values(laws[1], laws[3]),
                         [](const auto& info) { return "law_" + std::to_string(info.index); });

struct Loads {
  std::map<std::pair<int, int>, Contact> contacts;
  double values[4];
};
Loads loads_on(MPI_Comm ranks, const std::string& tangential) {
  Engine engine(ranks);
  engine.run(packed_cell(tangential) + "run 7200\n");
  Loads loads{engine.contacts(), {}};
  for (int k = 0; k < 4; ++k) loads.values[k] = cell_value(engine, k + 1);
  return loads;
}

// Discs roll along the rings from rank to rank, with their springs. Rounding of the sums of forces grows in
// the collisions of 7200 steps, which are about 45 contact durations.
TEST_P(SmoothRingRanks, GiveTheSameForcesOnTheRings) {
  const auto one = loads_on(MPI_COMM_SELF, GetParam()), all = loads_on(MPI_COMM_WORLD, GetParam());
  ASSERT_EQ(one.contacts.size(), all.contacts.size());
  int at_walls = 0;
  for (const auto& [ids, contact] : one.contacts) {
    ASSERT_TRUE(all.contacts.contains(ids));
    at_walls += ids.first <= 0;
    EXPECT_NEAR(contact.xi, all.contacts.at(ids).xi, 1e-12);
  }
  EXPECT_GT(at_walls, 10);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(one.values[k], all.values[k], 1e-8 * std::abs(one.values[k])) << k;
}

class SmoothRingRestart : public testing::Test {
 protected:
  SmoothRingRestart() {
    int number = getpid();
    MPI_Bcast(&number, 1, MPI_INT, 0, MPI_COMM_WORLD);
    file_ = testing::TempDir() + "smooth_ring" + std::to_string(number) + ".restart";
  }
  ~SmoothRingRestart() override { std::filesystem::remove(file_); }
  std::string file_;
};

// Set-ups evaluate dashpots with other velocities than steps do, so the uninterrupted run has one there, too.
TEST_F(SmoothRingRestart, KeepsSpringsAndWalls) {
  const std::string law = laws[2];
  Engine engine;
  engine.run(packed_cell(law) + "run 7200\nwrite_restart " + file_ + "\nrun 300\n");
  const auto expected = engine.contacts();
  const double torque = cell_value(engine, 1), radius = cell_value(engine, 7);
  engine.run("clear\nnewton off\ncommunicate single vel yes\natom_modify map array\nread_restart " + file_ +
             "\nneighbor 0.001 bin\nneigh_modify delay 0\npair_style gran model disc/linear tangential " +
             law + "\npair_coeff * *\n" + constants({}, 4) +
             rings("omega_inner 2 omega_outer -1 compact 0.23 0.3") + "run 300\n");
  const auto restarted = engine.contacts();
  ASSERT_EQ(restarted.size(), expected.size());
  int with_spring = 0;
  for (const auto& [ids, contact] : expected) {
    const auto& again = restarted.at(ids);
    with_spring += ids.first <= 0 && contact.xi != 0;
    EXPECT_EQ(contact.xi, again.xi) << ids.first << " "
                                    << ids.second;  // the same arithmetic on the same numbers
    EXPECT_EQ(contact.f_n, again.f_n);
  }
  EXPECT_GT(with_spring, 10);
  EXPECT_EQ(cell_value(engine, 1), torque);
  EXPECT_EQ(cell_value(engine, 7), radius);
}

}  // namespace
}  // namespace mikromakro::test
