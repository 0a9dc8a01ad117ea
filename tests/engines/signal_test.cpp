// SPDX-License-Identifier: GPL-2.0-or-later
// SIGUSR1 asks for a restart file in whatever instant of a step: the file holds the state of the end of a
// step all the same, also where the state was left open because nobody was going to look.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>

#include "engine.h"
#include "signal_handling.h"

namespace mikromakro::test {
namespace {

const std::string law = "model disc/linear tangential disc/cundall_strack";
const std::string given =
    "fix integrate free nve/disc\nneigh_modify exclude group wall wall\ncompute contacts all contact/disc\n"
    "fix cell wall couette/2d center 0 0 inner rough inner 0.04 outer rough outer 0.1 omega_inner 4 "
    "compact 0.08 0.024\ntimestep 4e-5\n";

void create(Engine& engine) {
  engine.run("clear\n" + scene(law, {}, 0.12, 4, "f f p", "0.002"));
  engine.run(
      "create_ring 0 0 0.04 number 40 type 3 radius 0.0025 density 6.36\n"
      "create_ring 0 0 0.1 number 110 type 4 radius 0.0025 density 6.36\n"
      "create_discs ring 0 0 0.04 0.1 seed 7 density 6.36 velocity 0.3 discs 200 1 0.004 discs 30 2 0.005\n"
      "group inner type 3\ngroup outer type 4\ngroup wall type 3 4\ngroup free type 1 2\n" +
      given);
}

/// The step of the restart file that was written because of the signal; removes the file.
class SignalledFile {
 public:
  SignalledFile() {
    for (const auto& entry : std::filesystem::directory_iterator(".")) {
      const std::string name = entry.path().filename();
      if (name.starts_with(stem)) path_ = name;
    }
  }
  ~SignalledFile() { std::filesystem::remove(path_); }
  bool written() const { return !path_.empty(); }
  const std::string& path() const { return path_; }
  long step() const { return std::stol(path_.substr(std::string(stem).size())); }

 private:
  static constexpr auto stem = "restart_forced_liggghts_";
  std::string path_;
};

/// Lets the engine's handler have a signal so many microseconds from now.
void signal_in(int microseconds) {
  std::signal(SIGALRM, LAMMPS_NS::SignalHandler::usr1_handler);
  const itimerval once{{0, 0}, {0, microseconds}};
  setitimer(ITIMER_REAL, &once, nullptr);
}

TEST(RestartOnSignal, HoldsTheStateOfTheEndOfAStep) {
  std::filesystem::current_path(testing::TempDir());
  int files = 0;
  for (int trial = 0; trial < 12; ++trial) {
    Engine engine;
    create(engine);
    engine.run("run 800\n");
    signal_in(1000 + 97 * trial);
    engine.run("run 1200\n");
    const SignalledFile file;
    if (!file.written()) continue;
    ++files;
    create(engine);
    engine.run(fmt::format("run 800\nrun {}\n", file.step() - 800));
    const auto expected = engine.discs();
    engine.run("clear\nnewton off\ncommunicate single vel yes\natom_modify map array\nread_restart " +
               file.path() + "\nneighbor 0.002 bin\nneigh_modify delay 0\n" + constants({}, 4));
    const auto discs = engine.discs();
    for (const auto& [id, d] : discs) {
      const auto& e = expected.at(id);
      // The engine builds its neighbour list anew in that step if the signal came early, which changes the
      // order of sums: rounding of forces, times half a step over the mass.
      EXPECT_NEAR(d.x, e.x, 1e-15) << id << " in step " << file.step();
      EXPECT_NEAR(d.v_x, e.v_x, 1e-12) << id << " in step " << file.step();
      EXPECT_NEAR(d.v_y, e.v_y, 1e-12) << id << " in step " << file.step();
      EXPECT_NEAR(d.omega, e.omega, 1e-9) << id << " in step " << file.step();
    }
  }
  EXPECT_GT(files, 5);
}

}  // namespace
}  // namespace mikromakro::test
