// SPDX-License-Identifier: GPL-2.0-or-later
// Which periodic image of a disc a contact row refers to.
#pragma once

#include "joining/contact_tolerance.h"
#include "model/branch_images.h"
#include "model/contact_rows.h"

namespace mikromakro {

/// One row with its available columns.
struct RowView {
  const ContactRow& numbers;
  ColumnSet given;
  std::size_t index;  ///< among all rows of the frame

  double operator[](ContactColumn column) const { return numbers[column]; }
  bool has(ColumnSet columns) const { return (columns & ~given) == 0; }
  bool has(ContactColumn column) const { return has(column_bit(column)); }
  Eigen::Vector2d place(ContactColumn x, ContactColumn y) const { return {numbers[x], numbers[y]}; }
};

/// The branch vector (m) from disc 1 to the image of disc 2 that a row refers to.
///
/// It is given by the row's normal or positions; if there is a column `periodic`, only for rows where it is
/// 1. Otherwise it is the nearest image. Stock LIGGGHTS sets periodic = 1 for contacts with any ghost and
/// wraps their positions, so the partner is either an image or an unshifted disc owned by another rank.
class RowBranch {
 public:
  RowBranch(const ContactRows& rows, const Box& box, const ContactTolerance& tolerance)
      : rows_(rows), box_(box), images_(box), discs_are_better_(tolerance.discs_are_better()) {}

  const BranchImages& images() const { return images_; }

  /// `between`: centre to centre in the file; `reach`: a_1 + a_2; `slack`: tolerance due to rounding. Throws
  /// on periodic = 1 for discs that are far apart in a non-periodic box, and if two images touch and the row
  /// does not say which.
  Eigen::Vector2d of(const RowView& row, const Eigen::Vector2d& between, double reach, double slack) const;

 private:
  Eigen::Vector2d by_places(const RowView& row, double reach, double slack) const;
  Eigen::Vector2d direct_or_image(const RowView& row, const Eigen::Vector2d& branch, double reach,
                                  double slack) const;
  Eigen::Vector2d touching_image(const RowView& row, const Eigen::Vector2d& branch, double reach,
                                 double slack) const;
  Eigen::Vector2d by_normal(const RowView& row, const Eigen::Vector2d& branch, double reach) const;
  bool both_inside(const RowView& row) const;
  [[noreturn]] void refuse_images(const RowView& row) const;

  const ContactRows& rows_;
  const Box& box_;
  BranchImages images_;
  bool discs_are_better_;
};

}  // namespace mikromakro
