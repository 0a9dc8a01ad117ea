// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/text/particle_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/files/row_parser.h"

namespace mikromakro {
void PlaneCheck::add(double z, double radius, const Place& place) {
  // A millionth of a radius is the rounding of six digits, not a third dimension.
  constexpr double in_plane = 1e-6;
  if (std::isnan(plane_)) plane_ = z;
  if (!(std::abs(z - plane_) <= in_plane * radius))
    throw bad_input(place, "the particles are not in a plane", fmt::format("z = {} of all", plane_),
                    fmt::format("{}", z));
}

ParticleRows read_particles(const RowBlock& block, const std::vector<std::string>& list, ColumnSet needed) {
  const DumpHeader& header = block.header;
  Place place{block.file, header.line};
  if (!header.of_particles())
    throw bad_input(place, "not a dump of particles", "'ITEM: ATOMS'", in_quotes("ITEM: " + header.label));
  ParticleColumns columns(header, list, place);
  require_columns(columns.map(), needed | particle_base_columns, particle_names(), place);

  ParticleRows rows;
  rows.particles.reserve(static_cast<std::size_t>(header.rows));
  rows.given = columns.map().given;
  const bool with_ids = (rows.given & column_set(ParticleColumn::id)) != 0;
  PlaneCheck plane;
  ParticleSlots slots;
  slots.fill(not_given);
  for (std::string_view rest = block.text; !rest.empty();) {
    ++place.line;
    parse_row(next_line(rest), columns.map(), slots, place);
    columns.settle(slots, place);
    rows.particles.push_back(particle_of(slots, rows.given, place));
    if (!with_ids) rows.particles.back().id = std::ssize(rows.particles);
    if (columns.with_z()) plane.add(slots[particle_z], rows.particles.back().radius, place);
  }
  rows.place_error = columns.place_error();
  return rows;
}

}  // namespace mikromakro
