// SPDX-License-Identifier: GPL-2.0-or-later
// Rows of contacts, and what joining them to discs gives or says.
#pragma once

#include <string>
#include <vector>

#include "joining/contact_geometry.h"

namespace mikromakro {

struct Value {
  ContactColumn column;
  double value;
};

void add_row(ContactRows& rows, const std::vector<Value>& values);

Particle disc(std::int64_t id, double x, double y, double radius);

Box box_of_ten(bool periodic);

/// Discs 900 and 4: 0.5 + 1 - 1.25 = 0.25 overlap along (0.6, 0.8); all numbers are exact in binary or
/// rounded once.
const std::vector<Particle>& two_discs();

std::vector<Contact> join_all(const ContactRows& rows, const std::vector<Particle>& particles, const Box& box,
                              const ContactRules& rules = {});

Contact join_one(const ContactRows& rows, const std::vector<Particle>& particles, const Box& box);

/// What join_contacts says to a row; empty where it takes it.
std::string refusal(const std::vector<Value>& row, const std::vector<Particle>& particles = two_discs(),
                    bool periodic_box = false, bool distant = false);

}  // namespace mikromakro
