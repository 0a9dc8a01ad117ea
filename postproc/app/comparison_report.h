// SPDX-License-Identifier: GPL-2.0-or-later
// What `compare` prints and writes.
#pragma once

#include <string>
#include <vector>

#include "io/tables/csv_writer.h"
#include "model/table.h"

namespace mikromakro {

/// The average with one weight at one resolution.
struct Profile {
  std::string weight;
  int resolution = 0;
  Table table;
};

/// Profiles of the same columns; the first weight of each resolution is the reference.
struct Comparison {
  std::vector<std::string> weights;
  std::vector<int> resolutions;
  std::vector<Profile> profiles;  ///< all weights for each resolution, in the order of both lists
  std::vector<Column> columns;    ///< those behind the coordinates
  std::vector<bool> volume_sums;  ///< for each of them, see Averager::volume_sums

  const Profile& at(std::size_t resolution, std::size_t weight) const {
    return profiles[resolution * weights.size() + weight];
  }
};

/// A line per column, resolution and weight: mean and largest absolute difference from the first weight, in
/// the column's unit and over the root mean square of the reference.
std::string differences_of_weights(const Comparison& comparison);

/// For columns that are sums over V, a line per column, weight and pair of neighbouring resolutions:
/// differences of the finer average, averaged onto the coarser volumes, from the coarser one; and of the
/// finer one from the coarser volumes in which its volumes lie, that is what the coarser one does not show.
/// Both over the root mean square of the coarser one. Empty for one resolution or no such columns.
std::string differences_of_resolutions(const Comparison& comparison);

/// All profiles one below the other, with weight and resolution in front.
std::string long_csv(const Preamble& preamble, const Comparison& comparison);

}  // namespace mikromakro
