// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/scene_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "drawing/disc_quantity.h"

namespace mikromakro {
namespace {

constexpr SceneColumn of_discs[] = {
    {"x", "m", 16},    {"y", "m", 16},        {"radius", "m", 16},    {"vx", "m/s", 16},
    {"vy", "m/s", 16}, {"spin", "rad/s", 16}, {"type", "", 16, true}, {"pressure", "Pa", 16},
};
constexpr SceneColumn of_contacts[] = {
    {"angle", "rad", 12}, {"overlap", "m", 12}, {"normal_force", "N", 16}, {"tangential_force", "N", 14}};

// The order that sorts by `key`.
template <typename Key>
std::vector<std::size_t> order_by(std::size_t count, const Key& key) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  return order;
}

double wrapped(double x, const Box& box, Eigen::Index axis) {
  const double length = box.high[axis] - box.low[axis];
  if (!box.periodic[static_cast<std::size_t>(axis)]) return x;
  return x - length * std::floor((x - box.low[axis]) / length);
}

std::vector<double> pressures(const Frame& frame, double height) {
  if (!frame.contacts_known) return std::vector<double>(frame.particles.size(), not_given);
  return disc_values(frame, DiscQuantity::pressure, height);
}

void add_discs(const Frame& frame, double height, const std::vector<std::size_t>& order, SceneFrame& scene) {
  const std::vector<double> pressure = pressures(frame, height);
  scene.discs.resize(std::size(of_discs));
  for (const std::size_t i : order) {
    const Particle& disc = frame.particles[i];
    scene.ids.push_back(disc.id);
    const double values[] = {wrapped(disc.position.x(), frame.box, 0),
                             wrapped(disc.position.y(), frame.box, 1),
                             disc.radius,
                             disc.velocity.x(),
                             disc.velocity.y(),
                             disc.spin,
                             static_cast<double>(disc.type),
                             pressure[i]};
    for (std::size_t column = 0; column < std::size(values); ++column)
      scene.discs[column].push_back(values[column]);
  }
}

void add_contact(const Contact& contact, SceneFrame& scene) {
  const Eigen::Vector2d tangent(-contact.normal.y(), contact.normal.x());
  const double angle = std::atan2(contact.normal.y(), contact.normal.x());
  const double values[] = {angle < 0 ? angle + 2 * std::numbers::pi : angle, contact.overlap,
                           -contact.force.dot(contact.normal), contact.force.dot(tangent)};
  for (std::size_t column = 0; column < std::size(values); ++column)
    scene.contacts[column].push_back(values[column]);
}

}  // namespace

std::span<const SceneColumn> disc_scene_columns() {
  return of_discs;
}

std::span<const SceneColumn> contact_scene_columns() {
  return of_contacts;
}

SceneFrame scene_frame(const Frame& frame, double height) {
  SceneFrame scene;
  const auto order = order_by(frame.particles.size(), [&](std::size_t i) { return frame.particles[i].id; });
  add_discs(frame, height, order, scene);
  std::vector<std::uint32_t> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = static_cast<std::uint32_t>(i);
  const auto ends = [&](std::size_t i) {
    const Contact& contact = frame.contacts[i];
    constexpr std::int64_t wall_0 = std::numeric_limits<std::uint32_t>::max();
    const auto second = contact.with_wall() ? static_cast<std::uint32_t>(wall_0 + contact.id2)
                                            : place[static_cast<std::size_t>(contact.index2)];
    return std::pair(place[static_cast<std::size_t>(contact.index1)], second);
  };
  scene.contacts.resize(std::size(of_contacts));
  for (const std::size_t i : order_by(frame.contacts.size(), ends)) {
    scene.first.push_back(ends(i).first);
    scene.second.push_back(ends(i).second);
    add_contact(frame.contacts[i], scene);
  }
  return scene;
}

}  // namespace mikromakro
