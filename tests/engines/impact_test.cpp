// SPDX-License-Identifier: GPL-2.0-or-later
// An oblique impact inside the engine is the one of physics/impact/impact.h, step by step: what is measured
// there holds here.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine.h"
#include "physics/contact/contact_duration.h"
#include "physics/impact/impact.h"

namespace mikromakro::test {
namespace {

constexpr double radius = 3.71e-3, speed = 0.02, dt = 4e-5;
const Material material;

template <physics::Effects effects>
void expect_same_course(const std::string& pair_style, const std::string& integrator,
                        physics::Scheme scheme) {
  Engine engine;
  engine.run(scene(pair_style, material));
  engine.run(disc(1, 0, 0, radius) + disc(2, 2 * radius + 0.3 * dt * speed, 1e-4, radius));
  engine.run(motion(1, speed / 2, 0.01, 1) + motion(2, -speed / 2, -0.01));
  engine.run("fix integrate all nve/disc " + integrator + fmt::format("\ntimestep {:.17g}\nrun 0\n", dt));

  using Pair = physics::FreePair<effects>;
  const auto before = engine.discs();
  const auto as_disc = [&](int id) {
    const auto& d = before.at(id);
    return typename Pair::Disc{{{d.x, d.y}, {d.v_x, d.v_y}, d.omega, d.radius}, d.mass};
  };
  const physics::ContactParameters law{material.k_n, material.gamma_n, material.k_t, material.gamma_t,
                                       material.mu};
  Pair pair(law, {as_disc(1), as_disc(2)}, dt, scheme);

  // Contact from the first step on to step 57 or so; looked at in between and when it is over.
  for (const int steps : {20, 30, 20}) {
    engine.run(fmt::format("run {}\n", steps));
    for (int k = 0; k < steps; ++k) pair.step();
    for (const int id : {1, 2}) {
      const auto& ours = pair.discs()[id - 1];
      const auto theirs = engine.discs().at(id);
      // Rounding of positions, 1e-18 m, in overlaps of 1e-5 m, over 70 steps.
      EXPECT_NEAR(ours.position.x, theirs.x, 1e-15);
      EXPECT_NEAR(ours.position.y, theirs.y, 1e-15);
      EXPECT_NEAR(ours.velocity.x, theirs.v_x, 1e-11 * speed);
      EXPECT_NEAR(ours.velocity.y, theirs.v_y, 1e-11 * speed);
      EXPECT_NEAR(ours.spin * radius, theirs.omega * radius, 1e-11 * speed);
    }
  }
  EXPECT_LT(pair.state().overlap, 0);
}

TEST(ImpactInTheEngine, IsThatWithoutEngineStepByStep) {
  const std::string spring = "model disc/linear tangential disc/cundall_strack",
                    viscous = "model disc/linear tangential disc/viscous";
  expect_same_course<physics::Effects{physics::Tangential::spring}>(spring, "",
                                                                    physics::Scheme::same_instant);
  expect_same_course<physics::Effects{physics::Tangential::viscous_coulomb}>(viscous, "",
                                                                             physics::Scheme::same_instant);
}

// What `mikromakro timestep --error` goes by: rms over 8 x 8 phases of onset and release.
TEST(TimeStepForAnError, KeepsIt) {
  constexpr double wanted = 1e-3, v_n = 1e-3;
  const double mass = 6.36 * M_PI * radius * radius, m12 = mass / 2;
  const physics::Impact impact{{material.k_n, material.gamma_n, 0, 0, 0},
                               radius,
                               mass,
                               v_n,
                               0,
                               physics::contact_duration(material.k_n, material.gamma_n, m12)};
  const double steps = physics::steps_for_error<physics::Effects{}>(impact, wanted);
  double squares = 0;
  for (int k = 0; k < 64; ++k) {
    const int row = k / 8;
    const double onset = (row + 0.5) / 8, step = impact.duration / (steps + k % 8 / 8.0);
    Engine engine;
    engine.run(scene("model disc/linear tangential off", material));
    engine.run(disc(1, 0, 0, radius) + disc(2, 2 * radius + onset * step * v_n, 0, radius));
    engine.run(motion(1, v_n / 2, 0) + motion(2, -v_n / 2, 0));
    engine.run(fmt::format("fix integrate all nve/disc\ntimestep {:.17g}\nrun {}\n", step,
                           static_cast<int>(1.5 * steps)));
    const auto after = engine.discs();
    const double e_n = (after.at(2).v_x - after.at(1).v_x) / v_n;
    squares += std::pow(e_n - physics::restitution(material.k_n, material.gamma_n, m12), 2) / 64;
  }
  std::printf("error 1e-3: t_c/%.1f, of which the engine makes an error of %.3e\n", steps,
              std::sqrt(squares));
  EXPECT_LT(std::sqrt(squares), wanted * (1 + 1e-3));  // overlaps of 2e-4 radii
  EXPECT_GT(std::sqrt(squares), 0.95 * wanted);        // steps are chosen to 2 %, the order is 2
}

}  // namespace
}  // namespace mikromakro::test
