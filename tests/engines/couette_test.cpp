// SPDX-License-Identifier: GPL-2.0-or-later
// fix couette/2d in the engine; on one rank and on two.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "engine.h"
#include "fix.h"
#include "modify.h"

namespace mikromakro::test {
namespace {

// Rings of 4 and 8 wall discs of radius 0.01 on circles of radius 0.1 and 0.3 about (0.05, -0.02): ids 1-4
// and 5-12.
const double c_x = 0.05, c_y = -0.02;
const std::string centre = " 0.05 -0.02 ";

std::string rings(const std::string& tangential, double outer_radius = 0.3) {
  return scene("model disc/linear tangential " + tangential, {}, 0.5, 4) + "create_ring" + centre +
         "0.1 number 4 type 3 radius 0.01 density 6.36\n" + "create_ring" + centre +
         std::to_string(outer_radius) + " number 8 type 4 radius 0.01 density 6.36 phase 0.1\n";
}
std::string groups() {
  return "group inner type 3\ngroup outer type 4\ngroup wall type 3 4\ngroup free subtract all wall\n"
         "neigh_modify exclude group wall wall\nfix integrate free nve/disc\ntimestep 4e-5\n";
}
std::string cell(const std::string& rest) {
  return "fix cell wall couette/2d center" + centre + "inner rough inner 0.1 outer rough outer 0.3 " + rest +
         "\n";
}

double cell_value(Engine& engine, int number) {
  auto* modify = engine.lammps().modify;
  return modify->fix[modify->find_fix("cell")]->compute_vector(number - 1);
}

// A wall disc at the angle phi of a ring with radius R; tolerance: rounding of angle, cosine and sum.
void expect_on_ring(const Disc& disc, double radius, double phi) {
  EXPECT_NEAR(disc.x, c_x + radius * std::cos(phi), 1e-12 * radius);
  EXPECT_NEAR(disc.y, c_y + radius * std::sin(phi), 1e-12 * radius);
}

void expect_velocity(const Disc& disc, double radius, double phi, double omega, double rate) {
  EXPECT_NEAR(disc.v_x, rate * std::cos(phi) - omega * radius * std::sin(phi), 1e-12);
  EXPECT_NEAR(disc.v_y, rate * std::sin(phi) + omega * radius * std::cos(phi), 1e-12);
  EXPECT_EQ(disc.omega, omega);
}

TEST(Couette, WallDiscsKeepTheExactAngleForManySteps) {
  Engine engine;
  engine.run(rings("off") + groups() + cell("omega_inner 3 omega_outer -0.7") + "run 100000\n");
  const auto discs = engine.discs();
  for (int k = 0; k < 4; ++k) {
    const double phi = k * std::numbers::pi / 2 + 3 * 4.0;
    expect_on_ring(discs.at(1 + k), 0.1, phi);
    expect_velocity(discs.at(1 + k), 0.1, phi, 3, 0);
  }
  for (int k = 0; k < 8; ++k)
    expect_on_ring(discs.at(5 + k), 0.3, 0.1 + k * std::numbers::pi / 4 - 0.7 * 4.0);
  EXPECT_DOUBLE_EQ(cell_value(engine, 5), 12.0);
  EXPECT_DOUBLE_EQ(cell_value(engine, 6), -2.8);
}

// 12 rad within 5000 steps: on two ranks every disc of the wheel changes its owner several times.
TEST(Couette, WallDiscsKeepTheirReferenceWhenTheyChangeRanks) {
  Engine engine;
  engine.run(rings("off") + groups() + cell("omega_inner 60") + "run 5000\n");
  for (int k = 0; k < 4; ++k)
    expect_on_ring(engine.discs().at(1 + k), 0.1, k * std::numbers::pi / 2 + 60 * 0.2);
}

TEST(Couette, WallDiscsHaveTheirVelocitiesBeforeTheFirstStep) {
  Engine engine;
  engine.run(rings("off") + groups() + cell("omega_inner 3") + "run 0\n");
  expect_velocity(engine.discs().at(2), 0.1, std::numbers::pi / 2, 3, 0);
}

// R(1/3 T) = R_end + (R_o - R_end)/2 (1 + cos(pi/3)) = 0.2 + 0.05 * 1.5 = 0.275;
// dR/dt = -0.05 pi/T sin(pi/3) with T = 0.03 s.
TEST(Couette, OuterRingShrinksSmoothly) {
  Engine engine;
  engine.run(rings("off") + groups() + cell("omega_inner 0 compact 0.2 0.03") + "run 250\n");
  const double rate = -0.05 * std::numbers::pi / 0.03 * std::sin(std::numbers::pi / 3);
  expect_on_ring(engine.discs().at(6), 0.275, 0.1 + std::numbers::pi / 4);
  expect_velocity(engine.discs().at(6), 0.275, 0.1 + std::numbers::pi / 4, 0, rate);
  EXPECT_NEAR(cell_value(engine, 7), 0.275, 1e-15);
  EXPECT_NEAR(cell_value(engine, 8), rate, 1e-13);
  engine.run("run 1000\n");
  expect_on_ring(engine.discs().at(6), 0.2, 0.1 + std::numbers::pi / 4);
  EXPECT_EQ(cell_value(engine, 8), 0.0);
}

// 0.1 s with dt = 4e-5, then 0.05 s with dt = 1e-5, over several runs.
TEST(Couette, TimeGoesOnOverRunsAndChangesOfTheTimeStep) {
  Engine engine;
  engine.run(rings("off") + groups() + cell("omega_inner 3") +
             "run 1500\nrun 1000\ntimestep 1e-5\nrun 3000\nreset_timestep 7\nrun 2000\n");
  EXPECT_DOUBLE_EQ(cell_value(engine, 5), 3 * 0.15);
  expect_on_ring(engine.discs().at(1), 0.1, 3 * 0.15);
}

TEST(Couette, ANewFixTakesThePresentAnglesAsItsZero) {
  Engine engine;
  engine.run(rings("off") + groups() + cell("omega_inner 3") + "run 2500\nunfix cell\n" +
             cell("omega_inner -1") + "run 2500\n");
  EXPECT_DOUBLE_EQ(cell_value(engine, 5), -0.1);
  expect_on_ring(engine.discs().at(1), 0.1, 0.3 - 0.1);
}

// A disc of radius 0.02 to the right of the first wall disc, overlap 1e-4, spinning with s = 2 1/s. With
// tangential viscosity (gamma_t = 0.15, below the cap mu k_n 1e-4 = 0.0155 N) the force on the wall disc is
// f_x = -k_n 1e-4, f_y = -gamma_t s (0.02 - 5e-5), and it acts at x_c = 0.1 + 0.01 - 5e-5 from the centre of
// the ring.
TEST(Couette, LoadsOfOneDiscPressedOnTheWheel) {
  Engine engine;
  engine.run(rings("disc/viscous") + disc(13, c_x + 0.1 + 0.03 - 1e-4, c_y, 0.02) + motion(13, 0, 0, 2) +
             groups() + cell("omega_inner 0 height 0.006") + "run 0\n");
  const double f_y = -0.15 * 2 * (0.02 - 5e-5);
  // x of the disc is rounded to 1e-17 m, the overlap of 1e-4 m to 1e-13 of itself.
  EXPECT_NEAR(cell_value(engine, 1), (0.11 - 5e-5) * f_y, 1e-15);
  EXPECT_NEAR(cell_value(engine, 3), 352.1 * 1e-4 / (2 * std::numbers::pi * 0.1 * 0.006), 1e-9);
  EXPECT_EQ(cell_value(engine, 2), 0.0);
  EXPECT_EQ(cell_value(engine, 4), 0.0);
  EXPECT_EQ(cell_value(engine, 9), 0.0);
}

// The same disc resting on the first wall disc, 90 degrees on: the normal force (0, -k_n 1e-4) on the wall
// disc has the lever 0.1; without a height the pressure is a force per length. The wheel turns against it:
// power -T omega > 0.
TEST(Couette, TorqueAndPowerOfANormalForceBesideTheWheel) {
  Engine engine;
  engine.run(rings("off") + disc(13, c_x + 0.1, c_y + 0.03 - 1e-4, 0.02) + groups() +
             cell("omega_inner 1e-9") + "run 0\n");
  EXPECT_NEAR(cell_value(engine, 1), -0.1 * 352.1 * 1e-4, 1e-11);  // the dashpot sees 1e-10 m/s * 0.19 kg/s
  EXPECT_NEAR(cell_value(engine, 3), 0.0, 1e-12);
  EXPECT_NEAR(cell_value(engine, 9), 1e-9 * 0.1 * 352.1 * 1e-4, 1e-19);
}

// Pressed outwards on the outer ring at the angle 0.1, where a wall disc is.
TEST(Couette, OuterPressureIsPositiveInCompression) {
  Engine engine;
  const double r = 0.3 - 0.03 + 1e-4;
  engine.run(rings("off") + disc(13, c_x + r * std::cos(0.1), c_y + r * std::sin(0.1), 0.02) + groups() +
             cell("omega_inner 0") + "run 0\n");
  EXPECT_NEAR(cell_value(engine, 4), 352.1 * 1e-4 / (2 * std::numbers::pi * 0.3), 1e-12);
  EXPECT_NEAR(cell_value(engine, 2), 0.0, 1e-14);
}

/// Pressure [N/m] of an overlap [m] on the wheel, without a height and at rest: k_n overlap/(2 pi R).
double wheel_pressure(double overlap) {
  return 352.1 * overlap / (2 * std::numbers::pi * 0.1);
}

// The loads are cached per step; the average asks for them at every step of the run, in which the disc that
// was pressed on the wheel moves away: k_n overlap + gamma_n v_n of where it is. The force saw the predicted
// velocity, from which that of the end of the step differs in order dt^2: 1e-6 of the force; a step changes
// it by 1e-3.
TEST(Couette, LoadsFollowTheSteps) {
  Engine engine;
  engine.run(rings("off") + disc(13, c_x + 0.1 + 0.03 - 1e-4, c_y, 0.02) + groups() + cell("omega_inner 0") +
             "fix average all ave/time 1 1 1 f_cell[3]\nrun 0\n");
  EXPECT_NEAR(cell_value(engine, 3), wheel_pressure(1e-4), 1e-12);
  engine.run("run 10\n");
  const Disc away = engine.discs().at(13);
  const double overlap = c_x + 0.13 - away.x, now = wheel_pressure(overlap - 0.19 / 352.1 * away.v_x);
  EXPECT_LT(now, 0.99 * wheel_pressure(1e-4));
  EXPECT_NEAR(cell_value(engine, 3), now, 1e-5 * now);
}

// The same step evaluated again with a larger disc: twice the overlap.
TEST(Couette, LoadsFollowANewEvaluationOfTheSameStep) {
  Engine engine;
  engine.run(rings("off") + disc(13, c_x + 0.1 + 0.03 - 1e-4, c_y, 0.02) + groups() + cell("omega_inner 0") +
             "run 0\n");
  EXPECT_NEAR(cell_value(engine, 3), wheel_pressure(1e-4), 1e-12);
  engine.run("set atom 13 diameter 0.0402\nrun 0\n");  // overlap 2e-4
  EXPECT_NEAR(cell_value(engine, 3), wheel_pressure(2e-4), 1e-12);
}

class Restart : public testing::Test {
 protected:
  // A name of its own: tests run side by side, on one rank and on two.
  Restart() {
    int ranks = 0;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    file_ = std::filesystem::temp_directory_path() / (test + std::to_string(ranks) + ".restart");
  }
  ~Restart() override {
    MPI_Barrier(MPI_COMM_WORLD);
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
  }
  std::string write() const { return "write_restart " + file_.string() + "\n"; }
  std::string read() const {
    return "clear\nnewton off\ncommunicate single vel yes\natom_modify map array\nread_restart " +
           file_.string() +
           "\nneighbor 0.001 bin\nneigh_modify delay 0\n"
           "pair_style gran model disc/linear tangential off\npair_coeff * *\n" +
           constants() + groups();
  }

 private:
  static std::string constants() {
    const std::string lines = scene("none", {}, 0.5, 4);
    return lines.substr(lines.find("fix kn"), lines.find("pair_style") - lines.find("fix kn"));
  }
  std::filesystem::path file_;
};

TEST_F(Restart, InTheMiddleEqualsTheUninterruptedRun) {
  const std::string motion = "omega_inner 3 omega_outer -0.7 compact 0.2 0.03";
  Engine engine;
  engine.run(rings("off") + groups() + cell(motion) + "run 300\n" + write() + "run 123\n");
  const auto uninterrupted = engine.discs();
  engine.run(read() + cell(motion) + "run 123\n");
  const auto restarted = engine.discs();
  ASSERT_EQ(restarted.size(), 12U);
  for (const auto& [id, disc] : restarted) {
    EXPECT_EQ(disc.x, uninterrupted.at(id).x);  // the same arithmetic on the same numbers
    EXPECT_EQ(disc.y, uninterrupted.at(id).y);
    EXPECT_EQ(disc.v_x, uninterrupted.at(id).v_x);
  }
}

// 0.012 s at 3 1/s, then 0.012 s at 1 1/s: no jump of the angle.
TEST_F(Restart, WithAnotherRateStartsAtTheAngleReached) {
  Engine engine;
  engine.run(rings("off") + groups() + cell("omega_inner 3") + "run 300\n" + write() + read() +
             cell("omega_inner 1") + "run 0\n");
  EXPECT_NEAR(cell_value(engine, 5), 0.036, 1e-15);
  expect_on_ring(engine.discs().at(1), 0.1, 0.036);
  engine.run("run 300\n");
  EXPECT_NEAR(cell_value(engine, 5), 0.048, 1e-15);
  expect_on_ring(engine.discs().at(1), 0.1, 0.048);
}

}  // namespace
}  // namespace mikromakro::test
