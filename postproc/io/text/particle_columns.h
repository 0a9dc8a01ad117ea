// SPDX-License-Identifier: GPL-2.0-or-later
// Particle columns under all the names used in dumps.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "io/files/column_map.h"
#include "io/text/dump_reader.h"
#include "model/particle_row.h"
#include "model/printed_digits.h"

namespace mikromakro {

/// Which column fills which slot, and how its numbers are converted to those of ParticleColumn: `xs` is
/// scaled by the box, `xu` is unwrapped, `xsu` is both, `diameter` is twice the radius. If a dump has several
/// of them, the first of x, xu, xs, xsu is used, and `radius` in preference to `diameter`.
class ParticleColumns {
 public:
  /// `list`: the names of --particle-columns (empty: the header's own). Throws what map_header and map_option
  /// throw, and if coordinates are scaled but there is no box.
  ParticleColumns(const DumpHeader& header, const std::vector<std::string>& list, const Place& place);

  const ColumnMap& map() const { return map_; }
  bool with_z() const { return with_z_; }

  /// Converts the numbers of a row to x, y, z and radius. Throws if an unwrapped coordinate lies outside a
  /// box whose periodicity is not known.
  void settle(ParticleSlots& row, const Place& place) {
    if (!as_they_are_) convert(row, place);
  }

  /// Rounding error of the converted coordinates, and of radii given as diameters (file units); nan if
  /// nothing was converted, since the digits of the numbers themselves then show it.
  double place_error() const;

 private:
  struct Axis {
    bool scaled = false;
    bool unwrapped = false;
    bool wraps = false;  ///< the box is periodic along this axis
    double low = 0;
    double length = 1;
    PrintedDigits digits = {};  ///< of the unconverted numbers
    double largest = 0;         ///< largest magnitude of these

    void sample(double number) {
      digits.add(number);
      largest = std::max(largest, std::abs(number));
    }
    double error() const;
  };
  void choose(std::vector<std::string>& names);
  void convert(ParticleSlots& row, const Place& place);
  double along(const Axis& axis, double number, const Place& place) const;

  ColumnMap map_;
  std::array<Axis, 3> axes_;
  PrintedDigits diameter_digits_;
  double largest_diameter_ = 0;
  bool boundaries_known_ = true;
  bool diameter_ = false;
  bool with_z_ = false;
  bool as_they_are_ = true;
};

}  // namespace mikromakro
