// SPDX-License-Identifier: GPL-2.0-or-later
// Output of `compare`.
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

/// Profiles with identical columns; the first weight at each resolution is the reference.
struct Comparison {
  std::vector<std::string> weights;
  std::vector<int> resolutions;
  std::vector<Profile> profiles;  ///< all weights for each resolution, in the order of both lists
  std::vector<Column> columns;    ///< those after the coordinates
  std::vector<bool> volume_sums;  ///< for each column, see Averager::volume_sums

  const Profile& at(std::size_t resolution, std::size_t weight) const {
    return profiles[resolution * weights.size() + weight];
  }
};

/// A column of the rows of a profile; columns are counted without the coordinates.
Eigen::ArrayXd column_of(const Comparison& comparison, const Rows& rows, std::size_t column);
/// Indices of the resolutions, coarse to fine.
std::vector<std::size_t> ascending(const std::vector<int>& resolutions);

/// One line per column, resolution and weight: mean and largest absolute difference from the first weight, in
/// the column's unit and relative to the root mean square of the reference.
std::string differences_of_weights(const Comparison& comparison);

/// For columns that are sums over V, one line per column, weight and pair of adjacent resolutions: the
/// difference between the finer average, averaged onto the coarser volumes, and the coarser one; and the
/// difference between the finer average and the coarser volumes that contain its volumes, i.e. the detail
/// that the coarser average misses. Both relative to the root mean square of the coarser average. Empty for
/// one resolution or if there are no such columns.
std::string differences_of_resolutions(const Comparison& comparison);

/// Five lines on both: what is compared; how far each weight is from the first in the median of the columns;
/// where most; how well fine averages add up to coarse ones; what coarse ones hide. All are means over the
/// volumes relative to the rms of the reference, of columns for which there is one.
std::string summary_of(const Comparison& comparison);

/// The lines above all profiles stacked, with columns for weight and resolution behind the leading ones; and
/// the rows, which begin with the numbers of those.
std::string long_head(const Preamble& preamble, const Comparison& comparison,
                      const std::vector<Column>& leading);
std::string long_rows(const Comparison& comparison, const Eigen::ArrayXd& leading);

/// Both, without leading columns.
std::string long_csv(const Preamble& preamble, const Comparison& comparison);

}  // namespace mikromakro
