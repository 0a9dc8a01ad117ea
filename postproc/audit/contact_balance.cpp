// SPDX-License-Identifier: GPL-2.0-or-later
#include "audit/contact_balance.h"

#include <algorithm>
#include <limits>

#include "averaging/periodic_images.h"
#include "fields/cross_product.h"

namespace mikromakro {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool contains(const std::vector<int>& types, int type) {
  return std::find(types.begin(), types.end(), type) != types.end();
}

const Particle& disc(const Frame& frame, int index) {
  return frame.particles[static_cast<std::size_t>(index)];
}

}  // namespace

bool ContactBalance::is_bulk(const Frame& frame, int particle) const {
  if (particle < 0) return false;
  const int type = disc(frame, particle).type;
  return options_.bulk_types.empty() ? !contains(options_.wheel_types, type)
                                     : contains(options_.bulk_types, type);
}

bool ContactBalance::is_wheel(const Frame& frame, const Contact& contact, int particle) const {
  if (particle < 0) return contact.id2 == 0;
  return contains(options_.wheel_types, disc(frame, particle).type);
}

// The image nearest to the wheel's centre along each axis, within half a period on either side.
Eigen::Vector2d ContactBalance::nearest_image(const Box& box, const Eigen::Vector2d& place) const {
  const Eigen::Vector2d half = 0.5 * box.length();
  std::vector<Eigen::Vector2d> images;
  PeriodicImages(box, {options_.centre - half, options_.centre + half, {}}).of(place, 0, images);
  return images.front();
}

double ContactBalance::torque_on_wheel(const Frame& frame, const Contact& contact, bool bulk_is_first) {
  const double side = bulk_is_first ? 1 : -1;
  const Particle& bulk = disc(frame, bulk_is_first ? contact.index1 : contact.index2);
  const double arm = bulk.radius - (contact.with_wall() ? contact.overlap : 0.5 * contact.overlap);
  const Eigen::Vector2d point =
      nearest_image(frame.box, bulk.position) - options_.centre + arm * side * contact.normal;
  return cross(point, -side * contact.force);
}

void ContactBalance::add(const Frame& frame) {
  ++frames_;
  std::vector<Eigen::Vector2d> sums(frame.particles.size(), Eigen::Vector2d::Zero());
  std::vector<bool> touched(frame.particles.size(), false);
  for (const Contact& contact : frame.contacts) {
    for (const bool first : {true, false}) {
      const int self = first ? contact.index1 : contact.index2;
      if (!is_bulk(frame, self)) continue;
      sums[static_cast<std::size_t>(self)] += (first ? 1 : -1) * contact.force;
      touched[static_cast<std::size_t>(self)] = true;
      force_ += contact.force.norm();
      ++contacts_;
      if (!is_wheel(frame, contact, first ? contact.index2 : contact.index1)) continue;
      torque_ += torque_on_wheel(frame, contact, first);
      ++wheel_contacts_;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (!touched[i]) continue;
    residual_ += sums[i].norm();
    ++discs_;
  }
}

double ContactBalance::wheel_torque() const {
  return wheel_contacts_ == 0 ? nan : torque_ / static_cast<double>(frames_);
}

double ContactBalance::force_residual() const {
  if (contacts_ == 0) return nan;
  return residual_ / static_cast<double>(discs_) / (force_ / static_cast<double>(contacts_));
}

}  // namespace mikromakro
