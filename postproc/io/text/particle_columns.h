// SPDX-License-Identifier: GPL-2.0-or-later
// Particle columns by all the names that dumps give them.
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

/// Which column fills which slot, and how its numbers become those of ParticleColumn: `xs` is scaled by the
/// box, `xu` was not brought back into it, `xsu` is both, `diameter` is twice the radius. Where a dump gives
/// several of them, the first of x, xu, xs, xsu counts, and `radius` before `diameter`.
class ParticleColumns {
 public:
  /// `list` are the names of --particle-columns (empty: the header's own). Throws what map_header and
  /// map_option throw, and where coordinates are scaled and there is no box.
  ParticleColumns(const DumpHeader& header, const std::vector<std::string>& list, const Place& place);

  const ColumnMap& map() const { return map_; }
  bool with_z() const { return with_z_; }

  /// Numbers of a row as they stand there into x, y, z and radius. Throws where an unwrapped coordinate lies
  /// outside a box that does not say whether it is periodic.
  void settle(ParticleSlots& row, const Place& place) {
    if (!as_they_are_) convert(row, place);
  }

  /// What the digits of the file leave open of the places that were settled, and of radii that were diameters
  /// (units of the file); nan where all stand as they are: then their own digits say it.
  double place_error() const;

 private:
  struct Axis {
    bool scaled = false;
    bool unwrapped = false;
    bool wraps = false;  ///< the box is periodic here
    double low = 0;
    double length = 1;
    PrintedDigits digits = {};  ///< of the numbers as they stand
    double largest = 0;         ///< of these

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
