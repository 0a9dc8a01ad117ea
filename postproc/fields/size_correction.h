// SPDX-License-Identifier: GPL-2.0-or-later
// The correction g_2 for discs of different sizes (Latzel2001 Eq. 10).
#pragma once

#include "fields/field.h"

namespace mikromakro {

/// g_2 = <a^2/Omega> / (<a^2> <1/Omega>), Omega(a) = 2 asin(m/(m + a)) the angle that a disc of the mean
/// radius m covers at one of radius a; g2_linear = 1 + (sqrt(3)/pi) (<a^3>/(<a><a^2>) - 1), its linear form
/// for narrow distributions. Means over the discs of the volume by number, each by its part in it; m is the
/// mean over all averaged discs of the frame. Madadi2001, as in docs/conventions.md. nan where there is no
/// disc.
class SizeCorrection : public Field {
 public:
  std::string_view name() const override { return "g2"; }
  std::vector<Column> columns(const Axes& axes) const override;
  int sums() const override { return 6; }
  void add_disc(const Disc& disc, std::span<double> quantity) const override;
  void solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const override;
};

}  // namespace mikromakro
