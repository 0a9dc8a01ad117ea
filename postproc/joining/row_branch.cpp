// SPDX-License-Identifier: GPL-2.0-or-later
#include "joining/row_branch.h"

#include <cmath>

namespace mikromakro {
namespace {

using enum ContactColumn;
using Eigen::Vector2d;

constexpr ColumnSet normal_columns = column_set(nx, ny);
constexpr ColumnSet place_columns = column_set(x1, y1, x2, y2);

// As far as the row says.
bool touches(const RowView& row) {
  return (row.has(overlap) && row[overlap] > 0) ||
         (row.has(column_set(fx, fy)) && !row.place(fx, fy).isZero(0));
}

}  // namespace

Vector2d RowBranch::of(const RowView& row, const Vector2d& between, double reach, double slack) const {
  if (row.has(place_columns)) {
    Vector2d branch = by_places(row, reach, slack);
    return discs_are_better_ ? images_.nearest_to(branch, between) : branch;
  }
  if (row.has(normal_columns)) return images_.any() ? by_normal(row, between, reach) : between;
  Vector2d branch = images_.nearest(between);
  // Only the nearest image touches, unless the box is narrower than the two discs.
  if (images_.two_within(reach, branch)) refuse_images(row);
  return branch;
}

Vector2d RowBranch::by_places(const RowView& row, double reach, double slack) const {
  Vector2d branch = row.place(x2, y2) - row.place(x1, y1);
  // Not through an image; but LIGGGHTS wraps places in these rows, and not in its dumps, between two lists.
  if (row.has(periodic) && row[periodic] == 0)
    return branch.norm() <= reach + slack || !touches(row) ? branch : images_.nearest(branch);
  if (row.has(periodic) && !images_.any() && branch.norm() > reach + slack)
    throw bad_input(rows_.place(row.index), "a contact through a periodic boundary in a box that has none",
                    "a periodic box in the dump of particles ('ITEM: BOX BOUNDS pp ...')", "periodic = 1");
  if (row.has(periodic) && images_.any() && both_inside(row))
    return direct_or_image(row, branch, reach, slack);
  if (!row.has(periodic) && images_.two_within(reach, images_.nearest(branch)) && both_inside(row))
    return touching_image(row, branch, reach, slack);
  return branch.norm() <= reach + slack ? branch : images_.nearest(branch);
}

// The partner is an image, or not shifted: the normal decides, or the overlap. Without them, or if the
// overlap fits both, it is the image, as on a single rank.
Vector2d RowBranch::direct_or_image(const RowView& row, const Vector2d& branch, double reach,
                                    double slack) const {
  if (row.has(normal_columns)) return by_normal(row, branch, reach);
  bool direct_fits = false;
  int fitting = 0;
  Vector2d only = images_.nearest_other(branch);
  images_.visit_within(reach + slack, images_.nearest(branch), [&](const Vector2d& image) {
    if (row.has(overlap) && std::abs(reach - image.norm() - row[overlap]) > slack) return;
    if ((image - branch).norm() <= slack) {
      direct_fits = true;
      return;
    }
    only = image;
    ++fitting;
  });
  if (fitting > 1) refuse_images(row);
  return fitting == 0 && direct_fits ? branch : only;
}

// For positions inside the box, possibly wrapped, in a box hardly wider than two discs: the rest of the row
// decides.
Vector2d RowBranch::touching_image(const RowView& row, const Vector2d& branch, double reach,
                                   double slack) const {
  if (row.has(normal_columns)) return by_normal(row, branch, reach);
  int fitting = 0;
  Vector2d only = branch;
  images_.visit_within(reach, images_.nearest(branch), [&](const Vector2d& image) {
    if (row.has(overlap) && std::abs(reach - image.norm() - row[overlap]) > slack) return;
    only = image;
    ++fitting;
  });
  if (fitting > 1) refuse_images(row);
  return only;
}

Vector2d RowBranch::by_normal(const RowView& row, const Vector2d& branch, double reach) const {
  const double gap = row.has(overlap) ? -row[overlap] : 0;
  return images_.nearest_to((reach + gap) * row.place(nx, ny), branch);
}

bool RowBranch::both_inside(const RowView& row) const {
  const auto is_inside = [this](const Vector2d& place) {
    return (place.array() >= box_.low.array()).all() && (place.array() <= box_.high.array()).all();
  };
  return is_inside(row.place(x1, y1)) && is_inside(row.place(x2, y2));
}

void RowBranch::refuse_images(const RowView& row) const {
  throw bad_input(rows_.place(row.index),
                  "the discs touch through two images, and the row does not say which", "columns nx ny",
                  "none");
}

}  // namespace mikromakro
