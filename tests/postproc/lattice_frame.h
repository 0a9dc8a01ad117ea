// SPDX-License-Identifier: GPL-2.0-or-later
// A patch of a triangular lattice of discs, deformed by a given gradient.
#pragma once

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "ring_average.h"

namespace mikromakro {

/// Discs of radius a at gradient * (i e_1 + j e_2), e_1 = (d, 0), e_2 = (d/2, sqrt(3) d/2), all lattice sites
/// up to `shells` steps from the origin; the outermost shell has type 2 (wall discs), so that every disc of
/// type 1 has six contacts.
struct LatticeSetup {
  double radius = 1;
  double spacing = 2;
  double k_n = 1;
  int shells = 3;
  Eigen::Matrix2d gradient = Eigen::Matrix2d::Identity();
};

inline Frame make_lattice(const LatticeSetup& setup) {
  Frame frame;
  std::vector<std::pair<int, int>> sites;
  for (int i = -setup.shells; i <= setup.shells; ++i) {
    for (int j = -setup.shells; j <= setup.shells; ++j) {
      const int shell = (std::abs(i) + std::abs(j) + std::abs(i + j)) / 2;
      if (shell > setup.shells) continue;
      const Eigen::Vector2d site =
          setup.spacing * Eigen::Vector2d(i + 0.5 * j, 0.5 * std::numbers::sqrt3 * j);
      sites.emplace_back(i, j);
      // ids with gaps
      frame.particles.push_back(make_disc(10 + 7 * static_cast<std::int64_t>(sites.size()),
                                          setup.gradient * site, setup.radius,
                                          shell == setup.shells ? 2 : 1));
    }
  }
  for (int p = 0; p < static_cast<int>(sites.size()); ++p) {
    for (int q = p + 1; q < static_cast<int>(sites.size()); ++q) {
      const int i = sites[static_cast<std::size_t>(q)].first - sites[static_cast<std::size_t>(p)].first;
      const int j = sites[static_cast<std::size_t>(q)].second - sites[static_cast<std::size_t>(p)].second;
      if ((std::abs(i) + std::abs(j) + std::abs(i + j)) / 2 == 1)
        frame.contacts.push_back(make_contact(frame, p, q, setup.k_n));
    }
  }
  return frame;
}

/// Number of discs of type 1: 1 + 6 + 12 + ...
inline int lattice_bulk_discs(const LatticeSetup& setup) {
  return 1 + 3 * setup.shells * (setup.shells - 1);
}

}  // namespace mikromakro
