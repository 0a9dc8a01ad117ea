// SPDX-License-Identifier: GPL-2.0-or-later
// fix biaxial/2d in the engine: how its walls move, what they feel, energy, restart; on one rank and on more.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "engine.h"
#include "fix.h"
#include "modify.h"

namespace mikromakro::test {
namespace {

constexpr double a = 5e-3, density = 6.36, k_n = 352.1;

double value(Engine& engine, int number, const char* id = "walls") {
  auto* modify = engine.lammps().modify;
  return modify->fix[modify->find_fix(id)]->compute_vector(number - 1);
}

std::string box(const std::string& tangential = "off", const Material& material = {}) {
  return scene("model disc/linear tangential " + tangential, material, 0.2);
}
std::string walls(const std::string& controls) {
  return "fix integrate all nve/disc\ntimestep 4e-5\ncompute contacts all contact/disc\n"
         "fix walls all biaxial/2d type 2 " +
         controls + "\n";
}

// z(T/3) = z_f + (z_0 - z_f)/2 (1 + cos(pi/3)) = 0.06 + 0.02 * 1.5 = 0.09 with T = 0.03 s; rate
// (0.06 - 0.1)/2 pi/T sin(pi/3). The right wall moves by 0.5 m/s * 0.01 s.
TEST(Biaxial, StrainControlledWallsFollowTheirCourse) {
  Engine engine;
  engine.run(
      box() + disc(1, 0, 0, a) +
      walls("left -0.1 fixed right 0.1 strain rate 0.5 bottom -0.1 fixed top 0.1 strain cosine 0.06 0.03") +
      "run 250\n");
  EXPECT_EQ(value(engine, 1), -0.1);
  EXPECT_DOUBLE_EQ(value(engine, 2), 0.105);
  EXPECT_DOUBLE_EQ(value(engine, 4), 0.09);
  EXPECT_EQ(value(engine, 6), 0.5);
  EXPECT_NEAR(value(engine, 8), -0.02 * M_PI / 0.03 * std::sin(M_PI / 3), 1e-14);
  EXPECT_DOUBLE_EQ(value(engine, 17), 0.205 / 0.2 - 1);
  EXPECT_DOUBLE_EQ(value(engine, 18), 0.19 / 0.2 - 1);
  EXPECT_DOUBLE_EQ(value(engine, 19), 0.205 * 0.19 / 0.04 - 1);
  engine.run("run 1000\n");
  EXPECT_EQ(value(engine, 4), 0.06);
  EXPECT_EQ(value(engine, 8), 0.0);
}

// The neighbour list is not built again, as no disc moves, while the wall comes from ten times the skin away.
TEST(Biaxial, AMovingWallFindsDiscsAtRest) {
  Engine engine;
  engine.run(box() + disc(1, 0, 0, a) +
             walls("left -0.1 fixed right 0.015 strain rate -1 bottom -0.1 fixed top 0.1 fixed") +
             "run 253\n");
  EXPECT_TRUE(engine.contacts().contains({-2, 1}));
  EXPECT_LT(engine.discs().at(1).v_x, 0);
}

// Without discs at the right wall its acceleration is -p L H/m = -50 * 0.2 * 0.01/0.2 = -0.5 m/s^2, and it is
// left to velocity Verlet, which is exact.
TEST(Biaxial, StressControlledWallFallsFreely) {
  Engine engine;
  engine.run(box() + disc(1, -0.05, 0, a) +
             walls("left -0.1 fixed right 0.1 stress 50 mass 0.2 damping 0 bottom -0.1 fixed top 0.1 fixed "
                   "height 0.01") +
             "run 1000\n");
  EXPECT_NEAR(value(engine, 2), 0.1 - 0.25 * 0.04 * 0.04, 1e-15);
  EXPECT_NEAR(value(engine, 6), -0.5 * 0.04, 1e-15);
}

// The force on a wall follows the length of its neighbours: with the top moving, p z(t).
TEST(Biaxial, TheLoadFollowsTheLengthOfTheWall) {
  Engine engine;
  engine.run(
      box() + disc(1, -0.05, 0, a) +
      walls(
          "left -0.1 fixed right 0.1 stress 5 mass 0.2 damping 0 bottom -0.1 fixed top 0.1 strain rate -1") +
      "run 1000\n");
  // m x'' = -p (0.2 - t): x = x_0 - p/m (0.1 t^2 - t^3/6). Verlet's velocity is exact for a linear force, its
  // position is ahead by dt^2/6 times the slope of the acceleration, p/m, per second.
  const double t = 0.04, dt = 4e-5;
  EXPECT_NEAR(value(engine, 6), -25 * (0.2 * t - t * t / 2), 1e-14);
  EXPECT_NEAR(value(engine, 2), 0.1 - 25 * (0.1 * t * t - t * t * t / 6 + dt * dt / 6 * t), 1e-14);
}

// A disc between both pairs of walls comes to rest where k_n overlap = p L on each of the four.
TEST(Biaxial, StressControlledWallsBalanceTheirPressure) {
  Engine engine;
  engine.run(box("off", {.gamma_n = 0.5}) + disc(1, -0.095, -0.095, a) +
             walls("left -0.1 fixed bottom -0.1 fixed right -0.09 stress 5 mass 0.01 damping 1 "
                   "top -0.09 stress 5 mass 0.01 damping 1") +
             "run 20000\n");
  const double length = value(engine, 2) + 0.1;
  EXPECT_NEAR(value(engine, 4) + 0.1, length, 1e-15);
  for (int wall = 0; wall < 4; ++wall) {
    EXPECT_NEAR(value(engine, 13 + wall), 5, 1e-9);
    EXPECT_NEAR(value(engine, 9 + wall), 5 * length, 1e-11);
    EXPECT_NEAR(value(engine, 5 + wall), 0, 1e-12);
  }
  EXPECT_NEAR(engine.contacts().at({-2, 1}).f_n, 5 * length, 1e-11);
  EXPECT_NEAR(2 * a - length, 2 * 5 * length / k_n, 1e-13);  // two overlaps
}

// fix_modify: from where and as fast as the walls are; reset: strains from here.
TEST(Biaxial, ControlsMayChangeBetweenRuns) {
  Engine engine;
  engine.run(box() + disc(1, 0, 0, a) +
             walls("left -0.1 fixed right 0.1 strain rate 0.5 bottom -0.1 fixed top 0.1 fixed") +
             "run 250\nfix_modify walls right strain rate -0.5 top strain cosine 0.08 0.01 reset\nrun 125\n");
  EXPECT_DOUBLE_EQ(value(engine, 2), 0.105 - 0.0025);
  EXPECT_DOUBLE_EQ(value(engine, 4), 0.09);
  EXPECT_NEAR(value(engine, 17), 0.2025 / 0.205 - 1, 1e-15);
  engine.run("fix_modify walls right stress 0 mass 1 damping 0 top fixed\nrun 250\n");
  EXPECT_NEAR(value(engine, 2), 0.1025 - 0.005, 1e-14);  // goes on with its velocity
  EXPECT_DOUBLE_EQ(value(engine, 4), 0.09);
}

// An elastic disc is squeezed slowly and let go: the work of the wall is in the overlaps and the motion.
double energy_error(const std::string& normal, double k, double dt) {
  Engine engine;
  engine.run(
      scene("model " + normal + " tangential off", {.k_n = k, .gamma_n = 0}, 0.2) + disc(1, -0.095, 0, a) +
      walls("left -0.1 fixed right -0.09 strain cosine -0.092 0.05 bottom -0.1 fixed top 0.1 fixed") +
      fmt::format("timestep {:.17g}\nfix energy all energy/disc\nrun {}\n", dt, std::lround(0.02 / dt)));
  const double work = value(engine, 21);
  EXPECT_GT(work, 1e-5);
  return (value(engine, 1, "energy") + value(engine, 2, "energy")) / work - 1;
}
TEST(WorkOfAWall, IsStoredInAnElasticDisc) {
  for (const bool hertz : {false, true}) {
    const auto error = [&](double dt) {
      return hertz ? energy_error("disc/hertz", 1e5, dt) : energy_error("disc/linear", k_n, dt);
    };
    const double coarse = error(8e-5), fine = error(2e-5);
    std::printf("%s: work of a wall off by %.1e and %.1e\n", hertz ? "Hertz" : "linear", coarse, fine);
    EXPECT_NEAR(std::log(std::abs(coarse / fine)) / std::log(4), 2, 0.3);
    EXPECT_LT(std::abs(coarse), 1e-3);
  }
}

/// A small sample, compressed by two walls; `more` comes behind the scene.
std::string compressed(const std::string& tangential, const std::string& more = "") {
  return box(tangential, {.gamma_n = 0.5}) + more +
         "create_discs box -0.1 0.1 -0.1 0.1 seed 3 density 6.36 velocity 0.1 uniform 150 1 0.003 0.008\n" +
         walls(
             "left -0.1 fixed bottom -0.1 fixed right 0.1 stress 5 mass 0.1 damping 3 "
             "top 0.1 stress 5 mass 0.1 damping 3") +
         "fix energy all energy/disc\nrun 12000\n";
}
const std::string shear = "fix_modify walls top strain rate -0.02 reset\n";
const char* const laws[] = {"off", "disc/viscous", "disc/cundall_strack",
                            "disc/cundall_strack tangential_damping on limitForce on"};

class Sample : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(OfEachLaw, Sample, testing::ValuesIn(laws),
                         [](const auto& info) { return "law_" + std::to_string(info.index); });

// From the first step on: work + initial kinetic energy = kinetic + elastic + heat. 1 % is what is promised;
// what is left is the error of velocity Verlet.
TEST_P(Sample, KeepsAccountOfItsEnergyOverManySteps) {
  Engine engine;
  engine.run(compressed(GetParam()) + "fix_modify walls top strain rate -0.02\nrun 10000\n");
  double work = 0, energy = 0;
  for (int k = 0; k < 4; ++k) work += value(engine, 20 + k);
  for (int k = 0; k < 5; ++k) energy += value(engine, 1 + k, "energy");
  Engine start;
  start.run(
      box() +
      "create_discs box -0.1 0.1 -0.1 0.1 seed 3 density 6.36 velocity 0.1 uniform 150 1 0.003 0.008\n");
  double initial = 0;
  for (const auto& [id, d] : start.discs()) initial += d.mass * (d.v_x * d.v_x + d.v_y * d.v_y) / 2;
  std::printf("tangential %s: energy account off by %.1e of the work\n", GetParam(),
              (work + initial - energy) / work);
  EXPECT_GT(work, 10 * initial);
  EXPECT_NEAR(energy / (work + initial), 1, 1e-2);
}

// Discs fall between walls that close in, and slide on a bottom: what gravity (its stock fix: scalar, J) and
// walls put in is with the discs, or the bottom (fix bottom/friction: scalar) and the contacts have it as
// heat.
TEST_P(Sample, KeepsAccountOfGravityAndTheBottomOverManySteps) {
  Engine engine;
  engine.run(
      box(GetParam(), {.gamma_n = 0.5}) +
      "create_discs box -0.1 0.1 -0.1 0.1 seed 3 density 6.36 velocity 0.1 uniform 150 1 0.003 0.008\n" +
      walls("left -0.1 fixed bottom -0.1 fixed right 0.1 stress 5 mass 0.1 damping 3 top 0.1 fixed") +
      "fix down all gravity 9.81 vector 0 -1 0\nfix slide all bottom/friction 0.05 9.81\n"
      "fix energy all energy/disc\nrun 0\n");
  struct Account {
    double discs, work, potential, bottom;
  };
  const auto now = [&] {
    return Account{engine.fix("energy").compute_scalar(), engine.fix("walls").compute_scalar(),
                   engine.fix("down").compute_scalar(), engine.fix("slide").compute_scalar()};
  };
  const Account start = now();
  engine.run("run 10000\n");
  const Account end = now();
  const double work = end.work - start.work, fallen = start.potential - end.potential,
               bottom = end.bottom - start.bottom, discs = end.discs - start.discs;
  std::printf(
      "tangential %s: walls %.2e J, gravity %.2e J, discs and contacts %.2e J, bottom %.2e J: off by %.1e\n",
      GetParam(), work, fallen, discs, bottom, (work + fallen - bottom) / discs - 1);
  // None of the four is small beside the tolerance.
  EXPECT_GT(work, 0.05 * fallen);
  EXPECT_GT(bottom, 0.05 * fallen);
  EXPECT_NEAR((work + fallen - bottom) / discs, 1, 1e-2);
}

// At rest, sum of f (x) l over all contacts, walls included, with branch vectors that end at the contact
// points, is the box's area times the pressure of its walls: 1e-6 is what is promised. The walls are still on
// their way to p.
TEST(SampleAtRest, CarriesThePressureOfItsWallsAfterManySteps) {
  Engine engine;
  const std::string frictionless_walls =
      "unfix mu\nfix mu all property/global coefficientFriction peratomtypepair 2 0.44 0 0 0\n";
  engine.run(compressed(laws[1], frictionless_walls) + "run 50000\n");
  double xx = 0, xy = 0, yx = 0, yy = 0;
  for (const auto& [ids, c] : engine.contacts()) {
    xx -= c.f_x * (c.x2 - c.x1);
    xy -= c.f_x * (c.y2 - c.y1);
    yx -= c.f_y * (c.x2 - c.x1);
    yy -= c.f_y * (c.y2 - c.y1);
  }
  const double area = (value(engine, 2) - value(engine, 1)) * (value(engine, 4) - value(engine, 3));
  for (int wall = 0; wall < 4; ++wall) {
    EXPECT_NEAR(value(engine, 13 + wall) / 5, 1, 1e-5);
    EXPECT_NEAR((wall < 2 ? xx : yy) / area / value(engine, 13 + wall), 1, 1e-6);
  }
  EXPECT_NEAR(xy / area, yx / area, 5e-6);  // no torques; not zero, as forces are spread unevenly along walls
}

class BiaxialRestart : public testing::Test {
 protected:
  BiaxialRestart() {
    int number = getpid();
    MPI_Bcast(&number, 1, MPI_INT, 0, MPI_COMM_WORLD);
    file_ = testing::TempDir() + "biaxial" + std::to_string(number) + ".restart";
  }
  ~BiaxialRestart() override { std::filesystem::remove(file_); }

  /// The sample of a file, with the top moving down.
  static std::string read(const std::string& file, const std::string& tangential) {
    return "clear\nnewton off\ncommunicate single vel yes\natom_modify map array\nread_restart " + file +
           "\nneighbor 0.001 bin\nneigh_modify delay 0\npair_style gran model disc/linear tangential " +
           tangential + "\npair_coeff * *\n" + constants({.gamma_n = 0.5}, 2) +
           walls(
               "left 0 fixed bottom 0 fixed right 0.1 stress 5 mass 0.1 damping 3 top 0.1 strain rate "
               "-0.02") +
           "fix energy all energy/disc\n";
  }
  std::string file_;
};

// Set-ups evaluate dashpots with other velocities than steps do, so the uninterrupted run has one there, too.
TEST_F(BiaxialRestart, ContinuesWallsSpringsAndHeat) {
  const std::string law = laws[2];
  Engine engine;
  engine.run(compressed(law) + shear + "run 200\nwrite_restart " + file_ + "\nrun 200\n");
  std::vector<double> expected;
  for (int k = 1; k <= 27; ++k) expected.push_back(value(engine, k));
  const double heat = value(engine, 4, "energy"), friction = value(engine, 5, "energy");
  const auto contacts = engine.contacts();
  engine.run(read(file_, law) + "run 200\n");
  for (int k = 1; k <= 27; ++k)
    EXPECT_EQ(value(engine, k), expected[k - 1]) << "value " << k;  // same arithmetic
  EXPECT_EQ(value(engine, 4, "energy"), heat);
  EXPECT_EQ(value(engine, 5, "energy"), friction);
  const auto again = engine.contacts();
  ASSERT_EQ(again.size(), contacts.size());
  int with_spring = 0;
  for (const auto& [ids, contact] : contacts) {
    with_spring += ids.first < 0 && contact.xi != 0;
    EXPECT_EQ(again.at(ids).xi, contact.xi);
    EXPECT_EQ(again.at(ids).f_n, contact.f_n);
  }
  EXPECT_GT(with_spring, 5);
}

// A packed sample is sheared for 100 steps on one rank and on all of this run; the sums of forces are rounded
// in another order. Each rank has a file of its own for its run alone.
TEST_F(BiaxialRestart, GoesOnAlikeOnAnyNumberOfRanks) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const std::string mine = file_ + std::to_string(rank), first = file_ + "0";
  for (const auto* law : laws) {
    std::array<double, 27> one{};
    std::map<std::pair<int, int>, Contact> contacts;
    Engine alone(MPI_COMM_SELF);
    alone.run(compressed(law) + "write_restart " + mine + "\n" + read(mine, law) + "run 100\n");
    for (int k = 0; k < 27; ++k) one[k] = value(alone, k + 1);
    contacts = alone.contacts();
    MPI_Barrier(MPI_COMM_WORLD);
    Engine engine(MPI_COMM_WORLD);
    engine.run(read(first, law) + "run 100\n");
    EXPECT_GT(one[12], 1);  // N/m
    for (int k = 0; k < 27; ++k)
      EXPECT_NEAR(value(engine, k + 1), one[k], 1e-11 * std::max(1.0, std::abs(one[k])))
          << law << ", value " << k + 1;
    const auto others = engine.contacts();
    ASSERT_EQ(contacts.size(), others.size());
    for (const auto& [ids, contact] : contacts) EXPECT_NEAR(contact.f_n, others.at(ids).f_n, 1e-11) << law;
    MPI_Barrier(MPI_COMM_WORLD);
    std::filesystem::remove(mine);
  }
}

}  // namespace
}  // namespace mikromakro::test
