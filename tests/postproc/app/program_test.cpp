// SPDX-License-Identifier: GPL-2.0-or-later
// The program as a user runs it, on the small pair of dumps in tests/data/good.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <regex>
#include <sstream>

#include "json_number.h"
#include "run_program.h"

namespace mikromakro {
namespace {

const std::string good_files =
    "--particles good/particles.dump --contacts good/contacts.dump --bulk-types 1 ";
const std::string good = good_files + "--rings 0 4 1 ";

// The row of a table with one ring, by column names; 17 digits are printed, so that tests compare to
// rounding.
std::map<std::string, double> only_row(const std::string& text) {
  std::istringstream stream(text);
  std::string names;
  while (std::getline(stream, names) && names.starts_with('#')) {
  }
  std::string values;
  std::getline(stream, values);
  std::istringstream split_names(names);
  std::istringstream split_values(values);
  std::map<std::string, double> row;
  std::string value;
  for (std::string name; std::getline(split_names, name, ',') && std::getline(split_values, value, ',');)
    row[name] = std::strtod(value.c_str(), nullptr);
  return row;
}

// Two frames, h = 1, ring 0..4: V = 16 pi. Free discs (type 1): 7 at (1, 0) with a = 0.5, 3 at (1.9, 0) with
// a = 0.5, 20 at (0, -2) with a = 0.25 without contacts; wall disc 12 at (2.5, 0). Contacts: 7-3, 12-3 and 7
// with the inner ring.
//   nu = (1/4 + 1/4 + 1/16)/16, nu_1 = nu_2 = (1/2)/16, C = (2/4 + 2/4)/(9/16)
//   all normals are along e_r: F_rr = 2 (1/4 + 1/4)/16
//   7: force of 3 on it is (-10, 1), l = (0.5, 0); of the wall (2, 0), l = (-0.5, 0)     rr: -5 - 1, phir:
//   0.5 3: force of 7 on it is (10, -1), l = (-0.5, 0); of 12 (-5, 0), l = (0.5, 0)          rr: -5 - 2.5,
//   phir: 0.5 sigma_rr = -13.5/(16 pi), sigma_phir = 1/(16 pi) v_phi in frame 100: 7 has 1, 3 has -1, 20 has
//   v_x = 4 at (0, -2), e_phi = (1, 0): 4; in frame 200 7 has 3: (1 - 1)/4 + 4/16 and (3 - 1)/4 + 4/16 over
//   9/16: mean (0.25 + 0.75)/2/(9/16) = 8/9
TEST(Average, GoodPairAsWorkedByHand) {
  const Ran ran = run_program("average " + good);
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  auto row = only_row(ran.out);
  constexpr double rounding = 1e-14;
  constexpr double volume = 16 * std::numbers::pi;
  EXPECT_NEAR(row["nu"], 9.0 / 256, rounding);
  EXPECT_NEAR(row["nu_1"], 1.0 / 32, rounding);
  EXPECT_NEAR(row["nu_2"], 1.0 / 32, rounding);
  EXPECT_NEAR(row["nu_3"], 0, rounding);
  EXPECT_NEAR(row["coordination"], 16.0 / 9, rounding);
  EXPECT_NEAR(row["F_rr"], 1.0 / 16, rounding);
  EXPECT_NEAR(row["sigma_rr"], -13.5 / volume, rounding);
  EXPECT_NEAR(row["sigma_phir"], 1 / volume, rounding);
  EXPECT_NEAR(row["v_phi"], 8.0 / 9, rounding);
}

// The same discs in one rectangle of 8 by 8: all normals are along x there, so sigma_xx = -13.5/64, sigma_yx
// = 1/64, F_xx = pi/64; nu = 9 pi/16/64. v_y of 7 and 3 is 1 and -1, then 3 and -1; v_x of 3 is 0.5, of 20 4:
//   v_x = (0.5/4 + 4/16)/(9/16), v_y = ((1 - 1)/4 + (3 - 1)/4)/2/(9/16)
TEST(Average, GoodPairInABoxAsWorkedByHand) {
  const Ran ran = run_program("average " + good_files + "--box -4 4 -4 4");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("\nx_min,x_max,y_min,y_max,x,y,nu,nu_1,nu_2,nu_3,coordination,v_x,v_y,spin,"
                         "F_xx,F_xy,F_yx,F_yy,sigma_xx,sigma_xy,sigma_yx,sigma_yy,"
                         "sigma_kin_xx,sigma_kin_xy,sigma_kin_yx,sigma_kin_yy,"
                         "eps_xx,eps_xy,eps_yx,eps_yy,M_zx,M_zy,kappa_zx,kappa_zy,E,G,mu_c"),
            std::string::npos)
      << ran.out;
  auto row = only_row(ran.out);
  constexpr double rounding = 1e-14;
  EXPECT_NEAR(row["nu"], 9 * std::numbers::pi / 1024, rounding);
  EXPECT_NEAR(row["F_xx"], std::numbers::pi / 64, rounding);
  EXPECT_NEAR(row["sigma_xx"], -13.5 / 64, rounding);
  EXPECT_NEAR(row["sigma_yx"], 1.0 / 64, rounding);
  EXPECT_NEAR(row["v_x"], 2.0 / 3, rounding);
  EXPECT_NEAR(row["v_y"], 4.0 / 9, rounding);
}

// Two sectors of the ring: disc 20 at (0, -2) is in the lower one, 7 and 3 on the x axis are halved.
TEST(Average, GoodPairInSectorsAsWorkedByHand) {
  const Ran ran = run_program("average " + good + "--sectors 2");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("\nr_inner,r_outer,r,phi_begin,phi_end,phi,nu,"), std::string::npos);
  EXPECT_NEAR(only_row(ran.out)["nu"], 1.0 / 32, 1e-14);  // (1/4 + 1/4)/2 of 8
}

TEST(Average, ColumnsStandInThePromisedOrder) {
  const std::string columns =
      "nu,nu_1,nu_2,nu_3,coordination,v_r,v_phi,spin,"
      "F_rr,F_rphi,F_phir,F_phiphi,sigma_rr,sigma_rphi,sigma_phir,sigma_phiphi,"
      "sigma_kin_rr,sigma_kin_rphi,sigma_kin_phir,sigma_kin_phiphi,"
      "eps_rr,eps_rphi,eps_phir,eps_phiphi,M_zr,M_zphi,kappa_zr,kappa_zphi,"
      "D_rphi,W_rphi,omega_excess,E,G,mu_c";
  const std::string errors = std::regex_replace(columns, std::regex("([^,]+)"), "$1_err");
  const Ran ran = run_program("average " + good);
  EXPECT_NE(ran.out.find("\nr_inner,r_outer,r," + columns + "," + errors +
                         ",effective_samples,solid_fraction_two_tau,coordination_two_tau,velocity_two_tau"),
            std::string::npos);
  const Ran without = run_program("average " + good + "--error-blocks 0");
  EXPECT_NE(without.out.find("\nr_inner,r_outer,r," + columns + "\n"), std::string::npos);
}

TEST(Average, ExtraColumnsStandBehindTheOthersInAFixedOrder) {
  const Ran ran = run_program("average " + good +
                              "--error-blocks 0 --mu 0.5 --histogram 2 --fields "
                              "rattler_fraction,stiffness,sliding_fraction,fabric_axes");
  EXPECT_NE(ran.out.find("\nr_inner,r_outer,r,E,G,tr_F,dev_F,angle_F,F_major,F_minor,contact_angle_bin_1,"
                         "contact_angle_bin_2,sliding_fraction,rattler_fraction\n"),
            std::string::npos)
      << ran.out << ran.err;
}

TEST(Average, TooFewFramesGiveNoErrorsAndSaySo) {
  const Ran ran = run_program("average " + good);
  EXPECT_NE(ran.out.find("# errors: nan: 2 blocks of 1 frames are too few for standard errors\n"),
            std::string::npos);
  auto row = only_row(ran.out);
  EXPECT_TRUE(std::isnan(row["nu_err"]) && std::isnan(row["effective_samples"]));
}

TEST(Average, SaysWhichDisplacementTheCurvatureHas) {
  EXPECT_NE(
      run_program("average " + good + "--kn 100").out.find("# note: curvature: no tangential springs, "),
      std::string::npos);
}

TEST(Average, WritesTheSameIntoAFile) {
  const Folder folder;
  const Ran ran = run_program("average " + good + "--out '" + folder.path("a.csv") + "'");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(read_text(folder.path("a.csv")), run_program("average " + good).out);
  const Ran both = run_program("average " + good + "--out - --out '" + folder.path("b.csv") + "'");
  EXPECT_EQ(both.out, read_text(folder.path("a.csv")));
  EXPECT_EQ(both.out, read_text(folder.path("b.csv")));
}

TEST(Average, StockContactDumpsGiveTheSameThroughTheColumnMap) {
  // The same contacts as compute pair/gran/local writes them: positions, ids, flag, force on the first disc;
  // no walls.
  const std::string fields = "--error-blocks 0 --fields fabric,stress,coordination";
  const auto of = [&](const std::string& contacts) {
    const Ran ran = run_program("average --particles good/particles.dump --rings 0 4 1 --bulk-types 1 " +
                                fields + " --contacts " + contacts);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return only_row(ran.out);
  };
  auto stock = of("good/stock.dump --contact-columns x1,y1,z1,x2,y2,z2,id1,id2,periodic,fx,fy,fz");
  auto ours = of("good/no_wall.dump");
  ASSERT_EQ(ours.size(), 12U);
  // Normals are derived there: rounding.
  for (const auto& [name, value] : ours) EXPECT_NEAR(stock[name], value, 1e-14) << name;
}

TEST(Average, FramesCanBeSelected) {
  // Frame 200 alone: v_phi = 0.75/(9/16).
  EXPECT_NEAR(only_row(run_program("average " + good + "--frames 1:").out)["v_phi"], 4.0 / 3, 1e-14);
  EXPECT_NEAR(only_row(run_program("average " + good + "--steps 150:200").out)["v_phi"], 4.0 / 3, 1e-14);
}

TEST(Info, TellsWhatIsInADump) {
  const Ran ran = run_program("info good/particles.dump --json");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(
      ran.out,
      R"([{"file":"good/particles.dump","kind":"particles","frames":2,"first_step":100,"last_step":200,)"
      R"("fewest_rows":4,"most_rows":4,"columns":["id","type","x","y","z","radius","vx","vy","omegaz",)"
      R"("mass"],"box":[-5.0,5.0,-5.0,5.0],"periodic":"","types":{"1":3,"2":1},"radius":[0.125,0.5]}])"
      "\n");
  EXPECT_NE(run_program("info 'good/*.dump'").out.find("good/stock.dump: contacts"), std::string::npos);
}

// v = 2 exp(-(r - 1)/0.5) at r = 1, 2, 3, 4 with 17 digits in the file: exact data.
TEST(Fit, ExactTableGivesItsParameters) {
  const Ran ran = run_program("fit good/profile.csv --omega 4 --json");
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto number = [&](const std::string& key) { return json_number(ran.out, key); };
  EXPECT_NEAR(number("v0"), 2, 1e-10);
  EXPECT_NEAR(number("s"), 0.5, 1e-10);
  EXPECT_EQ(number("r_i"), 1);
  EXPECT_NEAR(number("v0_scaled"), 0.5, 1e-10);
  EXPECT_EQ(number("rings"), 4);
  EXPECT_NEAR(number("v0_greatest"), 2, 1e-10);
  EXPECT_NEAR(number("v0_scaled_least"), 0.5, 1e-10);
  // The rings tell v0 and s, and nothing about how well they are known.
  for (const std::string key : {"v0_err", "v0_low", "v0_high", "s_low", "s_high", "v0_scaled_high"})
    EXPECT_NE(ran.out.find("\"" + key + "\":null"), std::string::npos) << key;
}

TEST(Fit, TellsTheUnitOfTheColumn) {
  const Folder folder;
  const auto fit = [&](const std::string& comments, const std::string& options) {
    return run_program(
        "fit '" + folder.write("t.csv", comments + "r,r_inner,sigma_rr\n1,1,8\n2,2,4\n3,3,2.5\n4,4,1\n") +
        "' --column sigma_rr" + options);
  };
  const std::string unit = "# column sigma_rr [Pa] (Latzel2001 Eq. 16) stress\n";
  EXPECT_NE(fit(unit, "").out.find(" Pa; by choices"), std::string::npos);
  EXPECT_NE(fit("", "").out.find("the table does not give the unit"), std::string::npos);
  EXPECT_EQ(fit(unit, " --omega 2").err,
            "mikromakro: --omega: sigma_rr is not a velocity; expected a column in m/s, got Pa\n");
}

TEST(Fit, TablesWithoutAProfileAreRefused) {
  const Folder folder;
  const std::string box = folder.write("b.csv", "x,y,v_phi\n1,1,2\n");
  EXPECT_NE(run_program("fit '" + box + "'").err.find("the table has no rings"), std::string::npos);
  const std::string sectors =
      folder.write("s.csv", "r_inner,r_outer,r,phi_begin,phi_end,v_phi\n1,2,1.5,0,90,2\n");
  EXPECT_NE(run_program("fit '" + sectors + "'").err.find("the table contains sectors"), std::string::npos);
  const std::string nan =
      folder.write("n.csv", "r,r_inner,v_phi,v_phi_err\n1,1,4,nan\n2,2,2,nan\n3,3,1,nan\n");
  EXPECT_NE(run_program("fit '" + nan + "' --weights errors").err.find("v_phi_err is nan in all rows"),
            std::string::npos);
  const std::string edges =
      folder.write("e.csv", "r_inner,r_outer,r,v_phi\n1,2,1.5,4\n2,3,2.6,2\n3,4,3.5,1\n");
  EXPECT_NE(run_program("fit '" + edges + "'").err.find("r is not the middle of its ring in 1 rows"),
            std::string::npos);
  const std::string zeros = folder.write("z.csv", "r,r_inner,v_phi\n1,1,0\n2,2,0\n3,3,0\n4,4,0\n");
  const Ran ran = run_program("fit '" + zeros + "'");
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.err.find("there is nothing to fit"), std::string::npos) << ran.err;
  const std::string centre = folder.write("c.csv", "r,r_inner,v_phi\n0.5,0,4\n1.5,1,2\n2.5,2,1\n3.5,3,0.5\n");
  EXPECT_NE(run_program("fit '" + centre + "' --omega 1").err.find("a wheel of zero radius"),
            std::string::npos);
  EXPECT_NE(run_program("fit good/profile.csv --ri 0").err.find("--ri: invalid value"), std::string::npos);
}

TEST(Fit, TooFewRingsAreAFailedRun) {
  const Ran ran = run_program("fit good/profile.csv --range 0 2.5");
  EXPECT_EQ(ran.code, 1);
  EXPECT_EQ(ran.err,
            "mikromakro: too few rings for the fit; expected at least 3 with finite values (r = 1.5 to 4.5 "
            "m), got 2\n");
}

TEST(Program, HelpAndVersionAreNoErrors) {
  EXPECT_EQ(run_program("--version").out.rfind("mikromakro ", 0), 0U);
  for (const std::string verb : {"", "average ", "compare ", "info ", "fit ", "audit ", "draw ", "convert "})
    EXPECT_EQ(run_program(verb + "--help").code, 0);
}

}  // namespace
}  // namespace mikromakro
