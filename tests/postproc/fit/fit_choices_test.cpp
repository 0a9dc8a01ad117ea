// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/fit_choices.h"

#include <gtest/gtest.h>

#include <cmath>

#include "measured_error.h"

namespace mikromakro {
namespace {

constexpr double r_i = 0.1, s = 0.01;

RingProfile profile(bool with_errors) {
  RingProfile profile;
  profile.r = Eigen::ArrayXd::LinSpaced(30, 0.101, 0.159);
  profile.v = 2 * (-(profile.r - r_i) / s).exp();
  if (with_errors) profile.error = 0.01 * profile.v + 0.001;
  return profile;
}

std::vector<std::string> names(const std::vector<FitChoice>& choices) {
  std::vector<std::string> all;
  all.reserve(choices.size());
  for (const FitChoice& choice : choices) all.push_back(choice.name);
  return all;
}

TEST(FitChoices, OfAnExactProfileAgree) {
  const auto choices = fit_choices({profile(true)}, r_i, {}, s, {});
  EXPECT_EQ(choices.size(), 10U);
  for (const FitChoice& choice : choices) {
    expect_measured(choice.v0, 2, 1e-10, choice.name);
    expect_measured(choice.s / s, 1, 1e-10, choice.name);
  }
}

TEST(FitChoices, LeaveWhatWasSaid) {
  const FitWay way{FitOf::v, false, 0.11, 0.15};
  EXPECT_EQ(names(fit_choices({profile(false)}, r_i, way, s, {true, false})),
            (std::vector<std::string>{"v, from 0.11 m, to 0.15 m", "log v, from 0.11 m, to 0.15 m"}));
  EXPECT_EQ(names(fit_choices({profile(true)}, r_i, {FitOf::log_v}, s, {false, true})),
            (std::vector<std::string>{"log v", "log v, to 0.14 m", "log v, from 0.105 m",
                                      "log v, from 0.105 m, to 0.14 m"}));
  std::vector<RingProfile> two = {profile(false), profile(false)};
  two[0].name = "a.csv";
  two[1].name = "b.csv";
  EXPECT_EQ(
      names(fit_choices(two, r_i, way, s, {true, true})),
      (std::vector<std::string>{"v, from 0.11 m, to 0.15 m, a.csv", "v, from 0.11 m, to 0.15 m, b.csv"}));
}

// A plateau of 1 % behind the zone: log v to the end of the zone falls less than v, and s is larger.
TEST(FitChoices, DifferWhereTheProfileIsNoExponential) {
  RingProfile flat = profile(false);
  flat.v += 0.02;
  const auto choices = fit_choices({flat}, r_i, {}, s, {});
  ASSERT_EQ(choices[2].name, "log v, to 0.14 m");
  EXPECT_GT(choices[2].s, 1.05 * choices[1].s);
}

TEST(FitChoices, ThatCannotBeFittedHaveNoNumbers) {
  RingProfile negative = profile(false);
  negative.v[12] = -1e-3;
  const auto choices = fit_choices({negative}, r_i, {}, s, {});
  ASSERT_EQ(choices[2].name, "log v, to 0.14 m");
  EXPECT_TRUE(std::isnan(choices[2].v0));
  EXPECT_NE(choices[2].missing.find("log v is undefined"), std::string::npos) << choices[2].missing;
  EXPECT_EQ(choices[1].missing, "");
  EXPECT_FALSE(std::isnan(choices[1].v0));
}

}  // namespace
}  // namespace mikromakro
