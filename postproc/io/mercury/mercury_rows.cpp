// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/mercury/mercury_rows.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>

#include "io/files/row_parser.h"
#include "io/text/particle_reader.h"

namespace mikromakro {
namespace {

constexpr auto slot(ParticleColumn column) {
  return static_cast<int>(column);
}

constexpr int z_slot = static_cast<int>(particle_z);

ColumnMap data_map(int columns) {
  constexpr int skip = -1;
  using enum ParticleColumn;
  if (columns == 8)
    return {{slot(x), slot(y), slot(vx), slot(vy), slot(radius), skip, slot(omegaz), slot(type)},
            mercury_particle_columns};
  return {{slot(x), slot(y), z_slot, slot(vx), slot(vy), skip, slot(radius), skip, skip, skip, skip, skip,
           slot(omegaz), slot(type)},
          mercury_particle_columns};
}

// A millionth of a radius is the rounding of six digits, not a third dimension.
constexpr double in_plane = 1e-6;

struct FstatRow {
  std::int64_t i, j;
  double overlap, spring, normal_force, tangential_force;
  Eigen::Vector2d point, normal, tangent;
  double z;
};

enum FstatSlot {
  i_at,
  j_at,
  x_at,
  y_at,
  z_at,
  overlap_at,
  spring_at,
  fn_at,
  ft_at,
  nx_at,
  ny_at,
  nz_at,
  tx_at,
  ty_at,
  tz_at,
  fstat_slots
};

FstatRow fstat_row(std::string_view line, const Place& place) {
  static const ColumnMap map{{-1, i_at, j_at, x_at, y_at, z_at, overlap_at, spring_at, fn_at, ft_at, nx_at,
                              ny_at, nz_at, tx_at, ty_at, tz_at},
                             0};
  std::array<double, fstat_slots> slots{};
  parse_row(line, map, slots, place);
  if (std::abs(slots[nz_at]) > in_plane)
    throw bad_input(place, "the contact is not in a plane", "n_z = 0", fmt::format("{}", slots[nz_at]));
  if (std::abs(slots[tz_at]) > in_plane)
    throw bad_input(place, "the tangent is not in the plane", "t_z = 0", fmt::format("{}", slots[tz_at]));
  return {as_integer(slots[i_at], "index", place),
          as_integer(slots[j_at], "index", place),
          slots[overlap_at],
          slots[spring_at],
          slots[fn_at],
          slots[ft_at],
          {slots[x_at], slots[y_at]},
          {slots[nx_at], slots[ny_at]},
          {slots[tx_at], slots[ty_at]},
          slots[z_at]};
}

bool is_species(double number) {
  return is_integer(number) && number >= 0;
}

void check_index(std::int64_t index, const std::vector<Particle>& particles, const Place& place) {
  if (index >= 0 && index < std::ssize(particles)) return;
  throw bad_input(place, "contact with an unknown particle (a copy across a periodic boundary?)",
                  fmt::format("an index of the .data frame, 0 to {}", std::ssize(particles) - 1),
                  fmt::format("{}", index));
}

// The contact point lies in the overlap, on the (outward) normal through the disc's centre.
void check_point(const FstatRow& row, const Eigen::Vector2d& normal, const Particle& disc,
                 const Place& place) {
  constexpr double digits = 1e-4;  // of the radius, as the files keep six digits of the coordinates
  const Eigen::Vector2d right = disc.position + (disc.radius - row.overlap / 2) * normal;
  const double allowed = std::abs(row.overlap) / 2 + digits * (disc.radius + disc.position.norm());
  if ((row.point - right).norm() <= allowed) return;
  throw bad_input(place,
                  fmt::format("the contact point is not where {} touches the disc",
                              row.j < 0 ? "the wall" : "the other one"),
                  fmt::format("{:.9g} {:.9g} within {:.2g} m", right.x(), right.y(), allowed),
                  fmt::format("{:.9g} {:.9g}", row.point.x(), row.point.y()));
}

// The tangential force needs a valid unit tangent for its direction.
void check_tangent(const FstatRow& row, const Place& place) {
  constexpr double digits = 1e-4;
  const bool right =
      std::abs(row.tangent.norm() - 1) <= digits && std::abs(row.tangent.dot(row.normal)) <= digits;
  if (row.tangential_force != 0 && !right)
    throw bad_input(place, "the tangent is not a unit vector perpendicular to the normal",
                    "t_x t_y of length 1 with a tangential force",
                    fmt::format("{:.9g} {:.9g}", row.tangent.x(), row.tangent.y()));
}

ContactRow contact_of(const FstatRow& row, const std::vector<Particle>& particles, const Place& place) {
  const bool wall = row.j < 0;
  // Our normal points from 1 to 2, that is from i to j.
  const Eigen::Vector2d normal = wall ? row.normal : Eigen::Vector2d(-row.normal);
  const double side = wall ? -1 : 1;
  const Eigen::Vector2d force = side * (row.normal_force * row.normal + row.tangential_force * row.tangent);
  check_index(row.i, particles, place);
  check_tangent(row, place);
  if (!wall) {
    check_index(row.j, particles, place);
    const auto& of_i = particles[static_cast<std::size_t>(row.i)].position;
    const auto& of_j = particles[static_cast<std::size_t>(row.j)].position;
    if (normal.dot(of_j - of_i) <= 0)
      throw bad_input(place, "the normal points the wrong way", "n from j to i", "the other way");
  }
  check_point(row, normal, particles[static_cast<std::size_t>(row.i)], place);
  const double along = -normal.y() * force.x() + normal.x() * force.y();
  ContactRow contact{};
  contact.value.fill(not_given);
  const auto set = [&](ContactColumn column, double value) {
    contact.value[static_cast<std::size_t>(column)] = value;
  };
  set(ContactColumn::id1, static_cast<double>(row.i + 1));
  set(ContactColumn::id2, static_cast<double>(wall ? row.j + mercury_walls : row.j + 1));
  set(ContactColumn::nx, normal.x());
  set(ContactColumn::ny, normal.y());
  set(ContactColumn::overlap, row.overlap);
  set(ContactColumn::fx, force.x());
  set(ContactColumn::fy, force.y());
  set(ContactColumn::fn, row.normal_force);
  set(ContactColumn::ft, along);
  set(ContactColumn::xi, row.tangential_force == 0 ? 0 : -std::copysign(row.spring, along));
  check_contact_row(contact, mercury_contact_columns, false, place);
  return contact;
}

// The rows of a pair seen so far: i before j, and the reverse.
struct Seen {
  FstatRow first;
  bool twice = false;
};

// Whether this is the second row of a pair of free particles.
bool is_mirrored(const FstatRow& row, std::map<std::pair<std::int64_t, std::int64_t>, Seen>& seen,
                 const Place& place) {
  if (row.j < 0) return false;
  const auto [at, is_new] = seen.try_emplace(std::minmax(row.i, row.j), Seen{row});
  if (is_new || at->second.twice || at->second.first.i == row.i) return false;
  const FstatRow& first = at->second.first;
  at->second.twice = true;
  const bool same = first.overlap == row.overlap && first.normal_force == row.normal_force &&
                    first.tangential_force == row.tangential_force && first.normal == -row.normal &&
                    first.tangent == -row.tangent;
  if (!same)
    throw bad_input(place, "the two rows of a contact differ", "the same numbers, with n and t reversed",
                    "others");
  return true;
}

}  // namespace

std::vector<Particle> mercury_particles(const MercuryBlock& block, ColumnSet needed, ColumnSet& given) {
  constexpr ColumnSet type_column = column_set(ParticleColumn::type);
  const ColumnMap map = data_map(block.header.columns);
  given = mercury_particle_columns;
  Place place{block.file, block.header.line};
  std::vector<Particle> particles;
  particles.reserve(static_cast<std::size_t>(block.header.rows));
  ParticleSlots row;
  row.fill(not_given);
  PlaneCheck plane;
  const auto at = [&](ParticleColumn column) -> double& { return row[static_cast<std::size_t>(column)]; };
  for (std::string_view rest = block.text; !rest.empty();) {
    ++place.line;
    parse_row(next_line(rest), map, row, place);
    at(ParticleColumn::id) = static_cast<double>(place.line - block.header.line);
    if (block.header.columns == 8) at(ParticleColumn::omegaz) *= -1;
    const double species = at(ParticleColumn::type);
    if (!is_species(species)) {
      if ((needed & type_column) != 0)
        throw bad_input(place, "the last column is not a species", "a whole number >= 0",
                        fmt::format("{}", species));
      given &= ~type_column;
    }
    at(ParticleColumn::type) += 1;
    particles.push_back(particle_of(row, given, place));
    if (block.header.columns != 8) plane.add(row[particle_z], particles.back().radius, place);
  }
  if ((given & type_column) == 0)
    for (Particle& particle : particles) particle.type = 0;
  return particles;
}

ContactRows mercury_contacts(const MercuryBlock& block, const std::vector<Particle>& particles) {
  ContactRows contacts;
  contacts.given = mercury_contact_columns;
  contacts.file = block.file;
  Place place{block.file, block.header.line};
  std::map<std::pair<std::int64_t, std::int64_t>, Seen> seen;
  PlaneCheck plane;
  for (std::string_view rest = block.text; !rest.empty();) {
    ++place.line;
    const FstatRow row = fstat_row(next_line(rest), place);
    if (is_mirrored(row, seen, place)) continue;
    contacts.rows.push_back(contact_of(row, particles, place));
    plane.add(row.z, particles[static_cast<std::size_t>(row.i)].radius, place);
    contacts.lines.push_back(place.line);
  }
  return contacts;
}

}  // namespace mikromakro
