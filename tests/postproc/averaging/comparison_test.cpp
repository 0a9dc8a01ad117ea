// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "averaging/volumes/grid_volumes.h"
#include "averaging/volumes/sector_volumes.h"
#include "measured_error.h"
#include "ring_average.h"

namespace mikromakro {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Rows 2 and 3 are left out: 3 - 1, -1 - 1 and 4 - 7.
TEST(Difference, LeavesOutWhatIsUndefinedAndCountsIt) {
  const Difference found = difference(Eigen::ArrayXd{{3, -1, nan, 5, 4}}, Eigen::ArrayXd{{1, 1, 2, nan, 7}});
  EXPECT_EQ(found.rows, 3);
  EXPECT_EQ(found.missing, 2);
  EXPECT_DOUBLE_EQ(found.mean, 7.0 / 3);
  EXPECT_DOUBLE_EQ(found.largest, 3);
  EXPECT_DOUBLE_EQ(found.rms, std::sqrt(51.0 / 3));
  const Difference none = difference(Eigen::ArrayXd{{nan}}, Eigen::ArrayXd{{1}});
  EXPECT_TRUE(std::isnan(none.mean) && std::isnan(none.largest) && std::isnan(none.rms));
  EXPECT_EQ(none.missing, 1);
}

Table table_of(const Volumes& volumes, const std::vector<double>& values) {
  Table table{volumes.columns(),
              Rows(volumes.count(), static_cast<Eigen::Index>(volumes.columns().size()) + 1)};
  table.columns.push_back({"value", "1", "-", ""});
  table.rows.leftCols(table.rows.cols() - 1) = volumes.coordinates();
  for (Eigen::Index i = 0; i < volumes.count(); ++i)
    table.rows(i, table.rows.cols() - 1) = values[static_cast<std::size_t>(i)];
  return table;
}

// Squares of the radii: rings 0..1, 1..4, 4..9 onto 0..2, 2..9 with edges in r^2. The second of the three has
// 1 of its 3 in the first of the two: (1*7 + 1*2)/2 and (2*2 + 5*4)/7.
// 89 and -89 degrees are 2 degrees apart where 180 is the same direction.
TEST(Difference, OfAnglesIsTheSmallerOne) {
  const Eigen::ArrayXd values = Eigen::Array2d(89, -80), reference = Eigen::Array2d(-89, -70);
  EXPECT_DOUBLE_EQ(difference(values, reference, 180).largest, 10);
  EXPECT_DOUBLE_EQ(difference(values, reference, 180).mean, 6);
  EXPECT_DOUBLE_EQ(difference(values, reference).largest, 178);
}

TEST(AveragedOnto, RingsByTheirAreas) {
  const RingVolumes three({1, 2}, {0, 1, 2, 3}, 1);
  const RingVolumes two({1, 2}, {0, std::sqrt(2.0), 3}, 1);
  const Rows sums = averaged_onto(table_of(two, {0, 0}), table_of(three, {7, 2, 4}), 1);
  expect_measured(sums(0, 0), 9.0 / 2, 1e-14);
  expect_measured(sums(1, 0), 24.0 / 7, 1e-14);
  // Back onto the finer ones: whole, half of each, whole.
  const Rows back = averaged_onto(table_of(three, {0, 0, 0}), table_of(two, {3, 9}), 1);
  expect_measured(back(0, 0), 3, 1e-14);
  expect_measured(back(1, 0), (1 * 3 + 2 * 9) / 3.0, 1e-14);
  expect_measured(back(2, 0), 9, 1e-14);
}

// Two rings of two sectors onto the two rings, and three columns by one row onto two by one.
TEST(AveragedOnto, SectorsAndRectanglesByTheirAreas) {
  const auto rings = [] {
    return std::make_unique<const RingVolumes>(Eigen::Vector2d(0, 0), std::vector<double>{0, 1, 2}, 1);
  };
  const Rows of_rings = averaged_onto(table_of(SectorVolumes(rings(), 1), {0, 0}),
                                      table_of(SectorVolumes(rings(), 2), {1, 3, 5, 9}), 1);
  expect_measured(of_rings(0, 0), 2, 1e-14);
  expect_measured(of_rings(1, 0), 7, 1e-14);
  const GridVolumes three({0, 1, 2, 3}, {0, 2}, 1);
  const GridVolumes two({0, 1.5, 3}, {0, 2}, 1);
  const Rows cells = averaged_onto(table_of(two, {0, 0}), table_of(three, {1, 4, 7}), 1);
  expect_measured(cells(0, 0), (1 + 0.5 * 4) / 1.5, 1e-14);
  expect_measured(cells(1, 0), (0.5 * 4 + 7) / 1.5, 1e-14);
}

}  // namespace
}  // namespace mikromakro
