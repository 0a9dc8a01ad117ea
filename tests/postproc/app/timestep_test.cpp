// SPDX-License-Identifier: GPL-2.0-or-later
// `mikromakro timestep`: the law that it goes by is tested in tests/physics/impact_test.cpp, and against runs
// of the engines in tests/engines/impact_test.cpp.
#include <gtest/gtest.h>

#include "json_number.h"
#include "physics/contact/contact_duration.h"
#include "physics/impact/impact.h"
#include "run_program.h"

namespace mikromakro {
namespace {

// The small discs of the paper's cell.
const std::string discs = "timestep --json --radius 3.71e-3 --density 6.36 ";
const double m12 = 6.36 * M_PI * 3.71e-3 * 3.71e-3 / 2;

TEST(Timestep, TellsDurationAndRestitutionOfTheSeed) {
  const Ran ran = run_program(discs + "--kn 352.1 --gamman 0.19");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NEAR(json_number(ran.out, "t_c") / physics::contact_duration(352.1, 0.19, m12), 1, 1e-14);
  // 2e-6: the small turn of a numerical impact with an overlap of 1e-3 radii.
  EXPECT_NEAR(json_number(ran.out, "e_n"), physics::restitution(352.1, 0.19, m12), 2e-6);
  EXPECT_NEAR(json_number(ran.out, "rule") * 50 / json_number(ran.out, "t_c"), 1, 1e-14);
  EXPECT_NE(ran.out.find("\"dt\":null"), std::string::npos) << ran.out;
}

TEST(Timestep, TakesTheDashpotFromTheRestitution) {
  const Ran ran = run_program(discs + "--kn 352.1 --restitution 0.6");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NEAR(json_number(ran.out, "e_n"), 0.6, 2e-6);
}

TEST(Timestep, ForAnErrorIsTheLongestThatMeetsIt) {
  for (const std::string friction : {"", " --mu 0.44 --kt 281.68", " --mu 0.44 --gammat 0.15"}) {
    const std::string law = discs + "--kn 352.1 --gamman 0.19" + friction;
    const double one = json_number(run_program(law + " --error 2e-3").out, "steps_per_contact"),
                 tenth = json_number(run_program(law + " --error 2e-4").out, "steps_per_contact");
    // Order 1, of the dashpot's jumps: a tenth of the error costs ten times the steps; 10 % of it for the
    // next order at the coarse end, and 2 % by which steps are chosen.
    EXPECT_NEAR(tenth / one, 10, 1.2) << friction;
  }
}

TEST(Timestep, OfAnElasticHertzianImpactHasItsDurationAtTheVelocity) {
  const Ran ran = run_program(discs + "--kn 1e7 --hertz --velocity 0.01 --error 1e-4");
  ASSERT_EQ(ran.code, 0) << ran.err;
  const double k_h = physics::hertz_stiffness(1e7, 3.71e-3 / 2);
  EXPECT_NEAR(json_number(ran.out, "t_c") / physics::hertz_contact_duration(k_h, m12, 0.01), 1, 1e-14);
  const physics::Impact impact{{1e7, 0, 0, 0, 0}, 3.71e-3, 2 * m12, 0.01, 0, json_number(ran.out, "t_c")};
  constexpr physics::Effects hertz{physics::Tangential::none, false, physics::Normal::hertz};
  EXPECT_NEAR(json_number(ran.out, "steps_per_contact"), physics::steps_for_error<hertz>(impact, 1e-4), 1e-9);
}

// Twelve dashpots' rates of a pair's reduced mass: the limit of a packing whose discs all spin alike.
TEST(Timestep, SaysWhereDashpotsMakeAPackingUnstable) {
  const std::string friction = "--kn 352.1 --gamman 0.19 --mu 0.44 --gammat ";
  EXPECT_NEAR(json_number(run_program(discs + friction + "5").out, "stable") * 12 * 5 / m12, 1, 1e-12);
  EXPECT_NEAR(json_number(run_program(discs + friction + "0.01").out, "stable") * 3 * 0.19 / m12, 1, 1e-12);
  EXPECT_NE(run_program(discs + "--kn 352.1").out.find("\"stable\":null"), std::string::npos);
  const std::string plain = "timestep --radius 3.71e-3 --density 6.36 " + friction;
  EXPECT_NE(run_program(plain + "5 --error 0.01").out.find("use dt = "), std::string::npos);
  EXPECT_EQ(run_program(plain + "0.15").out.find("use dt = "), std::string::npos);
}

void expect_complaint(const std::string& arguments, const std::string& what) {
  const Ran ran = run_program("timestep --radius 3.71e-3 " + arguments);
  EXPECT_EQ(ran.code, 2) << arguments;
  EXPECT_EQ(ran.err, "mikromakro: " + what + "\n");
}

TEST(Timestep, SaysWhatMakesNoSense) {
  expect_complaint("--density 6.36 --kn 0", "--kn: invalid value; expected a stiffness above 0, got 0");
  expect_complaint("--density 6.36 --kn 352.1 --restitution 1.2",
                   "--restitution: invalid value; expected a number above 0, at most 1, got 1.2");
  expect_complaint("--density 6.36 --kn 352.1 --gamman 2",
                   "--gamman: the discs do not separate; expected a weaker dashpot, got 2");
  expect_complaint(
      "--density 6.36 --kn 352.1 --gamman 0.19 --error 1e-9",
      "--error: no time step of t_c/4000 or more is that accurate; expected a larger error, got 1e-09");
}

}  // namespace
}  // namespace mikromakro
