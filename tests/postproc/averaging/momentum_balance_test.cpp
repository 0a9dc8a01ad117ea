// SPDX-License-Identifier: GPL-2.0-or-later
// What kernels promise: momentum balances, up to the walls, and fields linear in space are met.
#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Cholesky>
#include <memory>
#include <random>

#include "averaging/volumes/grid_volumes.h"
#include "measured_error.h"
#include "ring_average.h"

namespace mikromakro {
namespace {

// 25 discs at random near the sites of a square lattice in the box (0, 5)^2, in contact (or nearly: forces
// are not those of a law here) with their neighbours, three walls, and wall discs (type 2) along the top.
Frame random_packing() {
  constexpr int side = 5;
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Frame frame;
  for (int j = 0; j <= side; ++j) {
    for (int i = 0; i < side; ++i) {
      const Eigen::Vector2d jitter{0.15 * uniform(random), 0.15 * uniform(random)};
      frame.particles.push_back(make_disc(1 + static_cast<std::int64_t>(frame.particles.size()),
                                          Eigen::Vector2d(i + 0.5, j + 0.5) + jitter,
                                          0.5 + 0.05 * uniform(random), j == side ? 2 : 1));
    }
  }
  const auto add_wall = [&](int disc, int wall, const Eigen::Vector2d& normal, double distance) {
    const Particle& particle = frame.particles[static_cast<std::size_t>(disc)];
    frame.contacts.push_back({particle.id, wall, disc, -1, normal, particle.radius - distance, {0, 0}, 0});
  };
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const int disc = j * side + i;
      const Eigen::Vector2d& at = frame.particles[static_cast<std::size_t>(disc)].position;
      if (i + 1 < side) frame.contacts.push_back(make_contact(frame, disc, disc + 1, 0));
      frame.contacts.push_back(make_contact(frame, disc, disc + side, 0));
      if (i == 0) add_wall(disc, -1, {-1, 0}, at[0]);
      if (i == side - 1) add_wall(disc, -2, {1, 0}, side - at[0]);
      if (j == 0) add_wall(disc, -3, {0, -1}, at[1]);
    }
  }
  return frame;
}

// Random forces (normal and tangential), and the smallest change of them that puts every disc of type 1 into
// equilibrium: f - N^T (N N^T)^-1 N f with N the signs of contacts on discs.
Frame balanced_packing() {
  Frame frame = random_packing();
  std::mt19937_64 random(12);
  std::normal_distribution<double> normal;
  const auto contacts = static_cast<Eigen::Index>(frame.contacts.size());
  Eigen::MatrixXd signs = Eigen::MatrixXd::Zero(25, contacts);
  Eigen::MatrixXd forces(contacts, 2);
  for (Eigen::Index c = 0; c < contacts; ++c) {
    const Contact& contact = frame.contacts[static_cast<std::size_t>(c)];
    signs(contact.index1, c) = 1;
    if (contact.index2 >= 0 && contact.index2 < 25) signs(contact.index2, c) = -1;
    forces.row(c) << normal(random), normal(random);
  }
  forces -= signs.transpose() * (signs * signs.transpose()).ldlt().solve(signs * forces);
  for (Eigen::Index c = 0; c < contacts; ++c)
    frame.contacts[static_cast<std::size_t>(c)].force = forces.row(c).transpose();
  return frame;
}

// div sigma + t of the average over a cell; the divergence by differences of cells shifted by h to either
// side, Pa/m.
class Balance {
 public:
  explicit Balance(const std::string& weight) : weight_(weight) {}

  VolumeAverage average(const Eigen::Vector2d& corner) const {
    const std::vector<double> x = {corner[0], corner[0] + 0.7};
    const std::vector<double> y = {corner[1], corner[1] + 0.9};
    AverageSetup setup;
    setup.weight = weight_;
    setup.options.bulk_types = {1};
    setup.fields = {"stress", "wall_force_density"};
    return {frame_, std::make_unique<const GridVolumes>(x, y, 0.5), setup};
  }

  Eigen::Vector2d wall_force(const Eigen::Vector2d& corner) const {
    const VolumeAverage at = average(corner);
    return {at.at("wall_force_density_x"), at.at("wall_force_density_y")};
  }

  Eigen::Vector2d divergence(const Eigen::Vector2d& corner, double h) const {
    const auto difference = [&](const std::string& component, const Eigen::Vector2d& axis) {
      return (average(corner + h * axis).at(component) - average(corner - h * axis).at(component)) / (2 * h);
    };
    const Eigen::Vector2d e_x{1, 0};
    const Eigen::Vector2d e_y{0, 1};
    return {difference("sigma_xx", e_x) + difference("sigma_xy", e_y),
            difference("sigma_yx", e_x) + difference("sigma_yy", e_y)};
  }

 private:
  std::string weight_;
  Frame frame_ = balanced_packing();
};

class StaticPacking : public testing::TestWithParam<std::string> {
 protected:
  // Cells at three walls, at the wall discs, in a corner and half outside, and one in the middle.
  const std::vector<Eigen::Vector2d> corners = {{0.1, 2}, {4.1, 1.7},   {2.3, 0.2},
                                                {2, 4},   {-0.3, -0.2}, {2.1, 2.2}};
};
INSTANTIATE_TEST_SUITE_P(Weights, StaticPacking, testing::Values("gauss:0.7", "lucy:1.6", "wendland:1.6"),
                         [](const auto& each) { return each.param.substr(0, each.param.find(':')); });

// Richardson's extrapolation of differences with h, h/2, h/4 leaves next to nothing. What remains is the
// quadrature of the branches, 1e-8 of their shares, but steeper where a compact kernel ends between two
// points. Stresses and forces are of size 1.
TEST_P(StaticPacking, BalancesUpToTheWalls) {
  const Balance balance(GetParam());
  double largest = 0;
  for (const Eigen::Vector2d& corner : corners) {
    constexpr double h = 0.02;
    const Eigen::Vector2d rough = balance.divergence(corner, h);
    const Eigen::Vector2d middle = balance.divergence(corner, h / 2);
    const Eigen::Vector2d fine = balance.divergence(corner, h / 4);
    const Eigen::Vector2d first = (4 * middle - rough) / 3;
    const Eigen::Vector2d second = (4 * fine - middle) / 3;
    const Eigen::Vector2d residual = (16 * second - first) / 15 + balance.wall_force(corner);
    for (const double component : residual)
      expect_measured(component, 0, GetParam().starts_with("gauss") ? 1e-8 : 1e-6);
    largest = std::fmax(largest, balance.wall_force(corner).norm());
  }
  EXPECT_GT(largest, 0.1);
}

// Without extrapolation the residual is that of the differences: order 2, next order 1 % at this h.
TEST_P(StaticPacking, ResidualOfDifferencesIsOfSecondOrder) {
  const Balance balance(GetParam());
  for (const Eigen::Vector2d& corner : corners) {
    const Eigen::Vector2d t = balance.wall_force(corner);
    const double rough = (balance.divergence(corner, 0.1) + t).norm();
    const double fine = (balance.divergence(corner, 0.05) + t).norm();
    EXPECT_NEAR(rough / fine, 4, 0.2);
  }
}

// A square lattice of discs of spacing 1, as far as kernels reach, with velocities linear in space.
Frame linear_lattice(int half) {
  Frame frame;
  for (int j = -half; j <= half; ++j) {
    for (int i = -half; i <= half; ++i) {
      frame.particles.push_back(
          make_disc(1 + static_cast<std::int64_t>(frame.particles.size()), {i, j}, 0.5));
      frame.particles.back().velocity = {0.3 + 0.2 * i - 0.1 * j, 1 - 0.05 * i + 0.4 * j};
    }
  }
  return frame;
}

// Largest error of nu = pi/4 and of the velocity at the middle of cells of sides 0.3 in many places.
double lattice_error(const std::string& weight, int half) {
  std::vector<double> edges;
  for (int i = 0; i <= 8; ++i) edges.push_back(-1.13 + 0.3 * i);
  const VolumeAverage average(linear_lattice(half), std::make_unique<const GridVolumes>(edges, edges, 1),
                              {weight, {}, {"solid_fraction", "velocity"}, {}});
  double largest = 0;
  for (int cell = 0; cell < 64; ++cell) {
    const double x = average.at("x", cell);
    const double y = average.at("y", cell);
    largest = std::fmax(largest, std::abs(average.at("nu", cell) * 4 / std::numbers::pi - 1));
    largest = std::fmax(largest, std::abs(average.at("v_x", cell) - (0.3 + 0.2 * x - 0.1 * y)));
    largest = std::fmax(largest, std::abs(average.at("v_y", cell) - (1 - 0.05 * x + 0.4 * y)));
  }
  return largest;
}

// Poisson's sum: a lattice of spacing 1 sees the Fourier transform of a kernel at 2 pi and beyond, exp(-2
// pi^2 W^2) for Gauss: 5e-20 for W = 1.5. What remains are the 2e-11 beyond the reach.
TEST(LinearFields, AreMetByAGaussOnALattice) {
  expect_measured(lattice_error("gauss:1.5", 14), 0, 1e-10);
  // 4 exp(-2 pi^2 0.6^2) of nu, and derivatives of it of the velocity
  const double coarse = lattice_error("gauss:0.6", 8);
  EXPECT_GT(coarse, 1e-3 / 2);
  EXPECT_LT(coarse, 1e-2);
}

// Mean over a period of the waves of the Fourier transform, of the largest error over the width: the
// velocity's scale.
double mean_error(const std::string& kernel, double width) {
  double sum = 0;
  for (const double more : {0.0, 0.2, 0.4, 0.6, 0.8})
    sum += lattice_error(fmt::format("{}:{}", kernel, width + more), 20) / (5 * (width + more));
  return sum;
}

// Fourier transforms fall as k^(-m - 3/2) where the kernel ends as (1 - q)^m: m = 3, 4 and 0. By that power
// errors fall when the kernel grows.
TEST(LinearFields, ErrorsOnALatticeHaveTheOrderOfTheKernel) {
  const auto order = [](const std::string& kernel) {
    return std::log2(mean_error(kernel, 8) / mean_error(kernel, 16));
  };
  EXPECT_NEAR(order("lucy"), 4.5, 0.4);
  EXPECT_NEAR(order("wendland"), 5.5, 0.4);
  EXPECT_NEAR(order("tophat"), 1.5, 0.4);
}

}  // namespace
}  // namespace mikromakro
