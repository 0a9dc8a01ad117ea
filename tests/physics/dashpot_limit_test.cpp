// SPDX-License-Identifier: GPL-2.0-or-later
// Where the dashpots of a dense packing make velocity Verlet unstable: the bound of the engines' check.
//
// A periodic triangular lattice under pressure has a mode of 6 gamma_n/m = 3 gamma_n/m12 for its dashpots and
// 3 k_n/m12 for its springs. With forces of the velocities half a step earlier, the step is
// z^2 - (2 - d - w) z + 1 - d = 0, d = 3 gamma_n dt/m12, w = 3 k_n dt^2/m12; z = -1 at 2 d + w = 4.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "physics/contact/contact_law.h"
#include "physics/math/plane_vector.h"

namespace mikromakro::physics {
namespace {

constexpr int side = 4;  // even: the stiffest mode, of opposite neighbouring rows, fits in
constexpr double radius = 1, mass = 1, m12 = mass / 2, dt = 1;
constexpr double spring_part = 1e-4;  // w

class Lattice {
 public:
  /// `steps_of_dashpot`: gamma_n dt/m12.
  explicit Lattice(double steps_of_dashpot)
      : parameters_{spring_part / 3 * m12 / (dt * dt), steps_of_dashpot * m12 / dt, 0, 0, 0} {
    std::mt19937 random(5);
    std::normal_distribution<double> normal(0, 1e-12);  // far below the overlaps, so that all contacts last
    for (int i = 0; i < side * side; ++i) {
      position_[i] = {spacing * (i % side + 0.5 * (i / side)), spacing * height * (i / side)};
      velocity_[i] = {normal(random), normal(random)};
    }
  }

  double energy() const {
    double sum = 0;
    for (const PlaneVector& v : velocity_) sum += mass / 2 * (v.x * v.x + v.y * v.y);
    return sum;
  }

  void step() {
    std::array<PlaneVector, side * side> force{};
    for (int i = 0; i < side * side; ++i)
      for (const auto& [a, b] : {std::array{1, 0}, std::array{0, 1}, std::array{-1, 1}}) add(i, a, b, force);
    for (int i = 0; i < side * side; ++i) {
      velocity_[i].x += dt / mass * force[i].x;
      velocity_[i].y += dt / mass * force[i].y;
      position_[i].x += dt * velocity_[i].x;
      position_[i].y += dt * velocity_[i].y;
    }
  }

 private:
  static constexpr double spacing = 1.9 * radius;
  static inline const double height = std::sqrt(0.75);

  // Disc i and its neighbour a columns and b rows on.
  void add(int i, int a, int b, std::array<PlaneVector, side * side>& force) const {
    const int column = i % side + a, row = i / side + b;
    const int j = (column + side) % side + side * (row % side);
    const double columns = column < 0 ? -side : column >= side ? side : 0, rows = row >= side ? side : 0;
    const double x = position_[j].x + spacing * (columns + rows / 2) - position_[i].x;
    const double y = position_[j].y + spacing * height * rows - position_[i].y;
    const double distance = std::hypot(x, y), nx = x / distance, ny = y / distance;
    const double v_n = (velocity_[i].x - velocity_[j].x) * nx + (velocity_[i].y - velocity_[j].y) * ny;
    const double f_n = normal_force<Effects{}>(parameters_, {2 * radius - distance, v_n, 0, 0});
    force[i].x -= f_n * nx;
    force[i].y -= f_n * ny;
    force[j].x += f_n * nx;
    force[j].y += f_n * ny;
  }

  ContactParameters parameters_;
  std::array<PlaneVector, side * side> position_, velocity_;
};

/// Kinetic energy after 2000 steps over that at the start.
double growth(double steps_of_dashpot) {
  Lattice lattice(steps_of_dashpot);
  const double start = lattice.energy();
  for (int k = 0; k < 2000; ++k) lattice.step();
  return lattice.energy() / start;
}

// z changes by about 1.5 times the change of d, and the energy as z^4000: one per cent beside the limit is
// far from 1 on either side.
TEST(DashpotLimit, OfADensePackingIsTwoThirdsOfThatOfAPair) {
  const double limit = (4 - spring_part) / 2 / 3;  // gamma_n dt/m12
  const double below = growth(0.99 * limit), above = growth(1.01 * limit);
  std::printf("energy after 2000 steps: times %.1e below the limit, %.1e above\n", below, above);
  EXPECT_LT(below, 1);
  EXPECT_GT(above, 1e3);
}

}  // namespace
}  // namespace mikromakro::physics
