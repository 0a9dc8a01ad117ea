// SPDX-License-Identifier: GPL-2.0-or-later
#include "audit/box_balance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "averaging/periodic_images.h"
#include "model/error.h"

namespace mikromakro {
namespace {

const Particle& disc(const Frame& frame, int index) {
  return frame.particles[static_cast<std::size_t>(index)];
}

bool is_bulk(const Particle& particle, const std::vector<int>& bulk_types) {
  return bulk_types.empty() ||
         std::find(bulk_types.begin(), bulk_types.end(), particle.type) != bulk_types.end();
}

// 0 to 3 for left, right, bottom, top; -1 for all others.
int wall_of(const Contact& contact) {
  return contact.id2 <= -1 && contact.id2 >= -box_walls ? static_cast<int>(-contact.id2) - 1 : -1;
}

// Axis of the wall's normal, and whether the wall is at its upper end.
int axis_of(int wall) {
  return wall / 2;
}
bool at_high_end(int wall) {
  return wall % 2 == 1;
}

Eigen::Vector2d contact_point(const Frame& frame, const Contact& contact, bool first) {
  const Particle& self = disc(frame, first ? contact.index1 : contact.index2);
  const double arm = self.radius - (contact.with_wall() ? contact.overlap : 0.5 * contact.overlap);
  return self.position + arm * (first ? 1 : -1) * contact.normal;
}

// Tolerance for a given length compared with that of the box, which LIGGGHTS writes with six digits.
constexpr double digits_of_dumps = 1e-5;

// Counts contacts between averaged discs whose two contact points differ by a periodic shift.
void count_crossings(const Frame& frame, const Contact& contact, const std::vector<int>& bulk_types,
                     BoxLoad& load) {
  if (contact.with_wall() || !is_bulk(disc(frame, contact.index1), bulk_types) ||
      !is_bulk(disc(frame, contact.index2), bulk_types))
    return;
  const Eigen::Vector2d apart = contact_point(frame, contact, true) - contact_point(frame, contact, false);
  for (const std::size_t axis : {0U, 1U}) {
    const auto index = static_cast<Eigen::Index>(axis);
    if (frame.box.periodic[axis] && std::abs(apart[index]) > 0.5 * frame.box.length()[index])
      ++load.crossings[axis];
  }
}

void check_period(const Rectangle& box, const Box& frame_box, Eigen::Index axis) {
  const double period = frame_box.length()[axis];
  if (std::abs(box.size()[axis] - period) <= digits_of_dumps * period) return;
  throw bad_input({"--box"}, "forces cross the periodic boundary, so only the full period is in balance",
                  fmt::format("a length along {} of {} m", axis == 0 ? 'x' : 'y', period),
                  fmt::format("{}", box.size()[axis]));
}

// Whether the rectangle leaves out averaged discs, or puts a wall elsewhere than where its contacts are, by
// more than a hundredth of its side.
bool is_cut(const Frame& frame, const Rectangle& box, const std::vector<int>& bulk_types) {
  constexpr double digits = 1e-9, most = 0.01;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const double length = box.size()[axis];
    if (frame.box.periodic[static_cast<std::size_t>(axis)]) {
      if (length < (1 - digits_of_dumps) * frame.box.length()[axis]) return true;
      continue;
    }
    const auto outside = [&](const Particle& disc) {
      const double place = disc.position[axis];
      return is_bulk(disc, bulk_types) &&
             (place < box.low[axis] - digits * length || place > box.high[axis] + digits * length);
    };
    if (std::any_of(frame.particles.begin(), frame.particles.end(), outside)) return true;
  }
  return std::any_of(frame.contacts.begin(), frame.contacts.end(), [&](const Contact& contact) {
    const int wall = wall_of(contact);
    if (wall < 0) return false;
    const int axis = axis_of(wall);
    const double side = (at_high_end(wall) ? box.high : box.low)[axis];
    return std::abs(contact_point(frame, contact, true)[axis] - side) > most * box.size()[axis];
  });
}

}  // namespace

Rectangle wall_rectangle(const Frame& frame) {
  std::array<double, box_walls> sums = {};
  std::array<int, box_walls> counts = {};
  for (const Contact& contact : frame.contacts) {
    const int wall = wall_of(contact);
    if (wall < 0) continue;
    sums[static_cast<std::size_t>(wall)] += contact_point(frame, contact, true)[axis_of(wall)];
    ++counts[static_cast<std::size_t>(wall)];
  }
  for (std::size_t wall = 0; wall < box_walls; ++wall) {
    const auto axis = axis_of(static_cast<int>(wall));
    const std::size_t pair = wall / 2 * 2;
    if (frame.box.periodic[wall / 2] && counts[pair] + counts[pair + 1] == 0) {
      sums[wall] = (at_high_end(static_cast<int>(wall)) ? frame.box.high : frame.box.low)[axis];
      continue;
    }
    if (counts[wall] == 0)
      throw bad_input({"--box"}, fmt::format("step {} does not say where the walls are", frame.step),
                      "contacts with walls -1, -2, -3, -4, or --box, or --rings",
                      fmt::format("none with {}", -1 - static_cast<int>(wall)));
    sums[wall] /= counts[wall];
  }
  Rectangle box{{sums[0], sums[2]}, {sums[1], sums[3]}};
  if (!(box.size().array() > 0).all())
    throw bad_input({"--box"}, fmt::format("the walls of step {} are not in order", frame.step),
                    "left < right, bottom < top",
                    fmt::format("{} {} {} {}", sums[0], sums[1], sums[2], sums[3]));
  return box;
}

BoxLoad box_load(const Frame& frame, const Rectangle& box, const std::vector<int>& bulk_types) {
  BoxLoad load;
  load.force.fill(Eigen::Vector2d::Zero());
  load.moment.setZero();
  load.periodic = frame.box.periodic;
  load.cut = is_cut(frame, box, bulk_types);
  const Eigen::Vector2d middle = 0.5 * (box.low + box.high);
  for (const Contact& contact : frame.contacts) {
    count_crossings(frame, contact, bulk_types, load);
    for (const bool first : {true, false}) {
      const int self = first ? contact.index1 : contact.index2;
      const int partner = first ? contact.index2 : contact.index1;
      if (self < 0 || !is_bulk(disc(frame, self), bulk_types)) continue;
      if (partner >= 0 && is_bulk(disc(frame, partner), bulk_types)) continue;
      const Eigen::Vector2d force = (first ? 1 : -1) * contact.force;
      ++load.boundary_contacts;
      load.moment += force * (contact_point(frame, contact, first) - middle).transpose();
      const int wall = wall_of(contact);
      if (wall < 0) continue;
      load.force[static_cast<std::size_t>(wall)] += force;
      ++load.wall_contacts[static_cast<std::size_t>(axis_of(wall))];
      load.normal += std::abs(force[axis_of(wall)]);
      load.tangential += std::abs(force[1 - axis_of(wall)]);
    }
  }
  if ((load.crossings[0] > 0) != (load.crossings[1] > 0))
    check_period(box, frame.box, load.crossings[0] > 0 ? 0 : 1);
  return load;
}

double disc_area_inside(const Frame& frame, const Rectangle& box, const std::vector<int>& bulk_types) {
  double squares = 0;
  const PeriodicImages images(frame.box, {box.low, box.high, {}});
  std::vector<Eigen::Vector2d> places;
  for (const Particle& particle : frame.particles) {
    if (!is_bulk(particle, bulk_types)) continue;
    images.of(particle.position, 0, places);
    const auto inside = std::count_if(places.begin(), places.end(), [&](const Eigen::Vector2d& place) {
      return (place.array() >= box.low.array()).all() && (place.array() < box.high.array()).all();
    });
    squares += static_cast<double>(inside) * particle.radius * particle.radius;
  }
  return std::numbers::pi * squares;
}

void BoxBalance::add(const Rectangle& box, double height, const Eigen::Matrix2d& volume_times_stress,
                     const BoxLoad& load) {
  if (frames_ > 0 && load.periodic != periodic_)
    throw bad_input({"--box"}, "the boundaries of the box change", "those of the first frame", "others");
  periodic_ = load.periodic;
  cut_ = cut_ || (load.cut && load.boundary_contacts > 0);
  ++frames_;
  low_ += box.low;
  high_ += box.high;
  volume_ += box.size().prod() * height;
  wall_areas_ += height * box.size().reverse();
  inside_ += volume_times_stress;
  boundary_ += load.moment;
  for (std::size_t wall = 0; wall < box_walls; ++wall) force_[wall] += load.force[wall];
  normal_ += load.normal;
  tangential_ += load.tangential;
  boundary_contacts_ += load.boundary_contacts;
  for (const std::size_t axis : {0U, 1U}) {
    wall_contacts_[axis] += load.wall_contacts[axis];
    crossings_[axis] += load.crossings[axis];
  }
}

Rectangle BoxBalance::box() const {
  const auto count = static_cast<double>(frames_);
  return {low_ / count, high_ / count};
}

WallStress BoxBalance::wall(int number) const {
  const Eigen::Vector2d force = force_[static_cast<std::size_t>(number)];
  const auto count = static_cast<double>(frames_);
  const double area = wall_areas_[axis_of(number)];
  // The outward normal is +1 or -1 along the axis.
  return {force / count, area / count, (at_high_end(number) ? 1 : -1) * force / area};
}

double BoxBalance::pressure() const {
  return std::abs(0.5 * volume_stress().trace());
}

Eigen::Matrix2d BoxBalance::boundary_stress() const {
  Eigen::Matrix2d stress = boundary_ / volume_;
  for (const int axis : {0, 1})
    if (is_open(axis)) stress.col(axis).setConstant(std::numeric_limits<double>::quiet_NaN());
  return stress;
}

bool BoxBalance::is_open(int axis) const {
  const auto index = static_cast<std::size_t>(axis);
  return cut_ || crossings_[index] > 0 || (periodic_[index] && !has_boundary());
}

bool BoxBalance::may_have_wall(int number) const {
  const auto axis = static_cast<std::size_t>(axis_of(number));
  return !periodic_[axis] || wall_contacts_[axis] > 0;
}

double BoxBalance::stress_deviation() const {
  Eigen::Matrix2d difference = volume_stress() - boundary_stress();
  for (const int axis : {0, 1})
    if (is_open(axis)) difference.col(axis).setZero();
  return difference.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() / pressure();
}

double BoxBalance::wall_deviation() const {
  double largest = 0;
  for (int number = 0; number < box_walls; ++number) {
    if (!may_have_wall(number)) continue;
    const int axis = axis_of(number);
    largest = std::max(largest, std::abs(wall(number).stress[axis] - volume_stress()(axis, axis)));
  }
  return largest / pressure();
}

double BoxBalance::wall_residual() const {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double magnitudes = 0;
  int walls = 0;
  for (int number = 0; number < box_walls; ++number) {
    if (!may_have_wall(number)) continue;
    sum += force_[static_cast<std::size_t>(number)];
    magnitudes += force_[static_cast<std::size_t>(number)].norm();
    ++walls;
  }
  return sum.norm() / (magnitudes / walls);
}

}  // namespace mikromakro
