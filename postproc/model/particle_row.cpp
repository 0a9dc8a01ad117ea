// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/particle_row.h"

#include <fmt/format.h>

#include <string_view>

namespace mikromakro {
namespace {

void check_positive(double value, std::string_view what, const Place& place) {
  if (value <= 0)
    throw bad_input(place, fmt::format("{} is not positive", what), "a number > 0", fmt::format("{}", value));
}

void check_count(double value, std::string_view what, const Place& place) {
  const std::int64_t number = as_integer(value, what, place);
  if (number < 1)
    throw bad_input(place, fmt::format("{} below 1", what), "1 or more", fmt::format("{}", number));
}

}  // namespace

void check_particle(const ParticleSlots& slots, ColumnSet given_columns, const Place& place) {
  const auto at = [&](ParticleColumn column) { return slots[static_cast<std::size_t>(column)]; };
  const auto given = [&](ParticleColumn column) { return (given_columns & column_bit(column)) != 0; };
  if (given(ParticleColumn::id)) check_count(at(ParticleColumn::id), "id", place);
  if (given(ParticleColumn::type)) {
    const double type = at(ParticleColumn::type);
    check_count(type, "type", place);
    if (type > std::numeric_limits<int>::max())
      throw bad_input(place, "type is too large", "a type of particles", fmt::format("{}", type));
  }
  check_positive(at(ParticleColumn::radius), "radius", place);
  if (given(ParticleColumn::mass)) check_positive(at(ParticleColumn::mass), "mass", place);
}

}  // namespace mikromakro
