// SPDX-License-Identifier: GPL-2.0-or-later
#include "joining/contact_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "joining/contact_pairs.h"
#include "joining/contact_tolerance.h"
#include "joining/plausible_forces.h"
#include "joining/plausible_springs.h"
#include "joining/row_branch.h"
#include "joining/row_force.h"

namespace mikromakro {
namespace {

using enum ContactColumn;
using Eigen::Vector2d;

constexpr ColumnSet normal_columns = column_set(nx, ny);
constexpr ColumnSet place_columns = column_set(x1, y1, x2, y2);
constexpr ColumnSet whole_geometry = normal_columns | column_set(overlap);
constexpr ColumnSet force_columns = column_set(fx, fy);
constexpr ColumnSet components_of_force = column_set(fn, ft);

class Joiner {
 public:
  Joiner(const ContactRows& rows, const ContactDiscs& discs, const ContactRules& rules)
      : rows_(rows),
        discs_(discs),
        rules_(rules),
        tolerance_(rows, discs.particles, discs.box, discs.place_error),
        branch_(rows, discs.box, tolerance_),
        images_(discs.box) {
    const ColumnSet given = rows.given_in_all();
    const auto all = [given](ColumnSet columns) { return (columns & ~given) == 0; };
    const auto none = [given](ColumnSet columns) { return (columns & given) == 0; };
    plain_ = rows.wall_file.empty() && all(whole_geometry | force_columns) &&
             none(column_set(dist, periodic, shearx));
    with_places_ = all(place_columns);
    with_components_ = !none(components_of_force);
    plain_ = plain_ && (with_components_ ? all(components_of_force) : true);
  }

  /// False if the row is not a contact. Contacts that are deep, or with walls, are counted.
  bool join(std::size_t i, Contact& contact) {
    if (plain_ && join_plain(rows_.rows[i], contact)) return true;
    if (!join_any(i, contact)) return false;
    deep_ += is_deep(contact) ? 1 : 0;
    long_springs_ += has_long_spring(contact) ? 1 : 0;
    walls_ += contact.with_wall() ? 1 : 0;
    return true;
  }

  std::int64_t deep() const { return deep_; }
  std::int64_t long_springs() const { return long_springs_; }
  std::int64_t walls() const { return walls_; }

 private:
  bool join_any(std::size_t i, Contact& contact) const {
    const RowView row{rows_.rows[i], rows_.given_in(i), i};
    contact.id1 = static_cast<std::int64_t>(row[id1]);
    contact.id2 = static_cast<std::int64_t>(row[id2]);
    contact.index1 = find(contact.id1, i);
    contact.index2 = contact.with_wall() ? -1 : find(contact.id2, i);
    contact.normal = {row[nx], row[ny]};
    contact.overlap = row[overlap];
    const double slack = contact.with_wall() ? join_wall(row, contact) : join_discs(row, contact);
    set_force(row, contact);
    check_spring(row, contact, rows_);
    // The normal is rotated by the error of the places if the row does not give it.
    const double turned = row.has(normal_columns) ? 0 : 2 * slack / disc(contact.index1).radius;
    check_components(row, contact, turned, rows_);
    return is_contact(row, contact, slack);
  }

  /// Contact laws for discs do not cover overlaps of more than half the smaller radius.
  static constexpr double deep_part = 0.5;
  bool is_deep(const Contact& contact) const {
    const double one = disc(contact.index1).radius;
    const double smaller = contact.with_wall() ? one : std::min(one, disc(contact.index2).radius);
    return contact.overlap > deep_part * smaller;
  }

  /// Friction limits k_t |xi| to mu f_n = mu k_n overlap: springs are about as long as the overlap.
  bool has_long_spring(const Contact& contact) const {
    constexpr double overlaps = 100;
    return std::abs(contact.spring) > disc(contact.index1).radius &&
           std::abs(contact.spring) > overlaps * contact.overlap;
  }

  int find(std::int64_t id, std::size_t i) const {
    const int index = discs_.ids.find(id);
    if (index < 0)
      throw bad_input(rows_.place(i), "contact with an unknown id", "an id of the particle dump",
                      fmt::format("{}", id));
    return index;
  }

  const Particle& disc(int index) const { return discs_.particles[static_cast<std::size_t>(index)]; }

  /// Fast path for nearly all rows of most files: a contact of two discs with consistent normal, overlap and
  /// force, that is not deep and has no long spring. False for anything else.
  bool join_plain(const ContactRow& row, Contact& contact) const {
    contact.id1 = static_cast<std::int64_t>(row[id1]);
    contact.id2 = static_cast<std::int64_t>(row[id2]);
    contact.index1 = discs_.ids.find(contact.id1);
    contact.index2 = discs_.ids.find(contact.id2);
    contact.normal = {row[nx], row[ny]};
    contact.overlap = row[overlap];
    contact.force = {row[fx], row[fy]};
    contact.spring = row[xi];
    if (contact.with_wall() || contact.index1 < 0 || contact.index2 < 0 || contact.id1 == contact.id2)
      return false;
    const Particle& one = disc(contact.index1);
    const Particle& two = disc(contact.index2);
    const double reach = one.radius + two.radius;
    const double smaller = std::min(one.radius, two.radius);
    const double slack = tolerance_.of_geometry(smaller, reach, contact.overlap, false);
    const double allowed = tolerance_.of_place(smaller);
    return contact.overlap > 0 && contact.overlap <= deep_part * smaller &&
           !(std::abs(contact.spring) > smaller) &&
           fits(contact, two.position - one.position, reach, slack) &&
           (!with_places_ || (is_at(row, x1, y1, one, allowed) && is_at(row, x2, y2, two, allowed))) &&
           (!with_components_ || are_components(row, contact));
  }

  bool fits(const Contact& contact, const Vector2d& between, double reach, double slack) const {
    return images_.nearest(between - (reach - contact.overlap) * contact.normal).squaredNorm() <=
           slack * slack;
  }

  /// Normal and overlap of two discs, checked or derived; returns the tolerance.
  double join_discs(const RowView& row, Contact& contact) const {
    const Particle& one = disc(contact.index1);
    const Particle& two = disc(contact.index2);
    if (contact.id1 == contact.id2 && !images_.any())
      throw bad_input(rows_.place(row.index), "a disc in contact with itself", "two ids",
                      fmt::format("twice {}", contact.id1));
    const bool by_row = row.has(place_columns);
    if (by_row) {
      check_place(row, x1, y1, one);
      check_place(row, x2, y2, two);
    }
    check_flag(row);
    const double reach = one.radius + two.radius;
    const double told = row.has(overlap) ? row[overlap] : row.has(dist) ? row[dist] : not_given;
    const double slack = tolerance_.of_geometry(std::min(one.radius, two.radius), reach, told, by_row);
    if (!by_row && row.has(whole_geometry) && !row.has(dist) &&
        fits(contact, two.position - one.position, reach, slack))
      return slack;
    check_branch(row, branch_.of(row, two.position - one.position, reach, slack), reach, slack, contact);
    return slack;
  }

  /// The same for a disc and a wall, as far as the row allows.
  double join_wall(const RowView& row, Contact& contact) const {
    const Particle& one = disc(contact.index1);
    const double told = row.has(overlap) ? row[overlap] : not_given;
    const double slack = tolerance_.of_geometry(one.radius, one.radius, told, true);
    if (!std::isnan(row[x1]) && !std::isnan(row[x2])) {
      check_place(row, x1, y1, one);
      Vector2d branch = row.place(x2, y2) - row.place(x1, y1);
      if (branch.norm() > one.radius) branch = images_.nearest(branch);
      check_branch(row, branch, one.radius, slack, contact);
      return slack;
    }
    const bool overlap_needed = (rows_.needed & column_set(overlap)) != 0;
    if (!row.has(normal_columns) || (overlap_needed && !row.has(overlap)))
      throw bad_input(rows_.place(row.index), "wall contact without geometry",
                      "columns nx ny overlap or x1 y1 x2 y2", "neither");
    return slack;
  }

  bool is_at(const ContactRow& row, ContactColumn x, ContactColumn y, const Particle& disc,
             double allowed) const {
    const Vector2d apart = images_.nearest(Vector2d(row[x], row[y]) - disc.position);
    return std::abs(apart.x()) <= allowed && std::abs(apart.y()) <= allowed;
  }

  void check_place(const RowView& row, ContactColumn x, ContactColumn y, const Particle& disc) const {
    const double allowed = tolerance_.of_place(disc.radius);
    if (is_at(row.numbers, x, y, disc, allowed)) return;
    const Vector2d told = row.place(x, y);
    throw bad_input(
        rows_.place(row.index),
        fmt::format("disc {} is not where the row says (another run or step, or ids that have "
                    "lost digits?)",
                    disc.id),
        fmt::format("{} {} = {} within {:.2g} m", contact_read_names[static_cast<std::size_t>(x)],
                    contact_read_names[static_cast<std::size_t>(y)], text_of(disc.position), allowed),
        text_of(told));
  }

  void check_flag(const RowView& row) const {
    if (!row.has(periodic) || row[periodic] == 0) return;
    if (row[periodic] != 1)
      throw bad_input(rows_.place(row.index), "periodic is a flag", "0 or 1",
                      fmt::format("{}", row[periodic]));
  }

  /// Sets what is missing from the row and checks what is given.
  void check_branch(const RowView& row, const Vector2d& branch, double reach, double slack,
                    Contact& contact) const {
    const double distance = branch.norm();
    if (!row.has(normal_columns)) {
      if (distance == 0)
        throw bad_input(rows_.place(row.index), "contact of discs whose centres coincide", "a distance > 0",
                        "0");
      contact.normal = branch / distance;
    } else if (const Vector2d apart = branch - distance * contact.normal;
               !(std::abs(apart.x()) <= slack && std::abs(apart.y()) <= slack)) {
      throw bad_input(rows_.place(row.index), fmt::format("the normal is not that of {}", pair_name(contact)),
                      fmt::format("nx ny = {} within {:.2g}", text_of(branch / distance), slack / distance),
                      text_of(contact.normal));
    }
    check_told(row, "dist", row.has(dist) ? row[dist] : distance, distance, slack, contact);
    const double derived = reach - (row.has(dist) && !row.has(place_columns) ? row[dist] : distance);
    if (!row.has(overlap)) contact.overlap = derived;
    check_told(row, "overlap", contact.overlap, derived, slack, contact);
  }

  void check_told(const RowView& row, std::string_view name, double told, double right, double slack,
                  const Contact& contact) const {
    if (std::abs(told - right) <= slack) return;
    throw bad_input(rows_.place(row.index), fmt::format("{} is not that of {}", name, pair_name(contact)),
                    fmt::format("{:.9g} within {:.2g} m", right, slack), fmt::format("{:.9g}", told));
  }

  bool is_contact(const RowView& row, const Contact& contact, double slack) const {
    if (!(contact.overlap <= 0)) return true;
    const bool forces_known = row.has(force_columns) || row.has(components_of_force);
    if (forces_known && contact.force.isZero(0)) return false;
    if (contact.overlap >= -slack) return true;
    if (!forces_known) return false;
    if (rules_.distant) return true;
    throw bad_input(rows_.place(row.index),
                    fmt::format("a force between {} that do not touch (if such forces are intended, as with "
                                "cohesion, give --distant-contacts)",
                                pair_name(contact)),
                    fmt::format("an overlap > {:.2g} m or no force", -slack),
                    fmt::format("{:.9g}", contact.overlap));
  }

  const ContactRows& rows_;
  const ContactDiscs& discs_;
  const ContactRules& rules_;
  ContactTolerance tolerance_;
  RowBranch branch_;
  BranchImages images_;
  bool plain_ = false;  ///< rows have all columns that join_plain needs, none that it ignores
  bool with_places_ = false, with_components_ = false;
  std::int64_t deep_ = 0, long_springs_ = 0, walls_ = 0;
};

}  // namespace

std::vector<Contact> join_contacts(const ContactRows& rows, const ContactDiscs& discs,
                                   const ContactRules& rules) {
  Joiner joiner(rows, discs, rules);
  std::vector<Contact> contacts;
  RowOfContact row_of;
  contacts.reserve(rows.rows.size());
  Contact contact;
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    if (!joiner.join(i, contact)) {
      row_of.leave_out(i);
      continue;
    }
    contacts.push_back(contact);
  }
  check_pairs(contacts, row_of, rows, discs.particles, discs.box);
  check_springs_pull_back(rows, contacts, rules.closely);
  const auto left_out = static_cast<std::int64_t>(row_of.left_out());
  if (rules.notes == nullptr) return contacts;
  note_size_of_springs(contacts, rules);
  note_springs_without_force(contacts, rules);
  if (joiner.walls() > 0) {
    note_wall_forces(contacts, rules);
    note_walls_twice(contacts, discs.particles, *rules.notes, rules.step);
  }
  if (left_out > 0)
    rules.notes->add("near pairs that neither touch nor exert forces are not contacts and are left out",
                     rules.step, left_out);
  if (joiner.deep() > 0)
    rules.notes->add(
        "contacts overlap by more than half of the smaller radius (k_n too small for the load, or a density "
        "in kg/m^3 where rho h in kg/m^2 was meant?)",
        rules.step, joiner.deep());
  if (joiner.long_springs() > 0)
    rules.notes->add(
        "tangential springs are longer than the radius of a disc and than a hundred overlaps (damaged rows, "
        "or "
        "another quantity in their column?)",
        rules.step, joiner.long_springs());
  return contacts;
}

}  // namespace mikromakro
