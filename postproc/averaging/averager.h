// SPDX-License-Identifier: GPL-2.0-or-later
// From discs and contacts to fields: the only loop over discs.
#pragma once

#include <memory>
#include <vector>

#include "averaging/contact_lists.h"
#include "averaging/volumes/volumes.h"
#include "averaging/weight.h"
#include "fields/field_registry.h"
#include "model/frame.h"

namespace mikromakro {

/// Where the branch vector of a contact ends: l = a_p n as in Latzel2001, or at the contact point in the
/// middle of the overlap. By the weight: radius, but contact for kernels, so that both branches of a contact
/// meet and momentum balances.
enum class Branch { by_weight, radius, contact };

/// Which discs are averaged, and how.
struct AveragingOptions {
  std::vector<int> bulk_types;  ///< empty: all; discs of other types are walls
  Branch branch = Branch::by_weight;
  bool height_known = true;  ///< false: it counts as 1, and what is given per area is per length
};

/// Seed Eq. 4, Q = 1/V sum_p w^p V^p Q^p, for all volumes and fields at once.
class Averager {
 public:
  Averager(std::unique_ptr<const Volumes> volumes, std::unique_ptr<const Weight> weight, FieldList fields,
           const AveragingOptions& options);

  /// sum_p w^p V^p Q^p of one frame: volumes x numbers, the fields' numbers side by side. Depends on the
  /// frame only, so that frames can be summed apart from each other; discs are summed in the order of the
  /// frame. A disc counts with each of its images through the periodic boundaries of the frame's box, which
  /// has the contacts of the disc and the basis of its own place. Throws (bad input) where there are too
  /// many.
  Rows frame_sums(const Frame& frame) const;

  /// Rows and columns of such sums.
  Eigen::Index volume_count() const { return volumes_->count(); }
  Eigen::Index sum_count() const { return static_cast<Eigen::Index>(offsets_.back()); }

  /// The columns of the fields that were asked for.
  std::vector<Column> columns() const;
  /// Whose they are, in their order.
  std::vector<ColumnsOfField> columns_of_fields() const;
  /// For each of them, whether it is a sum over V (fields/volume_sum.h).
  std::vector<bool> volume_sums() const;
  /// Their values from the mean of such sums.
  Rows values(const Rows& mean_sums) const;
  /// Both, after the columns that describe the volumes.
  Table solve(const Rows& mean_sums) const;

  /// What the fields have to say about their columns.
  std::vector<std::string> notes(const Rows& mean_sums) const;

  /// What the dumps must contain for the fields (and the branch) that were asked for.
  ColumnSet particles_needed() const;
  ColumnSet contacts_needed() const;
  bool needs_contacts() const;

  /// The one that was chosen.
  Branch branch() const { return branch_; }
  const std::vector<int>& bulk_types() const { return options_.bulk_types; }

 private:
  struct Scratch;
  // Of all discs of a frame, and their mean radius.
  struct Bulk {
    std::vector<bool> holds;  // by the index of the disc
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
  std::vector<std::size_t> offsets_;               ///< of each field's numbers; the last one is their total
  std::vector<std::vector<std::size_t>> sources_;  ///< of each field, as indices
  AveragingOptions options_;
  Branch branch_;
  bool on_branches_ = false;  ///< whether a field's contacts have shares along their branches
  bool at_walls_ = false;     ///< or at walls
};

}  // namespace mikromakro
