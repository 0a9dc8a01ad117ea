// SPDX-License-Identifier: GPL-2.0-or-later
// fix wall/disc: beside the walls of the box and of the ring cell, which are the same walls, and against
// closed forms; on one rank and on more.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <vector>

#include "engine.h"
#include "fix.h"

namespace mikromakro::test {
namespace {

constexpr double a = 3.71e-3, density = 6.36, k_n = 352.1, g = 9.81;
const double mass = density * M_PI * a * a;
const char* const springs = "disc/cundall_strack tangential_damping on";

std::string box(const std::string& tangential, const Material& material = {},
                const std::string& boundary = "f f p") {
  return scene("model disc/linear tangential " + tangential, material, 0.2, 4, boundary);
}
const std::string integrate =
    "timestep 4e-5\nfix integrate all nve/disc\ncompute contacts all contact/disc\n";
const std::string weight = "fix weight all gravity 9.81 vector 0 -1 0\n";

void expect_same(const Engine& one, const std::map<int, Disc>& discs,
                 const std::map<std::pair<int, int>, Contact>& contacts) {
  ASSERT_EQ(one.discs().size(), discs.size());
  for (const auto& [id, disc] : one.discs()) {
    const Disc& other = discs.at(id);
    EXPECT_EQ(disc.x, other.x) << id;
    EXPECT_EQ(disc.y, other.y) << id;
    EXPECT_EQ(disc.omega, other.omega) << id;
    EXPECT_EQ(disc.f_y, other.f_y) << id;
  }
  EXPECT_EQ(one.contacts().size(), contacts.size());
}

// m g = k_n overlap; the floor has the weight, with the lever arm of the disc's place about the origin.
TEST(WallDisc, FloorCarriesTheWeightOfADisc) {
  Engine engine;
  engine.run(box("off") + disc(1, 0.05, a - 0.1, a, density) + weight + integrate +
             "fix floor all wall/disc type 2 plane 0 2 -0.1\nrun 10000\n");
  const auto contact = engine.contacts().at({-11, 1});
  // m/gamma_n = 1.4 ms: nothing is left of the oscillation after 0.4 s; places of 0.1 m are rounded
  // to 1.4e-17.
  EXPECT_NEAR(contact.overlap, mass * g / k_n, 1e-16);
  EXPECT_NEAR(contact.x1, 0.05, 1e-16);
  EXPECT_NEAR(contact.y1, -0.1, 1e-16);
  EXPECT_NEAR(contact.n_y, 1, 1e-15);  // from the wall, whose id is smaller
  auto& floor = engine.fix("floor");
  EXPECT_NEAR(floor.compute_vector(0), 0, 1e-15);
  EXPECT_NEAR(floor.compute_vector(1), -mass * g, 1e-13);
  EXPECT_NEAR(floor.compute_vector(2), -0.05 * mass * g, 1e-14);
  EXPECT_EQ(floor.compute_vector(3), 0);  // a wall at rest does no work
  EXPECT_NEAR(floor.compute_vector(4), mass * g, 1e-13);
}

const std::string discs_in_box =
    "create_discs box -0.1 0.1 -0.1 0.1 seed 7 density 6.36 velocity 0.5 discs 80 1 0.004 discs 20 2 0.006\n";
const std::string four_planes =
    "fix left all wall/disc type 3 plane 1 0 -0.1 move vx 0.1\nfix right all wall/disc type 3 plane -1 0 "
    "-0.1\n"
    "fix bottom all wall/disc type 4 plane 0 1 -0.1 move vy -0.05\nfix top all wall/disc plane 0 -1 -0.1 "
    "type 4\n";

std::string bouncing(const std::string& walls) {
  return box(springs) + discs_in_box + weight + integrate + walls;
}

// The same walls as those of the box, one by one, in the same order: the same bits.
TEST(WallDisc, FourPlanesAreTheBoxOfBiaxial) {
  Engine engine;
  engine.run(
      bouncing("fix box all biaxial/2d type 3 left -0.1 strain rate 0.1 right 0.1 fixed bottom -0.1 strain "
               "rate -0.05 type 4 top 0.1 fixed type 4\n") +
      "run 1500\n");
  const auto discs = engine.discs();
  const auto contacts = engine.contacts();
  const double work = engine.fix("box").compute_scalar();
  ASSERT_GT(contacts.size(), 4U);
  Engine other;
  other.run(bouncing(four_planes) + "run 1500\n");
  expect_same(other, discs, contacts);
  double sum = 0;
  for (const auto* id : {"left", "right", "bottom", "top"}) sum += other.fix(id).compute_scalar();
  ASSERT_GT(std::abs(work), 1e-6);
  EXPECT_NEAR(sum, work, 1e-12 * std::abs(work));  // rounding of 1500 sums
}

// Rows that wait (open state), as where somebody looks at each step or acts in each.
TEST(WallDisc, IsTheSameWhereSomebodyLooksAtEachStep) {
  std::map<int, Disc> discs;
  std::map<std::pair<int, int>, Contact> contacts;
  for (const auto* lines : {"", "thermo 1\n", "fix act all addforce 0 0 0\n"}) {
    Engine engine;
    engine.run(bouncing(four_planes) + lines + "run 600\n");
    if (discs.empty()) discs = engine.discs(), contacts = engine.contacts();
    expect_same(engine, discs, contacts);
  }
}

// Circles are the smooth rings of the cell.
TEST(WallDisc, CirclesAreTheRingsOfCouette) {
  const std::string cell =
      box(springs) +
      "create_discs ring 0.01 0.02 0.04 0.1 seed 3 density 6.36 velocity 0.5 discs 60 1 0.004\n" + integrate;
  Engine engine;
  engine.run(cell +
             "fix cell all couette/2d center 0.01 0.02 inner smooth 3 0.04 outer smooth 4 0.1 omega_inner 20 "
             "omega_outer -3\nrun 1500\n");
  const auto discs = engine.discs();
  const auto contacts = engine.contacts();
  const double torque = engine.fix("cell").compute_vector(0);
  Engine other;
  other.run(cell +
            "fix inner all wall/disc type 3 circle 0.01 0.02 0.04 outside rotate 20\n"
            "fix outer all wall/disc type 4 circle 0.01 0.02 0.1 inside rotate -3\nrun 1500\n");
  expect_same(other, discs, contacts);
  EXPECT_EQ(other.fix("inner").compute_vector(2), torque);
}

// An elastic plane that moves into a disc at rest gives it twice its velocity, and the energy m (2V)^2/2.
TEST(WallDisc, MovingPlaneGivesTheEnergyThatItsWorkIs) {
  constexpr double speed = 0.1;
  std::vector<double> errors;
  for (const double dt : {4e-5, 1e-5}) {
    Engine engine;
    engine.run(box("off", {.gamma_n = 0}) + disc(1, 0, 0, a, density) + integrate +
               fmt::format("timestep {}\nfix push all wall/disc type 2 plane 1 0 {} move vx {}\nrun {}\n", dt,
                           -a - 1.03e-5, speed, std::lround(0.008 / dt)));
    ASSERT_TRUE(engine.contacts().empty());
    const Disc d = engine.discs().at(1);
    const double work = engine.fix("push").compute_vector(3);
    EXPECT_NEAR(d.v_x, 2 * speed, 1e-3 * speed);
    errors.push_back(std::abs(work / (mass * d.v_x * d.v_x / 2) - 1));
  }
  // The disc has the impulse sum of f dt, the wall the work V sum of f dt: what differs is V against the mean
  // velocity of the disc, which the elastic rebound gets right to the onset and release within a step.
  std::printf("work off by %.1e of the energy at t_c/69, %.1e at t_c/278\n", errors[0], errors[1]);
  EXPECT_LT(errors[0], 3e-4);
  EXPECT_LT(errors[1], 2e-5);
}

// A belt under a disc: a plane that moves along itself drags the disc with mu m g, until the disc's rim moves
// with it: v' = mu g, c omega' = 2 (c/a)^2 mu g with the lever arm c, so that v ends at V/(1 + 2 (c/a)^2).
TEST(WallDisc, BeltDragsADiscUntilItRolls) {
  constexpr double speed = 0.1;
  const double arm = a - mass * g / k_n;
  Engine engine;
  engine.run(box(springs) + disc(1, -0.1, arm - 0.1, a, density) + weight + integrate +
             fmt::format("fix belt all wall/disc type 2 plane 0 1 -0.1 move vx {}\nrun 2000\n", speed));
  const Disc d = engine.discs().at(1);
  EXPECT_NEAR(d.v_x + d.omega * arm, speed, 1e-9);
  EXPECT_NEAR(d.v_x, speed / (1 + 2 * arm * arm / (a * a)), 1e-8);
}

/// What the account of energy gains beyond the work of the walls within 0.12 s, over what there was.
double unaccounted_energy(double dt) {
  Engine engine;
  engine.run(box(springs) + discs_in_box + integrate + fmt::format("timestep {}\n", dt) + four_planes +
             "fix energy all energy/disc\nrun 0\n");
  const double before = engine.fix("energy").compute_scalar();
  engine.run(fmt::format("run {}\n", std::lround(0.12 / dt)));
  double work = 0;
  for (const auto* id : {"left", "right", "bottom", "top"}) work += engine.fix(id).compute_scalar();
  EXPECT_GT(std::abs(work), 0.03 * before);
  return (engine.fix("energy").compute_scalar() - before - work) / before;
}

// Verlet and the trapezium: (omega dt)^2/12 = 3e-4 for an impact at t_c/53, of which a disc has several.
TEST(WallDisc, WorkBalancesTheAccountOfEnergy) {
  const double coarse = unaccounted_energy(4e-5), fine = unaccounted_energy(1e-5);
  std::printf("off by %.1e of the energy at t_c/53, %.1e at t_c/213\n", coarse, fine);
  EXPECT_LT(std::abs(coarse), 2e-3);
  EXPECT_LT(std::abs(fine), 1.5e-4);
}

TEST(WallDisc, IdsFollowTheOrderOfTheFixes) {
  Engine engine;
  engine.run(box("off") + disc(1, 0.05, a - 0.1 - 1e-5, a, density) + disc(2, 0.1 - a + 1e-5, 0, a, density) +
             integrate +
             "fix right all wall/disc type 2 plane -1 0 -0.1\nfix floor all wall/disc type 2 plane 0 1 "
             "-0.1\nrun 0\n");
  EXPECT_EQ(engine.contacts().count({-12, 1}), 1U);
  EXPECT_EQ(engine.contacts().count({-11, 2}), 1U);
  engine.run("unfix right\nrun 0\n");
  ASSERT_EQ(engine.contacts().size(), 1U);
  EXPECT_EQ(engine.contacts().count({-11, 1}), 1U);
}

// The normal of a disc at the very centre is not defined; no force may come of it.
TEST(WallDisc, LeavesADiscAtTheCentreOfACircleAlone) {
  Engine engine;
  engine.run(box(springs) + disc(1, 0, 0, a, density) + integrate +
             "fix drum all wall/disc type 2 circle 0 0 0.1 inside rotate 5\nrun 10\n");
  const Disc d = engine.discs().at(1);
  EXPECT_EQ(d.x, 0);
  EXPECT_EQ(d.f_x, 0);
}

// The floor of a box that is periodic along it: a disc that rolls over the border goes on.
TEST(WallDisc, FloorGoesOnOverAPeriodicBorder) {
  Engine engine;
  engine.run(box(springs, {}, "p f p") + disc(1, 0.199, a - mass * g / k_n - 0.1, a, density) +
             motion(1, 0.1, 0, -0.1 / (a - mass * g / k_n)) + weight + integrate +
             "fix floor all wall/disc type 2 plane 0 1 -0.1\nrun 1000\n");
  const Disc d = engine.discs().at(1);
  EXPECT_NEAR(d.v_x, 0.1, 1e-9);
  EXPECT_NEAR(d.x, 0.199 + 0.1 * 0.04 - 0.4, 1e-9);
  EXPECT_NEAR(d.y, a - mass * g / k_n - 0.1, 1e-9);
}

// Springs, places, power and work go on, to the bit; another velocity begins where the wall stands.
class WallDiscRestart : public testing::Test {
 protected:
  // The first rank names the file.
  WallDiscRestart() {
    int number = getpid();
    MPI_Bcast(&number, 1, MPI_INT, 0, MPI_COMM_WORLD);
    file_ = testing::TempDir() + "wall_disc" + std::to_string(number) + ".restart";
  }
  ~WallDiscRestart() override { std::filesystem::remove(file_); }

  std::string restart(const std::string& walls) const {
    return "clear\nnewton off\ncommunicate single vel yes\natom_modify map array\nread_restart " + file_ +
           "\nneighbor 0.001 bin\nneigh_modify delay 0\n" + constants({}, 4) +
           "pair_style gran model disc/linear tangential " + springs + "\npair_coeff * *\n" + integrate +
           walls;
  }

  std::string file_;
};

TEST_F(WallDiscRestart, GoesOnAsIfItHadNotBeenInterrupted) {
  Engine engine;
  engine.run(bouncing(four_planes) + "run 600\nwrite_restart " + file_ + "\nrun 600\n");
  const auto discs = engine.discs();
  const auto contacts = engine.contacts();
  const double work = engine.fix("left").compute_scalar();
  engine.run(restart(weight + four_planes) + "run 600\n");
  expect_same(engine, discs, contacts);
  EXPECT_EQ(engine.fix("left").compute_scalar(), work);
}

// The wall stood at -0.1 + 0.1 x 600 x 4e-5 = -0.0976, where it begins to touch a disc.
TEST_F(WallDiscRestart, WithAnotherVelocityBeginsWhereTheWallStood) {
  Engine engine;
  engine.run(box(springs) + disc(1, -0.0976 + a - 1e-5, 0, a, density) + integrate +
             "fix push all wall/disc type 3 plane 1 0 -0.1 move vx 0.1\nrun 600\nwrite_restart " + file_ +
             "\n");
  engine.run(restart("fix push all wall/disc type 3 plane 1 0 -0.1\n") + "run 0\n");
  EXPECT_NEAR(engine.contacts().at({-11, 1}).x1, -0.0976, 1e-15);
  engine.run(restart("fix push all wall/disc type 3 plane 1 0 -0.0977\n") + "run 0\n");
  EXPECT_TRUE(engine.contacts().empty());
}

}  // namespace
}  // namespace mikromakro::test
