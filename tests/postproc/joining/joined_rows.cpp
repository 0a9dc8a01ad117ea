// SPDX-License-Identifier: GPL-2.0-or-later
#include "joining/joined_rows.h"

#include <cmath>

#include "model/error.h"

namespace mikromakro {

void add_row(ContactRows& rows, const std::vector<Value>& values) {
  ContactRow row;
  row.value.fill(std::nan(""));
  for (const Value& value : values) {
    row.value[static_cast<std::size_t>(value.column)] = value.value;
    rows.given |= column_bit(value.column);
  }
  rows.rows.push_back(row);
}

Particle disc(std::int64_t id, double x, double y, double radius) {
  Particle particle;
  particle.id = id;
  particle.position = {x, y};
  particle.radius = radius;
  return particle;
}

Box box_of_ten(bool periodic) {
  return {{0, 0}, {10, 10}, {periodic, false}};
}

const std::vector<Particle>& two_discs() {
  static const std::vector<Particle> discs = {disc(900, 1, 1, 0.5), disc(4, 1.75, 2, 1)};
  return discs;
}

std::vector<Contact> join_all(const ContactRows& rows, const std::vector<Particle>& particles, const Box& box,
                              const ContactRules& rules) {
  const IdMap ids(particles);
  return join_contacts(rows, {particles, ids, box}, rules);
}

Contact join_one(const ContactRows& rows, const std::vector<Particle>& particles, const Box& box) {
  return join_all(rows, particles, box).at(0);
}

std::string refusal(const std::vector<Value>& row, const std::vector<Particle>& particles, bool periodic_box,
                    bool distant) {
  ContactRows rows;
  rows.file = "c";
  rows.first_line = 10;
  add_row(rows, row);
  try {
    join_all(rows, particles, box_of_ten(periodic_box), {distant});
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace mikromakro
