// SPDX-License-Identifier: GPL-2.0-or-later
// Packings in a periodic box, and what is the same without one: the discs many times, side by side.
#pragma once

#include <cmath>
#include <random>

#include "ring_average.h"

namespace mikromakro {

/// Discs of radii 0.2 to 0.35 at random places in a box that is periodic along the given axes, with random
/// velocities, spins, forces and springs, and a contact for each pair of images that overlap. Along other
/// axes nothing reaches beyond the box.
inline Frame periodic_packing(const Box& box, int discs, std::uint64_t seed = 7) {
  Frame frame;
  frame.box = box;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < discs; ++i) {
    const double radius = 0.275 + 0.075 * uniform(random);
    Eigen::Vector2d place;
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      const double room =
          0.5 * box.length()[axis] - (box.periodic[static_cast<std::size_t>(axis)] ? 0 : radius);
      place[axis] = 0.5 * (box.low + box.high)[axis] + room * uniform(random);
    }
    frame.particles.push_back(make_disc(i + 1, place, radius, i % 5 == 0 ? 2 : 1));
    frame.particles.back().velocity = {uniform(random), uniform(random)};
    frame.particles.back().spin = uniform(random);
  }
  for (int i = 0; i < discs; ++i) {
    for (int j = i + 1; j < discs; ++j) {
      Frame pair;
      pair.particles = {frame.particles[static_cast<std::size_t>(i)],
                        frame.particles[static_cast<std::size_t>(j)]};
      Eigen::Vector2d& there = pair.particles[1].position;
      for (Eigen::Index axis = 0; axis < 2; ++axis) {
        const double length = box.length()[axis];
        const double apart = there[axis] - pair.particles[0].position[axis];
        if (box.periodic[static_cast<std::size_t>(axis)]) there[axis] -= length * std::round(apart / length);
      }
      Contact contact = make_contact(pair, 0, 1, 50);
      if (!(contact.overlap > 0)) continue;
      contact.index1 = i;
      contact.index2 = j;
      contact.force += Eigen::Vector2d(uniform(random), uniform(random));
      contact.spring = 0.1 * uniform(random);
      frame.contacts.push_back(contact);
    }
  }
  return frame;
}

/// The packing moved by `shift`, its discs brought back into the box.
inline Frame moved(Frame frame, const Eigen::Vector2d& shift) {
  for (Particle& particle : frame.particles) {
    particle.position += shift;
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      const double length = frame.box.length()[axis];
      const double from = particle.position[axis] - frame.box.low[axis];
      if (frame.box.periodic[static_cast<std::size_t>(axis)])
        particle.position[axis] -= length * std::floor(from / length);
    }
  }
  return frame;
}

/// The packing without periodic boundaries, with all images k = -around ... around along periodic axes.
/// Contacts that lead out of all copies are left out.
inline Frame copied(const Frame& frame, int around) {
  Frame all = frame;
  all.box.periodic = {false, false};
  all.particles.clear();
  all.contacts.clear();
  const Eigen::Vector2d length = frame.box.length();
  const int columns = frame.box.periodic[0] ? around : 0;
  const int rows = frame.box.periodic[1] ? around : 0;
  const int discs = static_cast<int>(frame.particles.size());
  const auto index_of = [&](int k_x, int k_y, int disc) {
    return ((k_y + rows) * (2 * columns + 1) + k_x + columns) * discs + disc;
  };
  for (int k_y = -rows; k_y <= rows; ++k_y) {
    for (int k_x = -columns; k_x <= columns; ++k_x) {
      for (Particle particle : frame.particles) {
        particle.id += index_of(k_x, k_y, 0);
        particle.position += Eigen::Vector2d(k_x * length.x(), k_y * length.y());
        all.particles.push_back(particle);
      }
      for (Contact contact : frame.contacts) {
        const Particle& one = frame.particles[static_cast<std::size_t>(contact.index1)];
        const Particle& two = frame.particles[static_cast<std::size_t>(contact.index2)];
        const Eigen::Vector2d end =
            one.position + (one.radius + two.radius - contact.overlap) * contact.normal;
        const int there_x = k_x + static_cast<int>(std::lround((end - two.position).x() / length.x()));
        const int there_y = k_y + static_cast<int>(std::lround((end - two.position).y() / length.y()));
        if (std::abs(there_x) > columns || std::abs(there_y) > rows) continue;
        contact.index1 = index_of(k_x, k_y, contact.index1);
        contact.index2 = index_of(there_x, there_y, contact.index2);
        contact.id1 = all.particles[0].id + contact.index1;
        contact.id2 = all.particles[0].id + contact.index2;
        all.contacts.push_back(contact);
      }
    }
  }
  return all;
}

}  // namespace mikromakro
