// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/nonlinear_errors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "averaging/pseudo_values.h"
#include "fields/field_registry.h"

namespace mikromakro {
namespace {

constexpr double rounding = 1e-12;

Rows rows_of(Eigen::Index volumes, std::initializer_list<double> row) {
  Rows rows(volumes, static_cast<Eigen::Index>(row.size()));
  Eigen::Index column = 0;
  for (const double value : row) rows.col(column++) = value;
  return rows;
}

const ColumnsOfField axes = {
    "axes", 3, {{"trace", "", "", ""}, {"dev", "", "", "", 0, true}, {"angle", "", "", "", 180}}};

// Eight blocks, by turns d and -d: the halves of the first Walsh function are d and -d, those of the six
// others 0. The mean of squares of these halves is d^2 and 0 above the square of the whole, (d^4/7)^0.5 in
// the root of their mean square; what is linear in the sums does not bend.
TEST(PseudoValues, BendByTheSecondOrderBetweenHalves) {
  constexpr double d = 3, mean = 5;
  std::vector<Rows> blocks;
  blocks.reserve(8);
  for (int i = 0; i < 8; ++i) blocks.push_back(rows_of(1, {mean + (i % 2 == 0 ? d : -d)}));
  const PseudoValues values = pseudo_values(
      blocks, [](const Rows& sums) { return Rows((Rows(1, 2) << sums.square(), 2 * sums + 1).finished()); },
      {{"all", 2}});
  EXPECT_NEAR(values.curvature(0, 0), d * d / std::sqrt(7.0), rounding * mean * mean);
  EXPECT_NEAR(values.curvature(0, 1), 0, rounding * mean);
}

// An angle of 90 degrees on either side of its seam does not bend.
TEST(PseudoValues, OfAnglesBendAroundTheirSeam) {
  std::vector<Rows> blocks;
  blocks.reserve(8);
  for (int i = 0; i < 8; ++i) blocks.push_back(rows_of(1, {i % 2 == 0 ? 1.0 : -1.0}));
  const Solver angle = [](const Rows& sums) { return Rows(sums + (sums > 1e-9).select(-90, 90 + 0 * sums)); };
  const PseudoValues values =
      pseudo_values(blocks, angle, {{"axes", 1, {{"angle", "degree", "-", "", 180}}}});
  EXPECT_NEAR(values.curvature(0, 0), 0, rounding * 90);
}

// A disc that is there in one block of eight is missing in one half of each division.
TEST(PseudoValues, AreNotKnownToBendWhereAHalfIsUndefined) {
  std::vector<Rows> blocks(8, rows_of(1, {0}));
  blocks[3] = rows_of(1, {2});
  const PseudoValues values =
      pseudo_values(blocks, [](const Rows& sums) { return Rows(sums / sums); }, {{"all", 1}});
  EXPECT_TRUE(std::isnan(values.curvature(0, 0)));
}

// Errors of lengths contain twice the curvature by squares, (3^2 + (2 2)^2)^0.5 = 5, however large it is.
TEST(NonlinearErrors, OfLengthsContainTheirBiasAndAreNeverWithheld) {
  Rows error = rows_of(2, {1, 3, nan("")});
  const NonlinearErrors made = correct_nonlinear(axes, rows_of(2, {20, 1, 0}), rows_of(2, {0, 2, 0}), error);
  EXPECT_TRUE(made.curved.empty());
  for (int row = 0; row < 2; ++row) {
    EXPECT_NEAR(error(row, 1), 5, rounding);
    EXPECT_EQ(error(row, 0), 1);
  }
}

// Deviators of 3.9, 4.1 and 10 errors: none, and (1 + 8/4.1^2)^0.5 and (1 + 8/10^2)^0.5 times the error.
TEST(NonlinearErrors, OfDirectionsNeedADeviatorOfFourErrors) {
  Rows values = rows_of(3, {20, 0, 30}), error = rows_of(3, {1, 2, 0.5});
  values.col(1) << 2 * 3.9, 2 * 4.1, 2 * 10;
  const NonlinearErrors made = correct_nonlinear(axes, values, rows_of(3, {0, 0, 0.2}), error);
  EXPECT_EQ(made.undirected, 1);
  EXPECT_TRUE(made.curved.empty());
  EXPECT_TRUE(std::isnan(error(0, 2)));
  EXPECT_NEAR(error(1, 2), 0.5 * std::sqrt(1 + 8 / (4.1 * 4.1)), rounding);
  EXPECT_NEAR(error(2, 2), 0.5 * std::sqrt(1.08), rounding);
}

// Without the error of its deviator nothing is known of a direction.
TEST(NonlinearErrors, OfDirectionsNeedTheErrorOfTheirDeviator) {
  Rows error = rows_of(1, {1, nan(""), 0.5});
  correct_nonlinear(axes, rows_of(1, {20, 5, 30}), Rows::Zero(1, 3), error);
  EXPECT_TRUE(std::isnan(error(0, 2)));
}

// The median over eight volumes of (C/e)^2 may be 1/16/(1 + 8/8) = 1/32; one volume that bends without limit
// does not count. All have errors, or none: which would be wanting frames by the factor it is too large.
TEST(NonlinearErrors, OfQuotientsAreWithheldByTheMedianOfAllVolumes) {
  const ColumnsOfField field = {"stiffness", 1, {{"mu_c", "Pa", "", ""}}};
  for (const double square : {0.9, 1.1, 3.0}) {
    Rows error = Rows::Ones(8, 1), curvature = Rows::Constant(8, 1, std::sqrt(square / 32));
    curvature(5, 0) = 1e9;
    const NonlinearErrors made = correct_nonlinear(field, Rows::Ones(8, 1), curvature, error);
    if (square < 1) {
      EXPECT_TRUE(made.curved.empty());
      EXPECT_NEAR(error(0, 0), std::sqrt(1 + 4 * square / 32), rounding);
      continue;
    }
    ASSERT_EQ(made.curved.size(), 1U);
    EXPECT_EQ(made.curved[0].name, "mu_c");
    EXPECT_NEAR(made.curved[0].frames_needed, square, rounding);
    EXPECT_TRUE(error.isNaN().all());
  }
}

// One volume must not bend by more than 1/12 of its error: (1/16/9)^0.5.
TEST(NonlinearErrors, OfFewVolumesNeedMore) {
  const ColumnsOfField field = {"stiffness", 1, {{"mu_c", "Pa", "", ""}}};
  for (const double curvature : {0.99 / 12, 1.01 / 12}) {
    Rows error = Rows::Ones(1, 1);
    correct_nonlinear(field, Rows::Ones(1, 1), Rows::Constant(1, 1, curvature), error);
    EXPECT_EQ(std::isfinite(error(0, 0)), curvature < 1.0 / 12);
  }
}

// The column before each angle is the length that it belongs to: of all fields there are.
TEST(NonlinearErrors, FindTheLengthBeforeEachAngle) {
  FieldOptions options;
  options.normal_stiffness = options.friction_coefficient = 1;
  options.histogram_bins = 4;
  int angles = 0;
  for (const ListedField& listed : make_fields({"all"}, options)) {
    const std::vector<Column> columns = listed.field->columns({"r", "phi"});
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i].unit != "degree") continue;
      ++angles;
      ASSERT_GT(i, 0U) << columns[i].name;
      EXPECT_TRUE(columns[i].period > 0 && columns[i - 1].length) << columns[i].name;
    }
  }
  EXPECT_EQ(angles, 5);  // of stress, strain and fabric, and of two harmonics
}

}  // namespace
}  // namespace mikromakro
