// SPDX-License-Identifier: GPL-2.0-or-later
// The wall of docs/add_a_wall.md, taken from the page.
#include <gtest/gtest.h>

#include <complex>
#include <numbers>

#include "engine.h"
#include "engine/engine_access.h"
#include "fix.h"
#include "fix_wall_shaking.h"

namespace mikromakro::test {
namespace {

void register_wall(Engine& engine) {
  styles::fix_styles(*engine.lammps().modify)["wall/shaking"] = styles::make_fix<styles::FixWallShaking>;
}

// The disc follows the floor as an oscillator driven at its foot; its own oscillation is damped by e^-30 when
// it is looked at. With omega_0 dt = 0.01 the scheme's error is of the order 1e-4.
TEST(ShakingWall, ADiscFollowsItAsADrivenOscillator) {
  const double radius = 0.004, g = 9.81, amplitude = 5e-4, frequency = 10, dt = 1e-5;
  const Material material;
  const double mass = 6.36 * std::numbers::pi * radius * radius;
  const double rest = radius - mass * g / material.k_n;
  Engine engine;
  register_wall(engine);
  engine.run(scene("model disc/linear tangential off", material, 0.02) + disc(1, 0, rest, radius) +
             "timestep 1e-5\nfix integrate all nve/disc\nfix weight all gravity 9.81 vector 0 -1 0\n"
             "fix floor all wall/shaking type 1 amplitude 5e-4 frequency 10\nrun 10000\n");
  const double omega = 2 * std::numbers::pi * frequency, eta = material.gamma_n / (2 * mass);
  const std::complex<double> i(0, 1), spring = material.k_n / mass + 2.0 * i * eta * omega;
  const std::complex<double> response = spring / (spring - omega * omega);
  for (int step = 10000; step < 20000; step += 1000) {
    const double expected = (amplitude * response * std::exp(i * omega * (step * dt))).imag();
    EXPECT_NEAR((engine.discs().at(1).y - rest) / amplitude, expected / amplitude, 1e-3) << step;
    engine.run("run 1000\n");
  }
}

}  // namespace
}  // namespace mikromakro::test
