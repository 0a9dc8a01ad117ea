// SPDX-License-Identifier: GPL-2.0-or-later
// Force and tangential spring of a contact from its row, and whether the row agrees with itself on them.
#pragma once

#include <cmath>
#include <string>

#include "joining/row_branch.h"
#include "model/contact_rows.h"
#include "model/frame.h"

namespace mikromakro {

/// Rounding error of numbers written with six digits, relative to the numbers, with a margin.
inline constexpr double six_digits = 2e-5;

/// Contact::force, from fx, fy or else fn, ft, and Contact::spring, from shearx, sheary (of stock LIGGGHTS:
/// the slip of 1 against 2 as well) or else xi. The normal must have been set.
void set_force(const RowView& row, Contact& contact);

/// Throws if shearx, sheary do not lie along the tangent: a normal force in these columns is no spring.
void check_spring(const RowView& row, const Contact& contact, const ContactRows& rows);

/// Throws if fx, fy and fn, ft are both given and disagree. `normal_error`: error of the normal (rad).
void check_components(const RowView& row, const Contact& contact, double normal_error,
                      const ContactRows& rows);

/// The same as a question, for rows with all four of them and an exact normal.
inline bool are_components(const ContactRow& row, const Contact& contact) {
  const double f_n = -contact.force.dot(contact.normal);
  const double f_t = contact.force.dot(Eigen::Vector2d(-contact.normal.y(), contact.normal.x()));
  const double allowed = six_digits * contact.force.lpNorm<1>();
  return std::abs(row[ContactColumn::fn] - f_n) <= allowed &&
         std::abs(row[ContactColumn::ft] - f_t) <= allowed;
}

/// For messages: "9.81 -0.5", and "discs 3 and 4" or "disc 3 and wall -1".
std::string text_of(const Eigen::Vector2d& vector);
std::string pair_name(const Contact& contact);

}  // namespace mikromakro
