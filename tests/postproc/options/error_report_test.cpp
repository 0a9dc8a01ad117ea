// SPDX-License-Identifier: GPL-2.0-or-later
#include "options/error_report.h"

#include <gtest/gtest.h>

#include <string>

namespace mikromakro {
namespace {

// Errors of one field of 100 frames with 2 tau = 4 +- 0.5 frames.
BlockErrors errors_with(const NonlinearErrors& nonlinear, bool given) {
  FieldErrors made;
  made.field = {"stiffness", 3, {}};
  made.series = 12;
  made.correlation.time = 4;
  made.correlation.uncertainty = 0.125;
  made.decision.given = given;
  made.decision.samples = 25;
  made.decision.freedom = 20;
  made.nonlinear = nonlinear;
  BlockErrors errors;
  errors.error = Rows::Ones(1, 1);
  errors.frames = 100;
  errors.enough_blocks = true;
  errors.fields = {made};
  return errors;
}

TimeAverage fifty_blocks() {
  TimeAverage average;
  for (int i = 0; i < 50; ++i) average.add(Rows::Ones(1, 1));
  return average;
}

std::string line_of(const BlockErrors& errors) {
  Preamble lines;
  describe_errors(errors, fifty_blocks(), lines);
  for (const auto& [key, text] : lines)
    if (key == "errors of") return text;
  return "";
}

const NonlinearErrors both = {{{"mu_c", 2.5}}, 3};

TEST(ErrorReport, NamesColumnsAndCountsDirectionsWithoutErrors) {
  const std::string line = line_of(errors_with(both, true));
  EXPECT_EQ(line.find("stiffness: 2 tau = 4 +- 0.5 frames"), 0U) << line;
  EXPECT_NE(
      line.find("; none of mu_c, which is not linear in the sums over the range of its error (2.5 times as "
                "many frames or runs would do)"),
      std::string::npos)
      << line;
  EXPECT_NE(line.find("; none of 3 directions, which are hardly determined"), std::string::npos) << line;
}

TEST(ErrorReport, SaysNothingOfColumnsThatHaveTheirErrors) {
  EXPECT_EQ(line_of(errors_with({}, true)).find("none"), std::string::npos);
}

// "none" comes first if no other column of the field has errors; 2 tau would then read like their origin.
TEST(ErrorReport, OfAFieldOfWithheldColumnsAloneBeginsWithNone) {
  EXPECT_EQ(line_of(errors_with({{{"mu_c", 2.5}}, 0}, false)).find("stiffness: none; none of mu_c,"), 0U);
}

TEST(ErrorReport, HasTheSameInJson) {
  const Json report = error_json(errors_with(both, true), fifty_blocks());
  EXPECT_EQ(report["frames"], 100);
  EXPECT_EQ(report["blocks"], 50);
  const Json& field = report["fields"]["stiffness"];
  EXPECT_EQ(field["nonlinear_columns"], Json::array({"mu_c"}));
  EXPECT_EQ(field["undirected"], 3);
  EXPECT_EQ(field["two_tau"], 4.0);
  EXPECT_EQ(field["two_tau_err"], 0.5);
}

TEST(ErrorReport, HasEmptyListsInJsonWhereNothingIsWithheld) {
  const Json field = error_json(errors_with({}, true), fifty_blocks())["fields"]["stiffness"];
  EXPECT_EQ(field["nonlinear_columns"], Json::array());
  EXPECT_EQ(field["undirected"], 0);
}

}  // namespace
}  // namespace mikromakro
