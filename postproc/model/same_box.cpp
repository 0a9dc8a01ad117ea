// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/same_box.h"

#include <fmt/format.h>

#include <cmath>

namespace mikromakro {

bool jumps(const Box& before, const Box& after) {
  constexpr double part = 0.1;
  const Eigen::Array2d change = (before.length() - after.length()).array().abs();
  for (Eigen::Index axis = 0; axis < 2; ++axis)
    if (!after.wrapped[static_cast<std::size_t>(axis)] && change[axis] > part * before.length()[axis])
      return true;
  return false;
}

bool is_another(const Box& before, const Box& after) {
  const Eigen::Array2d ratio = after.length().array() / before.length().array();
  constexpr double most = 2;
  for (Eigen::Index axis = 0; axis < 2; ++axis)
    if (after.periodic[static_cast<std::size_t>(axis)] && (ratio[axis] > most || ratio[axis] < 1 / most))
      return true;
  return false;
}

void check_box(const Box& box, const Place& place) {
  const Eigen::Vector2d length = box.length();
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const bool periodic = box.periodic[static_cast<std::size_t>(axis)];
    if (length[axis] > 0 || (length[axis] == 0 && !periodic)) continue;
    throw bad_input(place, fmt::format("the box has no width along {}", axis == 0 ? 'x' : 'y'),
                    periodic ? "a length > 0 of a periodic box" : "bounds in ascending order",
                    fmt::format("{:.9g} to {:.9g}", box.low[axis], box.high[axis]));
  }
}

void check_same_box(const Box& of_particles, const Box& of_contacts, const Place& place) {
  const Box &one = of_particles, &other = of_contacts;
  constexpr double digits = 1e-5;  // of the less precise of the two formats
  const double allowed = digits * one.length().norm();
  const double apart = std::fmax((one.low - other.low).lpNorm<Eigen::Infinity>(),
                                 (one.high - other.high).lpNorm<Eigen::Infinity>());
  const bool boundaries_differ =
      one.boundaries_known && other.boundaries_known && one.periodic != other.periodic;
  if (!(apart > allowed) && !boundaries_differ) return;
  const auto text = [](const Box& box) {
    const auto axis = [&](Eigen::Index i) {
      const auto bounds = fmt::format("{:.9g} {:.9g}", box.low[i], box.high[i]);
      return box.boundaries_known ? bounds + ' ' + box.boundary(static_cast<std::size_t>(i)) : bounds;
    };
    return axis(0) + ' ' + axis(1);
  };
  throw bad_input(place, "the box is not that of the particles (another run?)", text(one), text(other));
}

}  // namespace mikromakro
