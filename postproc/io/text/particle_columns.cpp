// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/text/particle_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mikromakro {
namespace {

constexpr std::string_view axis_names[] = {"x", "y", "z"};
// Suffixes of the axis letter, in order of preference.
constexpr std::string_view forms[] = {"", "u", "s", "su"};

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void rename(std::vector<std::string>& names, std::string_view from, std::string_view to) {
  std::replace(names.begin(), names.end(), std::string(from), std::string(to));
}

}  // namespace

// Renames the columns in use to the names of ParticleColumn, and the alternatives to '-'.
void ParticleColumns::choose(std::vector<std::string>& names) {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    bool found = false;
    for (const std::string_view form : forms) {
      const std::string name = fmt::format("{}{}", axis_names[i], form);
      if (!contains(names, name)) continue;
      if (!found) {
        axes_[i].scaled = form.starts_with('s');
        axes_[i].unwrapped = form.ends_with('u');
        as_they_are_ = as_they_are_ && form.empty();
      }
      if (!form.empty()) rename(names, name, found ? "-" : axis_names[i]);
      found = true;
    }
  }
  diameter_ = contains(names, "diameter") && !contains(names, "radius");
  as_they_are_ = as_they_are_ && !diameter_;
  rename(names, "diameter", diameter_ ? "radius" : "-");
  // Image flags: the copy of the box that contains an unwrapped disc.
  for (const std::string_view flag : {"ix", "iy", "iz"}) rename(names, flag, "-");
}

ParticleColumns::ParticleColumns(const DumpHeader& header, const std::vector<std::string>& list,
                                 const Place& place)
    : boundaries_known_(header.box.boundaries_known) {
  std::vector<std::string> names = list.empty() ? header.columns : list;
  choose(names);
  map_ = list.empty() ? map_header(names, particle_names(), place)
                      : map_option(names, header.columns.size(), particle_names(), place);
  const auto z = std::find(names.begin(), names.end(), "z");
  with_z_ = z != names.end();
  if (with_z_) map_.slot_of_column[static_cast<std::size_t>(z - names.begin())] = particle_z;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    Axis& axis = axes_[i];
    const auto index = static_cast<Eigen::Index>(i);
    axis.low = i < 2 ? header.box.low[index] : 0;
    axis.length = i < 2 ? header.box.length()[index] : header.depth;
    axis.wraps = i < 2 && header.box.periodic[i];
    if (axis.scaled && axis.length <= 0)
      throw bad_input(place, "scaled coordinates without a box", "'ITEM: BOX BOUNDS' with low < high",
                      "none");
  }
}

double ParticleColumns::along(const Axis& axis, double number, const Place& place) const {
  if (axis.scaled) number = axis.low + number * axis.length;
  if (!axis.unwrapped) return number;
  const double boxes = std::floor((number - axis.low) / axis.length);
  if (axis.wraps) return number - boxes * axis.length;
  if (boxes != 0 && !boundaries_known_)
    throw bad_input(place, "an unwrapped coordinate outside a box that may be periodic or not",
                    "boundary flags (pp, ff) after 'ITEM: BOX BOUNDS'", fmt::format("{}", number));
  return number;
}

void ParticleColumns::convert(ParticleSlots& row, const Place& place) {
  constexpr auto x = static_cast<std::size_t>(ParticleColumn::x);
  constexpr auto y = static_cast<std::size_t>(ParticleColumn::y);
  axes_[0].sample(row[x]);
  axes_[1].sample(row[y]);
  row[x] = along(axes_[0], row[x], place);
  row[y] = along(axes_[1], row[y], place);
  if (axes_[2].scaled) row[particle_z] *= axes_[2].length;
  if (!diameter_) return;
  double& radius = row[static_cast<std::size_t>(ParticleColumn::radius)];
  diameter_digits_.add(radius);
  largest_diameter_ = std::max(largest_diameter_, radius);
  radius *= 0.5;
}

// Scaled positions depend on the bounds of the box, which have their own rounding error.
double ParticleColumns::Axis::error() const {
  if (!scaled) return digits.rounding(largest);
  PrintedDigits bounds;
  bounds.add(low);
  bounds.add(low + length);
  return digits.rounding(largest) * length + bounds.rounding(std::max(std::abs(low), std::abs(low + length)));
}

double ParticleColumns::place_error() const {
  if (as_they_are_) return not_given;
  const double places = std::max(axes_[0].error(), axes_[1].error());
  return places + (diameter_ ? 0.5 * diameter_digits_.rounding(largest_diameter_) : 0);
}

}  // namespace mikromakro
