// SPDX-License-Identifier: GPL-2.0-or-later
// Linear and angular momentum of many discs, and the energy of a frictionless elastic gas. Runs on one rank
// and on two.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "engine.h"

namespace mikromakro::test {
namespace {

constexpr double radius = 3.71e-3, density = 6.36, k_n = 352.1, k_hertz = 1e6;

/// Uniform in [0, 1), the same on every platform.
double uniform(std::mt19937& raw) {
  return raw() / 4294967296.0;
}

struct Placed {
  double x, y, radius;
};

/// Up to `count` discs of 0.7 to 1 radius in [-half, half]^2 that do not overlap, also not across periodic
/// borders.
std::vector<Placed> random_discs(std::mt19937& raw, std::size_t count, double half) {
  std::vector<Placed> discs;
  for (int trial = 0; discs.size() < count && trial < 200000; ++trial) {
    const Placed p{half * (2 * uniform(raw) - 1), half * (2 * uniform(raw) - 1),
                   radius * (0.7 + 0.3 * uniform(raw))};
    const bool free = std::none_of(discs.begin(), discs.end(), [&](const Placed& q) {
      return std::hypot(std::remainder(p.x - q.x, 2 * half), std::remainder(p.y - q.y, 2 * half)) <
             p.radius + q.radius;
    });
    if (free) discs.push_back(p);
  }
  return discs;
}

/// Random velocities and rim speeds up to `speed`, towards the centre by `inwards` / s.
std::string lines_for(const std::vector<Placed>& discs, std::mt19937& raw, double speed, double inwards) {
  std::string lines;
  int id = 0;
  const auto random_speed = [&] { return speed * (2 * uniform(raw) - 1); };
  for (const auto& p : discs) {
    lines += disc(++id, p.x, p.y, p.radius, density);
    const double v_x = random_speed() - inwards * p.x, v_y = random_speed() - inwards * p.y;
    lines += motion(id, v_x, v_y, random_speed() / p.radius);
  }
  return lines;
}

struct Momenta {
  double p_x = 0, p_y = 0, angular = 0;
};

Momenta momenta(const std::map<int, Disc>& discs) {
  Momenta sum;
  for (const auto& [id, d] : discs) {
    sum.p_x += d.mass * d.v_x;
    sum.p_y += d.mass * d.v_y;
    sum.angular += d.mass * (d.x * d.v_y - d.y * d.v_x) + d.inertia() * d.omega;
  }
  return sum;
}

/// Sums of magnitudes: what rounding is relative to.
Momenta magnitudes(const std::map<int, Disc>& discs) {
  Momenta sum;
  for (const auto& [id, d] : discs) {
    sum.p_x += d.mass * std::abs(d.v_x);
    sum.p_y += d.mass * std::abs(d.v_y);
    sum.angular += d.mass * std::hypot(d.x, d.y) * std::hypot(d.v_x, d.v_y) + d.inertia() * std::abs(d.omega);
  }
  return sum;
}

struct Law {
  const char* pair_style;
  double k_n;  // [N/m], of Hertz's law [N/m^2]: about as stiff at overlaps of 1 % of the radius
};
const Law laws[] = {
    {"model disc/linear tangential off", k_n},
    {"model disc/linear tangential disc/viscous", k_n},
    {"model disc/linear tangential disc/cundall_strack", k_n},
    {"model disc/linear tangential disc/cundall_strack tangential_damping on limitForce on", k_n},
    {"model disc/hertz tangential disc/viscous limitForce on", k_hertz},
    {"model disc/hertz tangential disc/cundall_strack damping off", k_hertz}};
void PrintTo(const Law& law, std::ostream* out) {
  *out << law.pair_style;
}

// A step rounds each disc's velocity by 1e-16 of itself and each sum of forces by 1e-16 of its terms: a
// random walk of sqrt(steps * discs) * 1e-16 = 4e-14 of a velocity, 1e-16 ... 1e-15 of the sum of magnitudes.
// On two ranks both sides evaluate a contact across the border with normals from differences of the same
// positions: opposite exactly, or off by rounding where a periodic image is shifted by the box (1e-16 of the
// box is 1e-12 of an overlap).
constexpr double rounding = 3e-14;

class Conservation : public testing::TestWithParam<Law> {};
INSTANTIATE_TEST_SUITE_P(OfEachLaw, Conservation, testing::ValuesIn(laws),
                         [](const auto& info) { return "law_" + std::to_string(info.index); });

TEST_P(Conservation, OfLinearMomentumInAPeriodicGas) {
  std::mt19937 raw(1);
  Engine engine;
  engine.run(scene(GetParam().pair_style, {.k_n = GetParam().k_n}, 0.06, 1, "p p p"));
  engine.run(lines_for(random_discs(raw, 200, 0.06), raw, 0.2, 0));
  const auto before = momenta(engine.discs()), scale = magnitudes(engine.discs());
  engine.run("fix integrate all nve/disc\ncompute contacts all contact/disc\ntimestep 2e-5\nrun 2000\n");
  const auto discs = engine.discs();
  const auto after = momenta(discs);
  ASSERT_EQ(discs.size(), 200U);
  EXPECT_GT(engine.contacts().size(), 5U);
  EXPECT_NEAR(after.p_x, before.p_x, rounding * scale.p_x);
  EXPECT_NEAR(after.p_y, before.p_y, rounding * scale.p_y);
}

TEST_P(Conservation, OfAngularMomentumInACollapsingCluster) {
  std::mt19937 raw(2);
  Engine engine;
  engine.run(scene(GetParam().pair_style, {.k_n = GetParam().k_n}, 0.5, 1, "f f p"));
  engine.run(lines_for(random_discs(raw, 200, 0.06), raw, 0.1, 5));
  const auto before = momenta(engine.discs()), scale = magnitudes(engine.discs());
  engine.run("fix integrate all nve/disc\ncompute contacts all contact/disc\ntimestep 2e-5\nrun 1500\n");
  const auto discs = engine.discs();
  const auto after = momenta(discs);
  ASSERT_EQ(discs.size(), 200U);
  EXPECT_GT(engine.contacts().size(), 30U);  // it has collapsed
  std::printf("%s: angular momentum off by %.1e of its magnitudes\n", GetParam().pair_style,
              (after.angular - before.angular) / scale.angular);
  EXPECT_NEAR(after.p_x, before.p_x, rounding * scale.p_x);
  EXPECT_NEAR(after.p_y, before.p_y, rounding * scale.p_y);
  // Orbital and spin part together: lever arms end in one contact point.
  EXPECT_NEAR(after.angular, before.angular, rounding * scale.angular);
}

/// Kinetic energy and that of the springs: k_n overlap^2/2, Hertz 2/5 k_n sqrt(a_12) overlap^(5/2).
double energy(const Engine& engine, bool hertz) {
  const auto discs = engine.discs();
  double sum = 0;
  for (const auto& [id, d] : discs) {
    sum += (d.mass * (d.v_x * d.v_x + d.v_y * d.v_y) + d.inertia() * d.omega * d.omega) / 2;
  }
  for (const auto& [ids, c] : engine.contacts()) {
    const double a_1 = discs.at(ids.first).radius, a_2 = discs.at(ids.second).radius;
    sum += hertz ? 0.4 * k_hertz * std::sqrt(a_1 * a_2 / (a_1 + a_2)) * std::pow(c.overlap, 2.5)
                 : k_n * c.overlap * c.overlap / 2;
  }
  return sum;
}

struct Deviation {
  double largest, rms;
};

/// Relative deviation of the energy of 40 elastic gases within 0.016 s: the signs of the collisions' errors
/// are random, so that one gas alone scatters.
Deviation energy_deviation(double dt, bool hertz) {
  Deviation deviation{0, 0};
  constexpr int gases = 40, looks = 40;
  for (int gas = 0; gas < gases; ++gas) {
    std::mt19937 raw(3 + gas);
    Engine engine;
    engine.run(
        scene(hertz ? "model disc/hertz tangential off damping off" : "model disc/linear tangential off",
              {.k_n = hertz ? k_hertz : k_n, .gamma_n = 0}, 0.06, 1, "p p p"));
    engine.run(lines_for(random_discs(raw, 200, 0.06), raw, 0.3, 0));
    engine.run(fmt::format(
        "fix integrate all nve/disc\ncompute contacts all contact/disc\ntimestep {}\nrun 0\n", dt));
    const double start = energy(engine, hertz);
    for (int look = 0; look < looks; ++look) {
      engine.run(fmt::format("run {} pre no\n", std::lround(4e-4 / dt)));
      const double off = energy(engine, hertz) / start - 1;
      deviation.largest = std::max(deviation.largest, std::abs(off));
      deviation.rms += off * off / (gases * looks);
    }
  }
  deviation.rms = std::sqrt(deviation.rms);
  return deviation;
}

void expect_drift_of_order_two(bool hertz) {
  const auto coarse = energy_deviation(4e-5, hertz), fine = energy_deviation(1e-5, hertz);
  std::printf("%s: energy deviates by at most %.2e (rms %.2e) at dt = 4e-5 s, %.2e (rms %.2e) at 1e-5 s\n",
              hertz ? "Hertz" : "linear", coarse.largest, coarse.rms, fine.largest, fine.rms);
  EXPECT_NEAR(std::log(coarse.largest / fine.largest) / std::log(4), 2, 0.3);
  EXPECT_NEAR(std::log(coarse.rms / fine.rms) / std::log(4), 2, 0.3);
}

TEST(ElasticGas, DriftFallsWithTheSquareOfTheTimeStepOverManySteps) {
  expect_drift_of_order_two(false);
}

TEST(ElasticGas, OfHertzianContactsToo_ManySteps) {
  expect_drift_of_order_two(true);
}

}  // namespace
}  // namespace mikromakro::test
