// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/curvature.h"

#include <cmath>
#include <limits>

#include "fields/branch_dyad.h"
#include "fields/cross_product.h"

namespace mikromakro {
namespace {

// Offsets of the sums: from springs, from forces, magnitudes of the springs, of all tangential forces, of
// those without a spring and of all forces, l (x) l.
constexpr int of_springs = 0;
constexpr int of_forces = 2;
constexpr int spring_size = 4;
constexpr int all_tangential = 5, without_spring = 6, all_forces = 7;
constexpr int dyad = 8;

// A tangential force below this fraction of the force is rounding from a law without friction.
constexpr double no_friction = 1e-9;

// One choice for all volumes: a volume without tangential forces is subject to the same law as the others.
bool has_springs(const ConstRowsRef& numbers) {
  return (numbers.col(spring_size) > 0).any();
}

// Tangential forces of a law without friction that are rounding: of forces and of normals that follow from
// places, both with six digits.
bool are_rounding(const ConstRowsRef& numbers) {
  constexpr double digits_of_dumps = 1e-4;
  const double tangential = numbers.col(all_tangential).sum();
  return tangential > 0 && tangential < digits_of_dumps * numbers.col(all_forces).sum();
}

// Frames of two laws, or some of whose rows give no springs: neither displacement is that of all contacts.
// Springs that have only just been created may be 0.
bool are_mixed(const ConstRowsRef& numbers) {
  constexpr double few = 0.01;
  return has_springs(numbers) && numbers.col(without_spring).sum() > few * numbers.col(all_tangential).sum();
}

}  // namespace

std::vector<Column> Curvature::columns(const Axes& axes) const {
  const std::string text = "curvature; its displacement is named in the note above";
  return {{"kappa_z" + axes[0], "m", "Latzel2001 Table 2", text},
          {"kappa_z" + axes[1], "m", "Latzel2001 Table 2", text}};
}

int Curvature::sums() const {
  return dyad + branch_dyad_sums;
}

void Curvature::add_contacts(const Disc& /*disc*/, std::span<const DiscContact> contacts,
                             std::span<double> quantity) const {
  for (const DiscContact& contact : contacts) {
    const double arm = cross(contact.branch, contact.tangent());
    const double spring = std::isnan(contact.spring) ? 0.0 : contact.spring;
    const double tangential = contact.force.dot(contact.tangent());
    const double force = std::abs(tangential) > no_friction * contact.force.norm() ? tangential : 0.0;
    for (int axis = 0; axis < 2; ++axis) {
      const auto place = static_cast<std::size_t>(axis);
      quantity[of_springs + place] -= spring * arm * contact.branch[axis];
      quantity[of_forces + place] += force * arm * contact.branch[axis];
    }
    quantity[spring_size] += std::abs(spring);
    quantity[all_tangential] += std::abs(force);
    quantity[all_forces] += contact.force.norm();
    if (spring == 0) quantity[without_spring] += std::abs(force);
  }
  add_branch_dyad(contacts, quantity.subspan(dyad));
}

void Curvature::solve(const VolumeData& /*volumes*/, const ConstRowsRef& numbers, RowsRef columns) const {
  const bool springs = has_springs(numbers);
  if (are_mixed(numbers) || (!springs && (!(normal_stiffness_ > 0) || are_rounding(numbers)))) {
    columns = std::numeric_limits<double>::quiet_NaN();
    return;
  }
  const double per_number = springs ? 1.0 : 1.0 / normal_stiffness_;
  for (Eigen::Index row = 0; row < numbers.rows(); ++row) {
    const auto sums = numbers_of(numbers, row, springs ? of_springs : of_forces, 2);
    const Eigen::Matrix2d inverse = inverse_branch_dyad(numbers_of(numbers, row, dyad, branch_dyad_sums));
    const Eigen::RowVector2d curvature = per_number * Eigen::RowVector2d(sums[0], sums[1]) * inverse;
    columns.row(row) << curvature[0], curvature[1];
  }
}

std::string Curvature::note(const ConstRowsRef& numbers) const {
  if (are_mixed(numbers))
    return "curvature: some tangential forces have springs and others have none (frames of two laws, or rows "
           "without "
           "their column?), not defined";
  if (has_springs(numbers)) return "curvature: Delta_t = -xi t, from the tangential springs";
  if (!(normal_stiffness_ > 0)) return "curvature: no tangential springs and no --kn, not defined";
  if (are_rounding(numbers)) return "curvature: tangential forces do not exceed rounding, not defined";
  return "curvature: no tangential springs, Delta_t = f_t/k_n";
}

}  // namespace mikromakro
