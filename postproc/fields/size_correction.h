// SPDX-License-Identifier: GPL-2.0-or-later
// Polydispersity correction g_2 (Latzel2001 Eq. 10).
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// g_2 = <a^2/Omega> / (<a^2> <1/Omega>), with Omega(a) = 2 asin(m/(m + a)) the angle that a disc of the mean
/// radius m subtends at a disc of radius a; g2_linear = 1 + (sqrt(3)/pi) (<a^3>/(<a><a^2>) - 1), its linear
/// form for narrow distributions. Means are by number over the discs of the volume, each weighted by its
/// fraction in the volume; m is the mean over all averaged discs of the frame. Madadi2001, as in
/// docs/conventions.md. nan where there is no disc.
class SizeCorrection : public Field {
 public:
  std::string_view name() const override { return "g2"; }
  std::vector<Column> columns(const Axes& axes) const override;
  int sums() const override { return 6; }
  void add_disc(const Disc& disc, std::span<double> quantity) const override;
  void solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const override;
};

}  // namespace mikromakro
