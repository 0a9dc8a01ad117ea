// SPDX-License-Identifier: GPL-2.0-or-later
// Random sequential placement of discs without overlaps: each disc is tried at uniformly random positions
// until it touches nothing; large discs come first because they are the hardest to place. Deterministic from
// the seed on every platform: standard-library distributions differ between implementations, so the mapping
// to doubles is our own.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "physics/math/plane_vector.h"
#include "physics/placement/disc_grid.h"
#include "physics/placement/disc_region.h"

namespace mikromakro::physics {

class UniformNumbers {
 public:
  explicit UniformNumbers(std::uint64_t seed) : engine_(seed) {}
  // Uniform in [low, high): the upper 53 bits of the 64-bit Mersenne twister, whose output the standard
  // specifies exactly.
  double operator()(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }

 private:
  std::mt19937_64 engine_;
};

// Solid fraction above which placement is refused: random sequential placement of equal discs jams at 0.547
// (Feder 1980) and needs very many trials per disc close to that limit.
inline constexpr double placement_limit = 0.5;
inline constexpr long placement_trials = 200000;

// Places discs of the given radii (m) in the region, without touching the obstacles and at least `gap` away
// from the region's border. Returns the discs in the order of `radii`. Throws std::runtime_error if a disc
// cannot be placed within `placement_trials` trials.
inline std::vector<PlacedDisc> place_discs(const DiscRegion& region, const std::vector<double>& radii,
                                           double gap, const std::vector<PlacedDisc>& obstacles,
                                           UniformNumbers& uniform) {
  double largest = 0.0;
  for (const double radius : radii) largest = std::max(largest, radius);
  for (const PlacedDisc& obstacle : obstacles) largest = std::max(largest, obstacle.radius);
  const Rectangle bounds = bounds_of(region);
  DiscGrid grid(bounds, largest);
  for (const PlacedDisc& obstacle : obstacles) grid.add(obstacle);

  std::vector<std::size_t> order(radii.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) { return radii[i]; });

  const auto place_one = [&](double radius) {
    for (long trial = 0; trial < placement_trials; ++trial) {
      // Two statements, because the evaluation order of function arguments is unspecified.
      const double x = uniform(bounds.x_min, bounds.x_max);
      const double y = uniform(bounds.y_min, bounds.y_max);
      const PlacedDisc disc{x, y, radius};
      if (contains_disc(region, x, y, radius + gap) && !grid.touches(disc)) return disc;
    }
    throw std::runtime_error("no room left for a disc of radius " + std::to_string(radius));
  };
  std::vector<PlacedDisc> placed(radii.size());
  for (const std::size_t i : order) {
    placed[i] = place_one(radii[i]);
    grid.add(placed[i]);
  }
  return placed;
}

// A velocity uniform in the disc of radius `largest` (m/s).
inline PlaneVector random_velocity(double largest, UniformNumbers& uniform) {
  while (true) {
    const double x = uniform(-1.0, 1.0);
    const double y = uniform(-1.0, 1.0);
    if (x * x + y * y <= 1.0) return {largest * x, largest * y};
  }
}

}  // namespace mikromakro::physics
