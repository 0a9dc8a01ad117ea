// SPDX-License-Identifier: GPL-2.0-or-later
#include "joining/row_force.h"

#include <fmt/format.h>

#include <cmath>

namespace mikromakro {
namespace {

using enum ContactColumn;
using Eigen::Vector2d;

constexpr ColumnSet force_columns = column_set(fx, fy);
constexpr ColumnSet components_of_force = column_set(fn, ft);

Vector2d tangent_of(const Contact& contact) {
  return {-contact.normal.y(), contact.normal.x()};
}

}  // namespace

std::string text_of(const Vector2d& vector) {
  return fmt::format("{:.9g} {:.9g}", vector.x(), vector.y());
}

std::string pair_name(const Contact& contact) {
  return contact.with_wall() ? fmt::format("disc {} and wall {}", contact.id1, contact.id2)
                             : fmt::format("discs {} and {}", contact.id1, contact.id2);
}

void set_force(const RowView& row, Contact& contact) {
  contact.force = row.has(force_columns) || !row.has(components_of_force)
                      ? row.place(fx, fy)
                      : Vector2d(-row[fn] * contact.normal + row[ft] * tangent_of(contact));
  contact.spring = row.has(column_set(shearx, sheary)) && !row.has(xi)
                       ? row.place(shearx, sheary).dot(tangent_of(contact))
                       : row[xi];
}

void check_spring(const RowView& row, const Contact& contact, const ContactRows& rows) {
  if (!row.has(column_set(shearx, sheary))) return;
  const Vector2d shear = row.place(shearx, sheary);
  constexpr double turned = 0.05;  // rotation of the normal since the spring was last rotated with it
  if (!(std::abs(shear.dot(contact.normal)) > turned * shear.norm())) return;
  throw bad_input(
      rows.place(row.index),
      fmt::format("shearx sheary is not a spring of {} (columns of another quantity?)", pair_name(contact)),
      fmt::format("a vector along the tangent {}", text_of(tangent_of(contact))), text_of(shear));
}

void check_components(const RowView& row, const Contact& contact, double normal_error,
                      const ContactRows& rows) {
  if (!row.has(force_columns) || (row.given & components_of_force) == 0) return;
  const Vector2d right(-contact.force.dot(contact.normal), contact.force.dot(tangent_of(contact)));
  const Vector2d told(row.has(fn) ? row[fn] : right.x(), row.has(ft) ? row[ft] : right.y());
  const double allowed = contact.force.lpNorm<1>() * (six_digits + normal_error);
  if ((told - right).lpNorm<Eigen::Infinity>() <= allowed) return;
  throw bad_input(rows.place(row.index), fmt::format("fn ft is not that of fx fy of {}", pair_name(contact)),
                  fmt::format("{} within {:.2g} N", text_of(right), allowed), text_of(told));
}

}  // namespace mikromakro
