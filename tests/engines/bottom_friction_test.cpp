// SPDX-License-Identifier: GPL-2.0-or-later
// fix bottom/friction: the way to rest, the energy that it takes, discs at rest. Runs on one rank and on two.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "engine.h"
#include "fix.h"
#include "modify.h"
#include "packing.h"

namespace mikromakro::test {
namespace {

constexpr double radius = 3.71e-3, mu_b = 0.1, g = 9.81, deceleration = mu_b * g;

/// Energy that the bottom has taken [J].
double taken(Engine& engine) {
  return engine.fix("bottom").compute_scalar();
}

/// So soft that no contact, of which there is none, asks for a short time step.
constexpr Material soft{.k_n = 0.1, .gamma_n = 0};

std::string sliding_disc(double v_x, double v_y, double omega, double dt, const std::string& keywords) {
  return scene("model disc/linear tangential off", soft, 0.05, 1) + disc(1, 0, 0, radius) +
         motion(1, v_x, v_y, omega) +
         fmt::format("fix integrate all nve/disc\nfix bottom all bottom/friction {} {} {}\ntimestep {}\n",
                     mu_b, g, keywords, dt);
}

double kinetic(const Disc& d) {
  return d.mass * (d.v_x * d.v_x + d.v_y * d.v_y) / 2;
}

TEST(BottomFriction, DeceleratesASlidingDiscUniformlyAlongItsWay) {
  // Velocity Verlet is exact for a constant force: x = v t - a t^2/2, along (3, 4)/5.
  Engine engine;
  engine.run(sliding_disc(0.6 * 0.3, 0.8 * 0.3, 7, 1e-4, "") + "run 1000\n");
  const Disc d = engine.discs().at(1);
  const double way = 0.3 * 0.1 - deceleration * 0.1 * 0.1 / 2, v = 0.3 - deceleration * 0.1;
  // Rounding of 1000 sums, the same in each step: 1e-16 of 0.3 m/s, and that over 0.1 s.
  EXPECT_NEAR(std::hypot(d.v_x, d.v_y), v, 3e-14);
  EXPECT_NEAR(d.x, 0.6 * way, 3e-15);
  EXPECT_NEAR(d.y, 0.8 * way, 3e-15);
  EXPECT_EQ(d.omega, 7);  // spins are left alone
  EXPECT_NEAR(taken(engine), d.mass * (0.3 * 0.3 - v * v) / 2, 1e-15);
  const double power = engine.fix("bottom").compute_vector(0);
  // The velocity that the step predicted: rounding only, under a constant force.
  EXPECT_NEAR(power, d.mass * deceleration * v, 1e-15);
}

/// Relative errors of the way to rest and of the energy taken, rms over velocities, that is over phases
/// within a step where the force begins to fall. Uniform deceleration to v_0, exponential decay below: (V^2 -
/// v_0^2)/2a + v_0^2/a.
struct Errors {
  double way = 0, energy = 0;
};

Errors stopping_errors(double dt) {
  constexpr double v_0 = 0.01;
  constexpr int velocities = 16;
  Errors rms;
  for (int k = 0; k < velocities; ++k) {
    const double v = 0.1 + k * deceleration * dt / velocities;
    // 25 decay times after v_0: exp(-25) = 1e-11 is left.
    const auto steps = std::lround(((v - v_0) + 25 * v_0) / deceleration / dt);
    Engine engine;
    engine.run(sliding_disc(v, 0, 0, dt, fmt::format("velocity {}", v_0)) + fmt::format("run {}\n", steps));
    const Disc d = engine.discs().at(1);
    const double way = (v * v + v_0 * v_0) / (2 * deceleration), energy = d.mass * v * v / 2;
    rms.way += std::pow(d.x / way - 1, 2) / velocities;
    rms.energy += std::pow(taken(engine) / energy - 1, 2) / velocities;
  }
  return {std::sqrt(rms.way), std::sqrt(rms.energy)};
}

TEST(BottomFriction, StoppingDistanceAndEnergyTakenConvergeWithOrderTwo) {
  const auto coarse = stopping_errors(1e-3), fine = stopping_errors(2.5e-4);
  std::printf("way to rest off by %.1e, energy taken by %.1e at mu_b g dt = v_0/10; %.1e, %.1e at v_0/40\n",
              coarse.way, coarse.energy, fine.way, fine.energy);
  EXPECT_NEAR(std::log(coarse.way / fine.way) / std::log(4), 2, 0.3);
  EXPECT_NEAR(std::log(coarse.energy / fine.energy) / std::log(4), 2, 0.3);
}

TEST(BottomFriction, NeverGivesEnergyToADiscAndLeavesRestAtRest) {
  // The shortest V0 that is allowed is 2 mu_b g dt; the default is five times that.
  for (const std::string keywords : {"", "velocity 2e-4"}) {
    Engine engine;
    engine.run(sliding_disc(0.02, -0.01, 0, 1e-4, keywords) + disc(2, 0.02, 0.02, radius) + "run 0\n");
    double before = kinetic(engine.discs().at(1));
    for (int step = 0; step < 400; ++step) {
      engine.run("run 1 pre no post no\n");
      const double now = kinetic(engine.discs().at(1));
      ASSERT_LE(now, before) << step;
      before = now;
    }
    // 0.0224 m/s are gone after 228 steps; what is left after 172 more has fallen by 0.9^130 = 1e-6 at least.
    EXPECT_LT(std::sqrt(2 * before / engine.discs().at(1).mass), 1e-8);
    const Disc resting = engine.discs().at(2);
    EXPECT_EQ(resting.x, 0.02);
    EXPECT_EQ(resting.v_x, 0);
    EXPECT_EQ(resting.v_y, 0);
  }
}

TEST(BottomFriction, ActsOnItsGroupOnly) {
  Engine engine;
  engine.run(scene("model disc/linear tangential off", soft, 0.05, 2) + disc(1, 0, 0, radius) +
             disc(2, 0.02, 0, radius, 6.36, 2) + motion(1, 0.1, 0) + motion(2, 0.1, 0) +
             "group slides type 1\nfix integrate all nve/disc\nfix bottom slides bottom/friction 0.1 9.81\n"
             "timestep 1e-4\nrun 100\n");
  // v - mu_b g t after 0.01 s, in 200 half-kicks, each rounded to 7e-18 m/s.
  EXPECT_NEAR(engine.discs().at(1).v_x, 0.1 - deceleration * 0.01, 2e-15);
  EXPECT_EQ(engine.discs().at(2).v_x, 0.1);
}

TEST(BottomFriction, ADiscUnderHalfOfItCreepsWithHalfTheVelocityOfRegularisation) {
  Engine engine;
  engine.run(sliding_disc(0, 0, 0, 1e-4, "velocity 1e-3"));
  const double mass = engine.discs().at(1).mass;
  engine.run(fmt::format("fix push all addforce {:.17g} 0 0\nrun 400\n", mass * deceleration / 2));
  // exp(-400 mu_b g dt / v_0) = 9e-18.
  EXPECT_NEAR(engine.discs().at(1).v_x, 5e-4, 1e-16);
}

TEST(BottomFriction, BalancesTheEnergyOfAPacking) {
  // Elastic discs without friction between them: energy, kinetic and of the springs, goes to the bottom
  // alone.
  Engine engine;
  engine.run(scene("model disc/linear tangential off damping off", {}, packing_box, 2, "p p p", "0.002"));
  engine.run(packing(20, 0.05));
  engine.run(
      "group small type 1\nfix integrate all nve/disc\ntimestep 2e-5\ncompute contacts all contact/disc\n"
      "fix bottom small bottom/friction 1 9.81\nrun 0\n");
  const auto energy = [&] {
    double sum = 0;
    for (const auto& [id, d] : engine.discs()) sum += kinetic(d);
    for (const auto& [ids, c] : engine.contacts()) sum += 352.1 * c.overlap * c.overlap / 2;
    return sum;
  };
  const double start = energy();
  engine.run("run 1000\n");
  const double gone = taken(engine);
  std::printf("bottom friction took %.1f %% of the energy, balance off by %.1e of that\n", 100 * gone / start,
              (energy() + gone - start) / gone);
  EXPECT_GT(gone, 0.1 * start);
  // Verlet's energy is off by (omega dt)^2/12 at most; omega^2 of the fastest mode is three times that of a
  // pair, with about 98 steps per contact.
  EXPECT_NEAR((energy() + gone) / start, 1, 3 * std::pow(M_PI / 98, 2) / 12);
}

class BottomFrictionRestart : public testing::Test {
 protected:
  BottomFrictionRestart() {
    int number = getpid();
    MPI_Bcast(&number, 1, MPI_INT, 0, MPI_COMM_WORLD);
    file_ = testing::TempDir() + "bottom" + std::to_string(number) + ".restart";
  }
  ~BottomFrictionRestart() override { std::filesystem::remove(file_); }
  std::string file_;
};

TEST_F(BottomFrictionRestart, KeepsTheEnergyTakenAndGoesOn) {
  Engine engine;
  engine.run(sliding_disc(0.1, 0, 0, 1e-4, "") + "run 100\nwrite_restart " + file_ + "\n");
  const double before = taken(engine);
  ASSERT_GT(before, 0);
  engine.run("run 100\n");
  const double later = taken(engine);
  engine.run("clear\nnewton off\ncommunicate single vel yes\natom_modify map array\nread_restart " + file_ +
             "\n" + constants({}, 1) +
             "neighbor 0.001 bin\nneigh_modify delay 0\nfix integrate all nve/disc\n" +
             "fix bottom all bottom/friction 0.1 9.81\n");
  EXPECT_EQ(taken(engine), before);
  engine.run("timestep 1e-4\nrun 100\n");
  EXPECT_NEAR(taken(engine) / later, 1, 1e-14);  // rounding of a sum that begins anew
}

}  // namespace
}  // namespace mikromakro::test
