// SPDX-License-Identifier: GPL-2.0-or-later
#include "drawing/disc_quantity.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>

#include "model/error.h"
#include "model/nearest_name.h"

namespace mikromakro {
namespace {

constexpr ColumnSet velocity_columns = column_set(ParticleColumn::vx, ParticleColumn::vy);
constexpr ColumnSet force_columns = column_set(ContactColumn::fx, ContactColumn::fy);
constexpr ColumnSet id_columns = column_set(ContactColumn::id1, ContactColumn::id2);

constexpr QuantityInfo all[] = {
    {DiscQuantity::radius, "radius", "radius", "m", 0, 0},
    {DiscQuantity::velocity, "velocity", "speed", "m/s", velocity_columns, 0},
    {DiscQuantity::spin, "spin", "spin \xCF\x89", "rad/s", column_set(ParticleColumn::omegaz), 0},
    {DiscQuantity::pressure, "pressure", "pressure", "Pa", 0, force_columns},
    {DiscQuantity::contacts, "contacts", "number of contacts", "", 0, id_columns},
    {DiscQuantity::type, "type", "type", "", column_set(ParticleColumn::type), 0},
};

double own_value(const Particle& particle, DiscQuantity quantity) {
  switch (quantity) {
    case DiscQuantity::radius:
      return particle.radius;
    case DiscQuantity::velocity:
      return particle.velocity.norm();
    case DiscQuantity::spin:
      return particle.spin;
    case DiscQuantity::type:
      return particle.type;
    default:
      return 0;
  }
}

// Contribution of one contact to a disc.
double contact_share(const Contact& contact, const Particle& particle, DiscQuantity quantity, double height) {
  if (quantity == DiscQuantity::contacts) return 1;
  const double normal_force = -contact.force.dot(contact.normal);
  return normal_force / (2 * std::numbers::pi * particle.radius * height);
}

}  // namespace

const QuantityInfo& disc_quantity(const std::string& name) {
  const auto* const found = std::find_if(std::begin(all), std::end(all),
                                         [&](const QuantityInfo& info) { return info.name == name; });
  if (found == std::end(all))
    throw bad_input({"--color"}, "unknown quantity",
                    fmt::format("one of {}", fmt::join(disc_quantity_names(), " ")),
                    in_quotes_with_guess(name, disc_quantity_names()));
  return *found;
}

std::vector<std::string_view> disc_quantity_names() {
  std::vector<std::string_view> names;
  for (const QuantityInfo& info : all) names.push_back(info.name);
  return names;
}

std::vector<double> disc_values(const Frame& frame, DiscQuantity quantity, double height) {
  std::vector<double> values;
  values.reserve(frame.particles.size());
  for (const Particle& particle : frame.particles) values.push_back(own_value(particle, quantity));
  if (quantity != DiscQuantity::pressure && quantity != DiscQuantity::contacts) return values;
  for (const Contact& contact : frame.contacts) {
    for (const int index : {contact.index1, contact.index2}) {
      if (index < 0) continue;
      const auto disc = static_cast<std::size_t>(index);
      values[disc] += contact_share(contact, frame.particles[disc], quantity, height);
    }
  }
  return values;
}

}  // namespace mikromakro
