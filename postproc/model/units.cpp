// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>

#include "model/raw_frame.h"

namespace mikromakro {
namespace {

struct Dimension {
  int length = 0;
  int mass = 0;
  int time = 0;
};
constexpr Dimension number{};
constexpr Dimension length{1, 0, 0};
constexpr Dimension velocity{1, 0, -1};
constexpr Dimension force{1, 1, -2};

// Indexed by ContactColumn.
constexpr Dimension contact_dimensions[] = {number,   number,   length, length, length, length, number,
                                            number,   length,   force,  force,  force,  force,  length,
                                            velocity, velocity, number, length, length, length};
static_assert(std::size(contact_dimensions) == static_cast<std::size_t>(ContactColumn::count));

double power(double unit, int exponent) {
  double value = 1;
  for (int i = 0; i < std::abs(exponent); ++i) value *= unit;
  return exponent < 0 ? 1 / value : value;
}

double factor(const Units& units, const Dimension& of) {
  return power(units.length, of.length) * power(units.mass, of.mass) * power(units.time, of.time);
}

void convert(const Units& units, Particle& particle) {
  particle.position *= units.length;
  particle.radius *= units.length;
  particle.velocity *= factor(units, velocity);
  particle.spin /= units.time;
  particle.mass *= units.mass;
}

void convert(const Units& units, Contact& contact) {
  contact.overlap *= units.length;
  contact.spring *= units.length;
  contact.force *= factor(units, force);
}

struct System {
  std::string_view name;
  Units units;
};
// cm, g, s; um, pg, us; nm, ag, ns.
constexpr System systems[] = {{"si", {}},
                              {"lj", {}},
                              {"cgs", {1e-2, 1e-3, 1}},
                              {"micro", {1e-6, 1e-15, 1e-6}},
                              {"nano", {1e-9, 1e-21, 1e-9}}};

}  // namespace

Units units_of(std::string_view name, const Place& place) {
  const auto found = std::find_if(std::begin(systems), std::end(systems),
                                  [&](const System& system) { return system.name == name; });
  if (found == std::end(systems))
    throw bad_input(place, "units that are not converted to SI", "si, cgs, micro, nano or lj",
                    in_quotes(name));
  return found->units;
}

std::string units_note(std::string_view name) {
  if (name == "si") return {};
  if (name == "lj")
    return "units lj: numbers stay as they are, in units of the file and not in m, kg, s, N, Pa";
  return fmt::format("units {}: numbers are converted to SI", name);
}

void convert(const Units& units, Box& box) {
  box.low *= units.length;
  box.high *= units.length;
}

void convert(const Units& units, RawFrame& raw, Frame& frame) {
  if (units.are_si()) return;
  convert(units, raw.box);
  convert(units, frame.box);
  raw.time *= units.time;
  for (Particle& particle : frame.particles) convert(units, particle);
  for (Contact& contact : frame.contacts) convert(units, contact);
  std::array<double, std::size(contact_dimensions)> factors{};
  std::transform(std::begin(contact_dimensions), std::end(contact_dimensions), factors.begin(),
                 [&](const Dimension& dimension) { return factor(units, dimension); });
  for (ContactRow& row : raw.contacts.rows)
    for (std::size_t column = 0; column < factors.size(); ++column) row.value[column] *= factors[column];
}

}  // namespace mikromakro
