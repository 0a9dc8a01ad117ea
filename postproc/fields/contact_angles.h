// SPDX-License-Identifier: GPL-2.0-or-later
// Distribution of the contact directions (Latzel2001 Bild 6).
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// First two harmonics of the density of contact directions theta, counter-clockwise from e_r, with the
/// fabric's weight w V^p: 2 pi P(theta) = 1 + a_2 cos 2(theta - theta_2) + a_4 cos 4(theta - theta_4), a_m =
/// 2 |<exp(i m theta)>|. Hence a_2 = 2 dev F/tr F, and theta_2 is the major axis of F. Angles in degrees, in
/// (-90, 90] and (-45, 45]; nan where the amplitude is 0. All nan where there is no contact.
class ContactAngles : public Field {
 public:
  std::string_view name() const override { return "contact_angles"; }
  std::vector<Column> columns(const Axes& axes) const override;
  bool needs_contacts() const override { return true; }
  int sums() const override { return 5; }
  void add_contacts(const Disc& disc, std::span<const DiscContact> contacts,
                    std::span<double> quantity) const override;
  void solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const override;
};

/// Fraction of the contacts (weight w V^p) in each of equal bins of theta from -180 to 180 degrees; the bins
/// sum to 1. A contact on the edge between two bins, to within 1e-5 of their width, counts half in each. nan
/// where there is no contact.
class ContactAngleHistogram : public Field {
 public:
  explicit ContactAngleHistogram(int bins) : bins_(bins) {}

  std::string_view name() const override { return "contact_angle_histogram"; }
  std::vector<Column> columns(const Axes& axes) const override;
  std::string_view missing_option() const override { return bins_ > 0 ? "" : "--histogram"; }
  bool needs_contacts() const override { return true; }
  int sums() const override { return 1 + bins_; }
  void add_contacts(const Disc& disc, std::span<const DiscContact> contacts,
                    std::span<double> quantity) const override;
  void solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const override;

 private:
  int bins_;
};

}  // namespace mikromakro
