// SPDX-License-Identifier: GPL-2.0-or-later
#include "joining/contact_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "joining/contact_pairs.h"
#include "joining/contact_tolerance.h"
#include "joining/plausible_forces.h"
#include "joining/row_branch.h"

namespace mikromakro {
namespace {

using enum ContactColumn;
using Eigen::Vector2d;

constexpr ColumnSet normal_columns = column_set(nx, ny);
constexpr ColumnSet place_columns = column_set(x1, y1, x2, y2);
constexpr ColumnSet whole_geometry = normal_columns | column_set(overlap);
constexpr ColumnSet force_columns = column_set(fx, fy);
constexpr ColumnSet components_of_force = column_set(fn, ft);
constexpr double six_digits = 2e-5;

std::string text_of(const Vector2d& vector) {
  return fmt::format("{:.9g} {:.9g}", vector.x(), vector.y());
}

std::string pair_name(const Contact& contact) {
  return contact.with_wall() ? fmt::format("disc {} and wall {}", contact.id1, contact.id2)
                             : fmt::format("discs {} and {}", contact.id1, contact.id2);
}

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
    walls_ += contact.with_wall() ? 1 : 0;
    return true;
  }

  std::int64_t deep() const { return deep_; }
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
    check_spring(row, contact);
    check_components(row, contact, slack);
    return is_contact(row, contact, slack);
  }

  /// Contact laws for discs do not cover overlaps of more than half the smaller radius.
  static constexpr double deep_part = 0.5;
  bool is_deep(const Contact& contact) const {
    const double one = disc(contact.index1).radius;
    const double smaller = contact.with_wall() ? one : std::min(one, disc(contact.index2).radius);
    return contact.overlap > deep_part * smaller;
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
  /// force, that is not deep. False for anything else.
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

  /// Tolerance of the force's digits only, since the normal is exact.
  static bool are_components(const ContactRow& row, const Contact& contact) {
    const double f_n = -contact.force.dot(contact.normal);
    const double f_t = contact.force.dot(Vector2d(-contact.normal.y(), contact.normal.x()));
    const double allowed = six_digits * contact.force.lpNorm<1>();
    return std::abs(row[fn] - f_n) <= allowed && std::abs(row[ft] - f_t) <= allowed;
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
        throw bad_input(rows_.place(row.index), "contact of coinciding centres", "a distance > 0", "0");
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

  /// The spring of stock LIGGGHTS lies along the tangent; a normal force in the spring columns is not a
  /// spring.
  void check_spring(const RowView& row, const Contact& contact) const {
    if (!row.has(column_set(shearx, sheary))) return;
    const Vector2d shear = row.place(shearx, sheary);
    constexpr double turned = 0.05;  // rotation of the normal since the spring was last rotated with it
    if (!(std::abs(shear.dot(contact.normal)) > turned * shear.norm())) return;
    throw bad_input(
        rows_.place(row.index),
        fmt::format("shearx sheary is no spring of {} (columns of another quantity?)", pair_name(contact)),
        fmt::format("a vector along the tangent {}", text_of({-contact.normal.y(), contact.normal.x()})),
        text_of(shear));
  }

  static void set_force(const RowView& row, Contact& contact) {
    const Vector2d tangent(-contact.normal.y(), contact.normal.x());
    contact.force = row.has(force_columns) || !row.has(components_of_force)
                        ? row.place(fx, fy)
                        : Vector2d(-row[fn] * contact.normal + row[ft] * tangent);
    // The spring of stock LIGGGHTS is the slip of 1 against 2 as well.
    contact.spring = row.has(column_set(shearx, sheary)) && !row.has(xi)
                         ? row.place(shearx, sheary).dot(tangent)
                         : row[xi];
  }

  void check_components(const RowView& row, const Contact& contact, double slack) const {
    if (!row.has(force_columns) || (row.given & components_of_force) == 0) return;
    const Vector2d tangent(-contact.normal.y(), contact.normal.x());
    const Vector2d right(-contact.force.dot(contact.normal), contact.force.dot(tangent));
    const Vector2d told(row.has(fn) ? row[fn] : right.x(), row.has(ft) ? row[ft] : right.y());
    // Both are rounded, to at least six digits, and rotated by the error of the normal if the row does not
    // give it.
    const double turned = row.has(normal_columns) ? 0 : 2 * slack / disc(contact.index1).radius;
    const double allowed = contact.force.lpNorm<1>() * (six_digits + turned);
    if ((told - right).lpNorm<Eigen::Infinity>() <= allowed) return;
    throw bad_input(rows_.place(row.index),
                    fmt::format("fn ft is not that of fx fy of {}", pair_name(contact)),
                    fmt::format("{} within {:.2g} N", text_of(right), allowed), text_of(told));
  }

  bool is_contact(const RowView& row, const Contact& contact, double slack) const {
    if (!(contact.overlap <= 0)) return true;
    const bool forces_known = row.has(force_columns) || row.has(components_of_force);
    if (forces_known && contact.force.isZero(0)) return false;
    if (contact.overlap >= -slack) return true;
    if (!forces_known) return false;
    if (rules_.distant) return true;
    throw bad_input(rows_.place(row.index),
                    fmt::format("a force between {} that do not touch (where such forces are meant, cohesion "
                                "say, give --distant-contacts)",
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
  std::int64_t deep_ = 0, walls_ = 0;
};

/// |f_t|/|f_n| that a tenth of the contacts reach: the friction coefficient, where discs slide.
double large_ratio(const std::vector<Contact>& contacts) {
  std::vector<double> ratios;
  ratios.reserve(contacts.size());
  for (const Contact& contact : contacts) {
    const double normal = contact.force.dot(contact.normal);
    const double tangential = contact.force.dot(Vector2d(-contact.normal.y(), contact.normal.x()));
    ratios.push_back(normal == 0 ? 0 : std::abs(tangential / normal));
  }
  const auto tenth = ratios.end() - 1 - std::ssize(ratios) / 10;
  std::nth_element(ratios.begin(), tenth, ratios.end());
  return *tenth;
}

/// Springs act against their displacement: -f_t xi > 0. A tangential force in the spring columns does not,
/// nor does the slip of 2 relative to 1, which shows in a frame with many contacts; a dashpot parallel to the
/// spring reverses f_t in some of them.
void check_springs_pull_back(const ContactRows& rows, const std::vector<Contact>& contacts, bool closely) {
  constexpr std::size_t enough = 20;
  constexpr ColumnSet shear = column_set(shearx, sheary);
  const bool by_xi = (rows.given & column_set(xi)) != 0;
  const bool given = by_xi ? closely : (rows.given & shear) == shear;
  if (!given || contacts.size() < enough) return;
  double along = 0, all = 0;
  std::ptrdiff_t count_along = 0, count = 0;
  const double limit = large_ratio(contacts);
  for (const Contact& contact : contacts) {
    const double tangential = contact.force.dot(Vector2d(-contact.normal.y(), contact.normal.x()));
    const double work = tangential * contact.spring;
    // Where discs slide, a dashpot beside the spring carries the whole limit, and the spring what is beyond.
    constexpr double sticks = 0.9;
    const double normal = contact.force.dot(contact.normal);
    if (std::isnan(work) || std::abs(tangential) > sticks * limit * std::abs(normal)) continue;
    along += work;
    all += std::abs(work);
    count_along += work > 0 ? 1 : 0;
    count += work != 0 ? 1 : 0;
  }
  // In fast motion dashpots turn f_t round in half of the contacts, and in those of the largest forces.
  constexpr double most = 0.75;
  if (count >= std::ssize(contacts) / 4 && count >= static_cast<std::ptrdiff_t>(enough) &&
      along > 0.5 * all && static_cast<double>(count_along) > most * static_cast<double>(count))
    throw bad_input(
        rows.place(0),
        by_xi ? "xi has the sign of the tangential forces on the whole: no springs (forces in this column, "
                "slip of disc 2 against disc 1? or forces on disc 2?)"
              : "shearx sheary point along the tangential forces: no springs",
        fmt::format("springs, which pull back (f_t = -k_t {})", by_xi ? "xi" : "shear"), "another quantity");
}

/// f_t/xi over f_n/overlap is about k_t/k_n, near 1, for contacts that stick and, with both at the Coulomb
/// limit, for those that slide; dashpots scatter it. A sample suffices in frames not checked closely.
void note_size_of_springs(const std::vector<Contact>& contacts, const ContactRules& rules) {
  constexpr std::size_t enough = 20, sample = 40;
  constexpr double most = 100, never = 300;
  double tangential = 0, springs = 0, normal = 0, overlaps = 0;
  std::size_t count = 0;
  const std::size_t stride = rules.closely || contacts.empty() ? 1 : 1 + (contacts.size() - 1) / sample;
  for (std::size_t i = 0; i < contacts.size(); i += stride) {
    const Contact& contact = contacts[i];
    if (!(std::abs(contact.spring) > 0)) continue;
    const double pushing = -contact.force.dot(contact.normal);
    ++count;
    tangential += std::abs(contact.force.dot(Vector2d(-contact.normal.y(), contact.normal.x())));
    springs += std::abs(contact.spring);
    normal += std::abs(pushing);
    overlaps += std::abs(contact.overlap);
  }
  if (count < enough || !(tangential > 0 && normal > 0)) return;
  const double ratio = tangential / springs * overlaps / normal;
  const auto beyond = [&](double bound) { return ratio > bound || ratio < 1 / bound; };
  constexpr const char* text =
      "f_t over the tangential springs is not within a factor of a hundred of f_n over the overlaps "
      "(springs of another unit, or another quantity in their column?)";
  // A metre taken for a millimetre is no matter of fast motion: one frame tells.
  if (beyond(never))
    rules.notes->add(text, rules.step);
  else if (rules.closely)
    rules.notes->judge(text, beyond(most), rules.step);
}

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
  if (joiner.walls() > 0) {
    note_wall_forces(contacts, rules);
    note_walls_twice(contacts, discs.particles, *rules.notes, rules.step);
  }
  if (left_out > 0)
    rules.notes->add("near pairs without force that do not touch are no contacts, left out", rules.step,
                     left_out);
  if (joiner.deep() > 0)
    rules.notes->add(
        "contacts overlap by more than half of the smaller radius (k_n too small for the load, or a density "
        "in kg/m^3 where rho h in kg/m^2 was meant?)",
        rules.step, joiner.deep());
  return contacts;
}

}  // namespace mikromakro
