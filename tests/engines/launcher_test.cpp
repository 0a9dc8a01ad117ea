// SPDX-License-Identifier: GPL-2.0-or-later
// liggghts-disc and lmp-disc as programs: command line, styles after `clear`, warnings and errors as a user
// meets them, alone and under mpirun.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine_lines.h"
#include "mikromakro_version.h"
#include "physics/contact/contact_duration.h"

namespace mikromakro::test {
namespace {

struct Ending {
  int code;
  std::string output;  // stdout and stderr
  std::size_t lines_with(const std::string& text) const {
    std::istringstream lines(output);
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line);) count += line.find(text) != std::string::npos ? 1 : 0;
    return count;
  }
};

/// The lines every script here starts with: two discs of 10 mm, apart, and no material constants.
const std::string two_discs = R"(
units si
dimension 2
newton off
atom_style granular
communicate single vel yes
boundary f f p
region box block -0.05 0.05 -0.05 0.05 -0.001 0.001 units box
create_box 1 box
neighbor 0.001 bin
neigh_modify delay 0
create_atoms 1 single -0.02 0 0 units box
create_atoms 1 single 0.02 0 0 units box
set group all diameter 0.01 density 6
timestep 2e-5
)";

std::string constant(const char* name, double value) {
  return fmt::format("fix {0} all property/global {0} peratomtypepair 1 {1}\n", name, value);
}

const std::string normal_constants = constant("kn", 352.1) + constant("gamman_abs", 0.19);
const std::string normal_law =
    normal_constants + "pair_style gran model disc/linear tangential off\npair_coeff * *\n";
const std::string five_steps = "fix integrate all nve/disc\nrun 5\n";

class Launcher : public testing::Test {
 protected:
  Launcher() : folder_(testing::TempDir() + "launcher" + std::to_string(getpid())) {
    std::filesystem::create_directories(folder_);
  }
  ~Launcher() override { std::filesystem::remove_all(folder_); }

  /// Runs the program in a folder of its own, within 30 s.
  Ending run(const std::string& arguments, int ranks = 1) const {
    const std::string mpi = ranks > 1 ? fmt::format("{} -n {} ", MPIEXEC, ranks) : "";
    const std::string command = fmt::format("cd {} && timeout 30 </dev/null {}{} {} 2>&1", folder_.string(),
                                            mpi, ENGINE_PROGRAM, arguments);
    FILE* pipe = popen(command.c_str(), "r");
    std::string output;
    char piece[4096];
    for (std::size_t count = 0; (count = std::fread(piece, 1, sizeof piece, pipe)) > 0;)
      output.append(piece, count);
    const int status = pclose(pipe);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, output};
  }

  Ending run_script(const std::string& script, int ranks = 1,
                    const std::string& options = "-log none") const {
    std::ofstream(folder_ / "in.test") << lines_of_engine(script);
    return run("-in in.test " + options, ranks);
  }

  bool has(const char* file) const { return std::filesystem::exists(folder_ / file); }

  std::filesystem::path folder_;
};

TEST_F(Launcher, NamesItsVersionInTheFirstLine) {
  for (const int ranks : {1, 2}) {
    const auto ending = run_script("print hello\n", ranks);
    EXPECT_EQ(ending.code, 0);
    EXPECT_EQ(ending.lines_with("mikromakro " MIKROMAKRO_VERSION), 1U) << ending.output;
    EXPECT_EQ(ending.output.find("mikromakro " MIKROMAKRO_VERSION), 0U);
  }
}

TEST_F(Launcher, HelpListsTheDiscStylesBesideThoseOfTheEngine) {
  const auto ending = run("-help");
  EXPECT_EQ(ending.code, 0);
  for (const auto* name : {"disc/linear", "disc/hertz", "disc/viscous", "disc/cundall_strack", "nve/disc",
                           "contact/disc", "nve/sphere"}) {
    EXPECT_NE(ending.output.find(name), std::string::npos) << name;
  }
}

TEST_F(Launcher, TakesTheOptionsOfTheEngine) {
  const std::string script = "print \"size is ${size}\"\n";
  const auto plain = run_script(script, 1, "-var size 17 -echo none -log my.log");
  EXPECT_EQ(plain.lines_with("size is 17"), 1U) << plain.output;
  EXPECT_TRUE(has("my.log"));
  EXPECT_FALSE(has("log." ENGINE_NAME));
  // Echoed, then printed.
  EXPECT_EQ(run_script(script, 1, "-var size 17 -echo screen -log none").lines_with("size is"), 2U);
  EXPECT_EQ(run_script(script, 1, "-var size 17 -screen none -log none").lines_with("size is"), 0U);
  EXPECT_EQ(run("-var size 17 -log none < in.test").lines_with("size is 17"), 1U);
  EXPECT_EQ(run_script(script, 2, "-var size 17 -echo none -log none").lines_with("size is 17"), 1U);
}

TEST_F(Launcher, KeepsTheStylesOverClear) {
  const std::string scene = two_discs + normal_law + "compute contacts all contact/disc\n" + five_steps;
  for (const int ranks : {1, 2}) {
    const auto ending = run_script(scene + "clear\n" + scene + "clear\n" + scene + "print done\n", ranks);
    EXPECT_EQ(ending.code, 0) << ending.output;
    EXPECT_EQ(ending.lines_with("ERROR"), 0U);
    EXPECT_GE(ending.lines_with("done"), 1U);
  }
}

TEST_F(Launcher, WarnsOfAStepAboveAFiftiethOfTheContactAndNamesOneThatWouldDo) {
  const double mass = 6 * M_PI * 0.005 * 0.005;
  const double t_c = physics::contact_duration(352.1, 0.19, mass / 2);
  const auto warning = fmt::format("'timestep {:.4g}' would do", t_c / 50);
  for (const int ranks : {1, 2}) {
    const auto run_with = [&](double dt) {
      return run_script(two_discs + normal_law + fmt::format("timestep {:.17g}\n", dt) + five_steps, ranks);
    };
    const auto long_step = run_with(t_c / 40), short_step = run_with(t_c / 50);
    EXPECT_EQ(long_step.code, 0);
    EXPECT_EQ(long_step.lines_with(warning), 1U) << long_step.output;
    EXPECT_EQ(short_step.lines_with("would do"), 0U) << short_step.output;
    const auto coarse = run_with(t_c / 5), unstable = run_with(t_c / 2);
    EXPECT_EQ(coarse.code, 0);
    EXPECT_EQ(coarse.lines_with(warning), 1U) << coarse.output;
    EXPECT_NE(unstable.code, 0);
    EXPECT_EQ(unstable.lines_with("is above a quarter of the shortest contact"), 1U) << unstable.output;
  }
}

TEST_F(Launcher, ListsWhatIsSimulatedAndWhatIsNotInOneLineOfScreenAndLog) {
  const std::string constants = normal_constants + constant("coefficientFriction", 0.4) +
                                constant("kt", 200) + constant("gammat_abs", 0.1);
  const auto line_of = [&](const std::string& law, const std::string& fixes, int ranks) {
    const auto ending = run_script(two_discs + constants + "pair_style gran model " + law +
                                       "\npair_coeff * *\n" + fixes + "write_restart my.restart\nrun 1\n",
                                   ranks, "-log my.log");
    EXPECT_EQ(ending.lines_with("Effects simulated: "), 1U) << ending.output;
    const auto begin = ending.output.find("Effects simulated: ");
    auto line = ending.output.substr(begin, ending.output.find('\n', begin) - begin);
    std::ifstream log(folder_ / "my.log");
    std::stringstream text;
    text << log.rdbuf();
    EXPECT_NE(text.str().find(line), std::string::npos) << text.str();
    return line;
  };
  for (const int ranks : {1, 2}) {
    EXPECT_EQ(
        line_of("disc/linear tangential off damping off", "fix integrate all nve/sphere\n", ranks),
        "Effects simulated: linear normal force; not simulated: normal dashpot, friction, tangential "
        "dashpot, "
        "cut-off of attraction, bottom friction, gravity, smooth walls; dashpots see half-step velocities");
  }
  EXPECT_EQ(
      line_of(
          "disc/hertz tangential disc/cundall_strack tangential_damping on limitForce on impact_velocity 0.1",
          "fix integrate all nve/disc\nfix bottom all bottom/friction 0.1 9.81\n"
          "fix down all gravity 9.81 vector 0 -1 0\n",
          1),
      "Effects simulated: normal force of Hertz, normal dashpot, friction with spring, tangential dashpot, "
      "cut-off of attraction, bottom friction, gravity; not simulated: smooth walls; dashpots see predicted "
      "velocities");
  EXPECT_NE(
      line_of("disc/linear tangential off",
              "fix integrate all nve/disc\nfix box all biaxial/2d type 1 left -0.04 fixed right 0.04 fixed "
              "bottom -0.04 fixed top 0.04 fixed\n",
              1)
          .find("normal dashpot, smooth walls; not simulated: "),
      std::string::npos);
  // The rings of a rough cell are discs.
  EXPECT_NE(
      line_of("disc/linear tangential off",
              "create_ring 0 0 0.01 number 4 type 1 radius 0.001 density 6\ngroup inner id 3:6\n"
              "create_ring 0 0 0.04 number 4 type 1 radius 0.001 density 6\ngroup outer id 7:10\n"
              "group rings union inner outer\ngroup free subtract all rings\n"
              "fix integrate free nve/disc\nfix cell rings couette/2d center 0 0 inner rough inner 0.01 "
              "outer rough outer 0.04 omega_inner 1\n",
              1)
          .find("gravity, smooth walls; "),
      std::string::npos);
  EXPECT_NE(line_of("disc/linear tangential disc/viscous", "fix integrate all nve/disc\n", 1)
                .find("normal dashpot, friction by Eq. 1; not simulated: tangential dashpot, "),
            std::string::npos);
}

TEST_F(Launcher, NamesTheStepForHertzianContactsAtTheVelocityOrTheOverlapAtHand) {
  const double mass = 6 * M_PI * 0.005 * 0.005, k_h = physics::hertz_stiffness(1e6, 0.0025);
  const auto run_with = [&](const std::string& keywords, const std::string& lines, int ranks) {
    return run_script(two_discs + constant("kn", 1e6) +
                          "pair_style gran model disc/hertz tangential off damping off " + keywords +
                          "\npair_coeff * *\ntimestep 1e-4\n" + lines + five_steps,
                      ranks);
  };
  const auto would_do = [](double t_c) { return fmt::format("'timestep {:.4g}' would do", t_c / 50); };
  for (const int ranks : {1, 2}) {
    // Approach at 0.5 m/s by the keyword; twice the largest speed; overlap of 1 mm at rest.
    const auto expected = run_with("impact_velocity 0.5", "", ranks);
    EXPECT_EQ(expected.lines_with(would_do(physics::hertz_contact_duration(k_h, mass / 2, 0.5))), 1U)
        << expected.output;
    const auto moving = run_with("", "set group all vx 0.4\n", ranks);
    EXPECT_EQ(moving.lines_with(would_do(physics::hertz_contact_duration(k_h, mass / 2, 0.8))), 1U)
        << moving.output;
    const auto touching = run_with(
        "", "create_atoms 1 single 0.029 0 0 units box\nset group all diameter 0.01 density 6\n", ranks);
    const double slope = physics::hertz_tangent_stiffness(k_h, 1e-3);
    EXPECT_EQ(touching.lines_with(would_do(physics::contact_duration(slope, 0, mass / 2))), 1U)
        << touching.output;
    const auto unknown = run_with("", "", ranks);
    EXPECT_EQ(unknown.lines_with("time step is not checked"), 1U) << unknown.output;
    EXPECT_EQ(unknown.code, 0);
  }
}

TEST_F(Launcher, AsksOnlyForTheConstantsOfTheChosenLaw) {
  const std::string mu = constant("coefficientFriction", 0.4), k_t = constant("kt", 200),
                    gamma_t = constant("gammat_abs", 0.1);
  const auto code = [&](const std::string& constants, const char* law) {
    return run_script(two_discs + normal_constants + constants + "pair_style gran model disc/linear " + law +
                      "\npair_coeff * *\n" + five_steps)
        .code;
  };
  EXPECT_EQ(code("", "tangential off"), 0);
  EXPECT_EQ(run_script(two_discs + constant("kn", 352.1) +
                       "pair_style gran model disc/linear tangential off damping off\npair_coeff * *\n" +
                       five_steps)
                .code,
            0);
  EXPECT_EQ(code(mu + gamma_t, "tangential disc/viscous"), 0);
  EXPECT_EQ(code(mu + k_t, "tangential disc/cundall_strack"), 0);
  EXPECT_EQ(code(mu + k_t + gamma_t, "tangential disc/cundall_strack tangential_damping on"), 0);
}

// One disc presses the right wall: half a period pi sqrt(m/k_n) of 1e-5 kg on 352.1 N/m is 5.294e-4 s, 26.47
// steps of 2e-5 s; of 1e-7 kg it is 2.647 steps.
TEST_F(Launcher, WarnsOfAWallThatSwingsWithinFewStepsAndStopsAtOneThatSwingsWithinFewerThanFour) {
  const auto run_wall = [this](const char* mass, int ranks) {
    return run_script(two_discs + normal_law +
                          "fix integrate all nve/disc\nfix box all biaxial/2d type 1 left -0.03 fixed bottom "
                          "-0.03 fixed top 0.03 fixed right 0.0249 stress 0.01 mass " +
                          mass + " damping 0\nrun 0\n",
                      ranks);
  };
  for (const int ranks : {1, 2}) {
    const auto warned = run_wall("1e-5", ranks), stopped = run_wall("1e-7", ranks);
    EXPECT_EQ(warned.code, 0) << warned.output;
    EXPECT_GE(warned.lines_with("WARNING: biaxial/2d: right: half a period"), 1U) << warned.output;
    EXPECT_GE(warned.lines_with("has 26.47"), 1U) << warned.output;
    EXPECT_NE(stopped.code, 0);
    EXPECT_EQ(stopped.lines_with("ERROR: biaxial/2d: right: half a period"), 1U) << stopped.output;
    EXPECT_EQ(run_wall("1e-4", ranks).lines_with("half a period"), 0U);
  }
}

TEST_F(Launcher, StopsAtDiscsWithTheSameCentreOnWhicheverRankTheyAre) {
  const std::string again =
      "create_atoms 1 single 0.02 0 0 units box\nset group all diameter 0.01 density 6\n";
  const std::string law = std::string(ENGINE_NAME) == "liggghts" ? "gran model disc/linear" : "disc/linear";
  for (const int ranks : {1, 2}) {
    const auto ending = run_script(two_discs + again + normal_law + five_steps, ranks);
    EXPECT_NE(ending.code, 0);
    EXPECT_EQ(ending.lines_with("ERROR: pair_style " + law + ": discs 2 and 3 have the same centre"), 1U)
        << ending.output;
    EXPECT_EQ(ending.lines_with("nan"), 0U);
  }
}

}  // namespace
}  // namespace mikromakro::test
