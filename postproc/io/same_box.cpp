#include "io/same_box.h"

#include <fmt/format.h>

#include <cmath>

namespace mikromakro {

bool jumps(const Box& before, const Box& after) {
  constexpr double tenth = 0.1;
  return ((before.length() - after.length()).array().abs() > tenth * before.length().array()).any();
}

void check_same_box(const Box& of_particles, const Box& of_contacts, const Place& place) {
  const Box &one = of_particles, &other = of_contacts;
  constexpr double digits = 1e-5;  // of the shorter of both formats
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
