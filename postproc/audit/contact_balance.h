// SPDX-License-Identifier: GPL-2.0-or-later
// Balances that follow directly from contacts: torque on the wheel, and distance of the discs from
// equilibrium.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/frame.h"

namespace mikromakro {

/// Which contacts count.
struct ContactBalanceOptions {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< of the wheel, m
  std::vector<int> bulk_types;                       ///< empty: all types but those of the wheel
  std::vector<int> wheel_types;                      ///< types of the wheel's discs, may be empty
};

/// Means over the added frames.
class ContactBalance {
 public:
  explicit ContactBalance(const ContactBalanceOptions& options) : options_(options) {}

  void add(const Frame& frame);

  /// Torque of the bulk discs on the wheel about the centre, N m, counter-clockwise positive: sum over
  /// contacts of (r_c - centre) x (-f), where f acts on the bulk disc and r_c is the contact point (in the
  /// middle of the overlap, at the image of the bulk disc nearest to the centre). The wheel consists of the
  /// discs of its types and the inner ring (id2 = 0). nan if no contact with it was ever present.
  double wheel_torque() const;

  /// Mean over bulk discs with contacts of |sum of their contact forces|, relative to the mean |f| of their
  /// contacts: 0 in static equilibrium. nan without contacts.
  double force_residual() const;

 private:
  bool is_bulk(const Frame& frame, int particle) const;
  bool is_wheel(const Frame& frame, const Contact& contact, int particle) const;
  Eigen::Vector2d nearest_image(const Box& box, const Eigen::Vector2d& place) const;
  double torque_on_wheel(const Frame& frame, const Contact& contact, bool bulk_is_first);

  ContactBalanceOptions options_;
  std::int64_t frames_ = 0;
  std::int64_t wheel_contacts_ = 0;
  double torque_ = 0;
  std::int64_t discs_ = 0;
  double residual_ = 0;
  std::int64_t contacts_ = 0;
  double force_ = 0;
};

}  // namespace mikromakro
