#include "audit/box_balance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/error.h"

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

// The axis along which the wall's normal points, and the end of it where the wall is.
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
  const Eigen::Vector2d middle = 0.5 * (box.low + box.high);
  for (const Contact& contact : frame.contacts) {
    for (const bool first : {true, false}) {
      const int self = first ? contact.index1 : contact.index2;
      const int partner = first ? contact.index2 : contact.index1;
      if (self < 0 || !is_bulk(disc(frame, self), bulk_types)) continue;
      if (partner >= 0 && is_bulk(disc(frame, partner), bulk_types)) continue;
      const Eigen::Vector2d force = (first ? 1 : -1) * contact.force;
      load.moment += force * (contact_point(frame, contact, first) - middle).transpose();
      const int wall = wall_of(contact);
      if (wall < 0) continue;
      load.force[static_cast<std::size_t>(wall)] += force;
      load.normal += std::abs(force[axis_of(wall)]);
      load.tangential += std::abs(force[1 - axis_of(wall)]);
    }
  }
  return load;
}

double disc_area_inside(const Frame& frame, const Rectangle& box, const std::vector<int>& bulk_types) {
  double squares = 0;
  for (const Particle& particle : frame.particles) {
    const bool inside = (particle.position.array() >= box.low.array()).all() &&
                        (particle.position.array() < box.high.array()).all();
    if (inside && is_bulk(particle, bulk_types)) squares += particle.radius * particle.radius;
  }
  return std::numbers::pi * squares;
}

void BoxBalance::add(const Rectangle& box, double height, const Eigen::Matrix2d& volume_times_stress,
                     const BoxLoad& load) {
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

double BoxBalance::stress_deviation() const {
  return (volume_stress() - boundary_stress()).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() / pressure();
}

double BoxBalance::wall_deviation() const {
  double largest = 0;
  for (int number = 0; number < box_walls; ++number) {
    const int axis = axis_of(number);
    largest = std::max(largest, std::abs(wall(number).stress[axis] - volume_stress()(axis, axis)));
  }
  return largest / pressure();
}

double BoxBalance::wall_residual() const {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double magnitudes = 0;
  for (const Eigen::Vector2d& force : force_) {
    sum += force;
    magnitudes += force.norm();
  }
  return sum.norm() / (magnitudes / box_walls);
}

}  // namespace mikromakro
