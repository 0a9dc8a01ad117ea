// SPDX-License-Identifier: GPL-2.0-or-later
// The stock law of LAMMPS, gran/hooke/history, on the same pairs of discs, after a first step that stretches
// the springs. It differs by two conventions only, and each is put in term by term:
//   damping: its constants are multiplied by the reduced mass, gamma = m12 gamma_stock;
//   lever arm: spins act at the radius a, not at the contact point a - overlap/2, both in the slip rate,
//            v_t + (omega_1 + omega_2) overlap/2, and in the torque.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine.h"

namespace mikromakro::test {
namespace {

constexpr double dt = 4e-5, k_n = 352.1, k_t = 281.68, mu = 0.44;
// So heavy that no force changes a velocity by more than rounding: both laws see the same motion.
constexpr double density = 6.36e14;
constexpr double gamma_n_stock = 2e-11, gamma_t_stock = 1.5e-11;  // 1/s
constexpr double our_gamma = 0.1;                                 // kg/s
constexpr int pairs = 60;

/// Pairs of discs far from each other: the force on a disc is that of its contact.
std::string lonely_pairs() {
  std::mt19937 generator(11);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(generator()) / 4294967296.0;
  };
  std::string lines;
  for (int k = 0; k < pairs; ++k) {
    const double a_1 = uniform(0.003, 0.005), a_2 = uniform(0.003, 0.005), angle = uniform(0, 2 * M_PI);
    const double distance = a_1 + a_2 - uniform(1e-5, 2e-4);
    const int row = k / 10;
    const double x = -0.3 + 0.06 * (k % 10), y = -0.3 + 0.06 * row;
    lines += disc(2 * k + 1, x, y, a_1, density) +
             disc(2 * k + 2, x + distance * std::cos(angle), y + distance * std::sin(angle), a_2, density);
    for (const int id : {2 * k + 1, 2 * k + 2})
      lines += motion(id, uniform(-0.02, 0.02), uniform(-0.02, 0.02), uniform(-5, 5));
  }
  return lines;
}

const std::string box =
    "units si\ndimension 2\nnewton off\natom_style granular\natom_modify map array\n"
    "communicate single vel yes\nboundary f f p\n"
    "region box block -0.4 0.4 -0.4 0.4 -0.001 0.001 units box\ncreate_box 1 box\nneighbor 0.001 bin\n"
    "neigh_modify delay 0\n";

std::map<int, Disc> stock_discs() {
  Engine engine;
  engine.run(box + lonely_pairs() +
             fmt::format("pair_style gran/hooke/history {} {} {} {} {} 1\npair_coeff * *\n", k_n, k_t,
                         gamma_n_stock, gamma_t_stock, mu) +
             fmt::format("timestep {}\nfix integrate all nve/sphere disc\nrun 1\n", dt));
  return engine.discs();
}

/// Ours from the same state, with the velocities of the half step as the stock integrator has them.
struct Ours {
  std::map<int, Disc> discs;
  std::map<std::pair<int, int>, Contact> contacts;
};
Ours our_discs() {
  Engine engine;
  engine.run(box + lonely_pairs() + constants({k_n, our_gamma, k_t, our_gamma, mu}, 1) +
             "pair_style gran model disc/linear tangential disc/cundall_strack tangential_damping on\n"
             "pair_coeff * *\ncompute contacts all contact/disc\n" +
             fmt::format("timestep {}\nfix integrate all nve/disc velocity half_step\nrun 1\n", dt));
  return {engine.discs(), engine.contacts()};
}

struct Force {
  double f_x, f_y, torque_1, torque_2;
};

/// The law of a contact after the first step: the constants of this pair, and where spins act (0: at the
/// contact point, 1: at the radius).
Force law(const Contact& c, const Disc& one, const Disc& two, double gamma_n, double gamma_t, double arm) {
  const double v_t = c.v_t + arm * (one.omega + two.omega) * c.overlap / 2;
  const double f_n = k_n * c.overlap + gamma_n * c.v_n;
  const double cap = mu * std::abs(f_n);
  const double f_t = std::clamp(-k_t * v_t * dt - gamma_t * v_t, -cap, cap);
  const double short_by = (1 - arm) * c.overlap / 2;
  return {-f_n * c.n_x - f_t * c.n_y, -f_n * c.n_y + f_t * c.n_x, (one.radius - short_by) * f_t,
          (two.radius - short_by) * f_t};
}

double off(const Force& expected, const Disc& one, const Disc& two, double scale) {
  return std::max({std::hypot(expected.f_x - one.f_x, expected.f_y - one.f_y),
                   std::abs(expected.torque_1 - one.torque) / one.radius,
                   std::abs(expected.torque_2 - two.torque) / two.radius}) /
         scale;
}

TEST(StockLaw, DiffersByTheDampingAndTheLeverArmOnly) {
  const auto stock = stock_discs();
  const auto [discs, contacts] = our_discs();
  ASSERT_EQ(contacts.size(), pairs);
  double ours_off = 0, with_stock_damping = 0, with_stock_arm = 0, with_both = 0;
  for (const auto& [ids, c] : contacts) {
    const Disc &one = discs.at(ids.first), &two = discs.at(ids.second);
    const Disc &stock_one = stock.at(ids.first), &stock_two = stock.at(ids.second);
    const double m12 = one.mass * two.mass / (one.mass + two.mass);
    const double scale = std::hypot(one.f_x, one.f_y);
    const auto note = [&](double& largest, const Force& expected) {
      largest = std::max(largest, off(expected, stock_one, stock_two, scale));
    };
    // Ours is this law with its own constants.
    EXPECT_LE(off(law(c, one, two, our_gamma, our_gamma, 0), one, two, scale), 1e-12) << ids.first;
    note(ours_off, law(c, one, two, our_gamma, our_gamma, 0));
    note(with_stock_damping, law(c, one, two, m12 * gamma_n_stock, m12 * gamma_t_stock, 0));
    note(with_stock_arm, law(c, one, two, our_gamma, our_gamma, 1));
    note(with_both, law(c, one, two, m12 * gamma_n_stock, m12 * gamma_t_stock, 1));
  }
  std::printf(
      "gran/hooke/history against ours, largest difference over the force: %.1e; with its damping %.1e; with "
      "its lever arm %.1e; with both %.1e\n",
      ours_off, with_stock_damping, with_stock_arm, with_both);
  EXPECT_LE(with_both, 1e-12);
  // Neither alone is enough.
  EXPECT_GT(with_stock_damping, 1e-4);
  EXPECT_GT(with_stock_arm, 1e-2);
}

}  // namespace
}  // namespace mikromakro::test
