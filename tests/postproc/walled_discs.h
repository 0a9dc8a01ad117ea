// SPDX-License-Identifier: GPL-2.0-or-later
// Discs whose contacts with walls are given number by number, in one ring: values of fields by hand.
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "ring_average.h"

namespace mikromakro {

/// Volume of the ring of whole_ring(): pi 20^2 times the height 0.5; a disc of radius 2 is a hundredth of it.
inline constexpr double ring_volume = 200 * std::numbers::pi;
/// A few terms of size 1 to 10.
inline constexpr double few_roundings = 1e-14;

inline RingSetup whole_ring(const std::vector<std::string>& fields) {
  RingSetup setup;
  setup.edges = {0, 20};
  setup.height = 0.5;
  setup.fields = fields;
  return setup;
}

/// Normal outward, force on the disc, spring: the slip along t = (-n_y, n_x).
struct WallContact {
  Eigen::Vector2d normal;
  Eigen::Vector2d force{0, 0};
  double overlap = 0.1;
  double spring = 0;
};

/// The position (10, 0) has e_r = e_x, e_phi = e_y.
inline Particle& add_disc(Frame& frame, const Eigen::Vector2d& position, double radius,
                          const std::vector<WallContact>& walls = {}) {
  const int index = static_cast<int>(frame.particles.size());
  frame.particles.push_back(make_disc(index + 1, position, radius));
  for (const WallContact& wall : walls) {
    Contact contact;
    contact.id1 = index + 1;
    contact.index1 = index;
    contact.normal = wall.normal;
    contact.force = wall.force;
    contact.overlap = wall.overlap;
    contact.spring = wall.spring;
    frame.contacts.push_back(contact);
  }
  return frame.particles.back();
}

/// One disc of radius 2 at (10, 0): its branches to walls are 2 n.
inline Frame disc_between_walls(const std::vector<WallContact>& walls) {
  Frame frame;
  add_disc(frame, {10, 0}, 2, walls);
  return frame;
}

}  // namespace mikromakro
