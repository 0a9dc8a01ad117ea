// SPDX-License-Identifier: GPL-2.0-or-later
// From discs and contacts to fields; contains the only loop over discs.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "averaging/contact_lists.h"
#include "averaging/volumes/volumes.h"
#include "averaging/weight.h"
#include "fields/field_registry.h"
#include "model/frame.h"

namespace mikromakro {

/// Where the branch vector of a contact ends: l = a_p n as in Latzel2001, or at the contact point in the
/// middle of the overlap. `by_weight` selects radius, but contact for kernels, so that the two branches of a
/// contact meet and momentum balances.
enum class Branch { by_weight, radius, contact };

/// Values of the caller's own fields (fields/given_quantity.h) for the discs of a frame, discs x numbers;
/// called by several threads.
using GivenValues = std::function<Rows(const Frame&)>;

/// Which discs are averaged, and how.
struct AveragingOptions {
  std::vector<int> bulk_types;  ///< empty: all; discs of other types are walls
  Branch branch = Branch::by_weight;
  bool height_known = true;  ///< false: the height counts as 1, and quantities per area are per length
  GivenValues given = {};    ///< needed if any of the fields is the caller's own
};

/// Latzel2001 Eq. 4, Q = 1/V sum_p w^p V^p Q^p, for all volumes and fields at once.
class Averager {
 public:
  Averager(std::unique_ptr<const Volumes> volumes, std::unique_ptr<const Weight> weight, FieldList fields,
           const AveragingOptions& options);

  /// sum_p w^p V^p Q^p of one frame: volumes x numbers, the numbers of all fields side by side. It depends on
  /// the frame alone, so frames can be summed independently; discs are summed in the order of the frame. Each
  /// periodic image of a disc counts, with the contacts of the disc and the basis at its own position. Throws
  /// (bad input) if there are too many images.
  Rows frame_sums(const Frame& frame) const;

  /// Numbers of rows and columns of such sums.
  Eigen::Index volume_count() const { return volumes_->count(); }
  Eigen::Index sum_count() const { return static_cast<Eigen::Index>(offsets_.back()); }

  /// The output columns, of the fields that were requested.
  std::vector<Column> columns() const;
  /// The fields that these columns belong to, in order.
  std::vector<ColumnsOfField> columns_of_fields() const;
  /// For each of these columns, whether it is a sum over V (fields/volume_sum.h).
  std::vector<bool> volume_sums() const;
  /// Values of the columns, from the mean of such sums.
  Rows values(const Rows& mean_sums) const;
  /// The columns that describe the volumes.
  Table volumes() const;
  /// The values, preceded by these columns.
  Table solve(const Rows& mean_sums) const;

  /// Remarks of the fields on their columns.
  std::vector<std::string> notes(const Rows& mean_sums) const;

  /// What the dumps must contain for the requested fields and branch vectors.
  ColumnSet particles_needed() const;
  ColumnSet contacts_needed() const;
  bool needs_contacts() const;
  /// Whether any field depends on branch vectors, or any column on the height.
  bool uses_branches() const;
  bool uses_height() const;

  /// The branch vector in use, never by_weight.
  Branch branch() const { return branch_; }
  const std::vector<int>& bulk_types() const { return options_.bulk_types; }

 private:
  struct Scratch;
  // The averaged discs of a frame, and their mean radius.
  struct Bulk {
    std::vector<bool> holds;  // by disc index
    double mean_radius = 0;
  };
  bool is_bulk(const Particle& particle) const;
  Bulk bulk_of(const Frame& frame) const;
  Rows numbers(std::size_t field, const Rows& mean_sums, const std::vector<Rows>& solved) const;
  double cut_of(const Contact& contact) const;
  double reach_of(const Frame& frame, int particle, std::span<const ContactEnd> ends) const;
  void add_image(const Frame& frame, int particle, const Eigen::Vector2d& centre,
                 std::span<const ContactEnd> ends, Scratch& scratch, Rows& sums) const;
  void collect(const Frame& frame, int particle, const Eigen::Vector2d& centre,
               std::span<const ContactEnd> ends, Scratch& scratch) const;
  DiscContact contact_of(const Frame& frame, const ContactEnd& end, const Scratch& scratch) const;
  void add_placed(const Eigen::Vector2d& centre, Scratch& scratch, Rows& sums) const;
  void add_contact(ContactPlace place, const DiscContact& contact, Scratch& scratch, Rows& sums) const;

  std::unique_ptr<const Volumes> volumes_;
  std::unique_ptr<const Weight> weight_;
  std::unique_ptr<const Shares> shares_;  ///< of the weight in the volumes
  FieldList fields_;
  std::vector<std::size_t> offsets_;               ///< first number of each field, then the total
  std::vector<std::vector<std::size_t>> sources_;  ///< of each field, as indices
  AveragingOptions options_;
  Branch branch_;
  bool on_branches_ = false;  ///< whether any field's contacts count along their branches
  bool at_walls_ = false;     ///< or at walls
};

}  // namespace mikromakro
