// SPDX-License-Identifier: GPL-2.0-or-later
// A run that goes on from a restart file repeats the run that wrote the file and was not interrupted, bit for
// bit, on the same number of ranks. Runs on one rank and on two.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "engine.h"
#include "fix.h"
#include "modify.h"
#include "packing.h"

namespace mikromakro::test {
namespace {

struct State {
  std::map<int, Disc> discs;
  std::map<std::pair<int, int>, Contact> contacts;
  std::vector<double> values;  // that fixes hold: energies taken, heat, walls
};

/// A scene as the lines that create it, those that a script gives anew after read_restart, and those that
/// bring it to where the test starts.
struct Scene {
  const char* name;
  std::string created, given, prepared;
};
void PrintTo(const Scene& scene, std::ostream* out) {
  *out << scene.name;
}

Scene dense_packing(const char* name, const std::string& law, const Material& material,
                    const std::string& fixes = "") {
  return {name, scene(law, material, packing_box, 2, "p p p", "0.002") + packing(20, 0.05),
          constants(material, 2) + "fix integrate all nve/disc\n" + fixes +
              "compute contacts all contact/disc\ntimestep 2e-5\n",
          ""};
}

/// A ring cell whose outer ring shrinks, and then stands, while the wheel turns.
Scene shear_cell() {
  const std::string created =
      scene("model disc/linear tangential disc/cundall_strack", {}, 0.12, 4, "f f p", "0.002") +
      "create_ring 0 0 0.03 pitch 0.0053 type 3 radius 0.00125 density 6.36\n"
      "create_ring 0 0 0.095 number 80 type 4 radius 0.00125 density 6.36\n"
      "create_discs ring 0 0 0.03 0.095 seed 1 density 6.36 velocity 0.05 discs 180 1 0.00371 discs 30 2 "
      "0.004495\n"
      "group free type 1 2\ngroup inner type 3\ngroup outer type 4\ngroup wall type 3 4\n";
  const std::string given =
      constants({}, 4) +
      "neigh_modify exclude group wall wall\nfix integrate free nve/disc\n"
      "fix cell wall couette/2d center 0 0 inner rough inner 0.03 outer rough outer 0.095 omega_inner 3 "
      "compact 0.068 0.12\ncompute contacts all contact/disc\ntimestep 4e-5\n";
  return {"shear_cell", created, given, "run 2500\nreset_timestep 0\n"};
}

const std::string springs = "model disc/linear tangential disc/cundall_strack";

/// The same between smooth walls, which keep springs of their own.
Scene smooth_cell() {
  const std::string created =
      scene(springs, {}, 0.12, 2, "f f p", "0.002") +
      "create_discs ring 0 0 0.03 0.095 seed 1 density 6.36 velocity 0.05 discs 180 1 "
      "0.00371 discs 30 1 0.004495\n";
  const std::string given =
      constants({}, 2) +
      "fix integrate all nve/disc\nfix cell all couette/2d center 0 0 inner smooth 2 0.03 "
      "outer smooth 2 0.095 omega_inner 3 compact 0.068 0.12\n"
      "compute contacts all contact/disc\ntimestep 4e-5\n";
  return {"smooth_cell", created, given, "run 2500\nreset_timestep 0\n"};
}

/// A box whose right and upper walls are driven by their pressures.
Scene biaxial_box() {
  const std::string created = scene(springs, {}, 0.12, 2, "f f p", "0.002") +
                              "create_discs box -0.08 0.08 -0.08 0.08 seed 1 density 6.36 velocity 0.05 "
                              "discs 180 1 0.00371 discs 30 1 "
                              "0.004495\n";
  const std::string given = constants({}, 2) +
                            "fix integrate all nve/disc\nfix box all biaxial/2d type 2 left -0.08 fixed "
                            "right 0.08 stress 20 mass 0.02 "
                            "damping 0.5 bottom -0.08 fixed top 0.08 stress 20 mass 0.02 damping 0.5\n"
                            "fix energy all energy/disc\ncompute contacts all contact/disc\ntimestep 4e-5\n";
  return {"biaxial_box", created, given, "run 4000\nreset_timestep 0\n"};
}

/// A pile under gravity that a wall stirs: contacts slide while their slip turns round, with a dashpot beside
/// the spring.
Scene stirred_pile() {
  const Material material{.gamma_n = 0.02, .gamma_t = 0.01};
  const std::string created =
      scene(springs + " tangential_damping on", material, 0.1, 2, "f f p", "0.002") +
      "create_discs box -0.05 0.05 -0.04 0.1 seed 3 density 6.36 velocity 0.1 discs 40 1 0.004 discs 70 2 "
      "0.0025\n";
  const std::string given =
      constants(material, 2) +
      "fix integrate all nve/disc\nfix down all gravity 9.81 vector 0.3 -1 0\n"
      "fix floor all wall/disc type 1 plane 0 1 -0.07 move vx 0.1\n"
      "fix left all wall/disc type 2 plane 1 0 -0.05\nfix right all wall/disc type 1 plane -1 0 -0.05\n"
      "fix drum all wall/disc type 2 circle 0 -0.055 0.012 outside rotate 5\n"
      "compute contacts all contact/disc\ntimestep 2.5e-5\n";
  return {"stirred_pile", created, given, "run 8000\nreset_timestep 0\n"};
}

const Scene scenes[] = {
    dense_packing("normal_forces", "model disc/linear tangential off", {}),
    dense_packing("viscous", "model disc/linear tangential disc/viscous", {},
                  "fix bottom all bottom/friction 0.1 9.81\nfix down all gravity 9.81 vector 0 -1 0\n"
                  "fix energy all energy/disc\n"),
    dense_packing("spring", "model disc/linear tangential disc/cundall_strack", {}),
    dense_packing("damped_spring",
                  "model disc/linear tangential disc/cundall_strack tangential_damping on limitForce on", {}),
    dense_packing("hertz", "model disc/hertz tangential disc/cundall_strack", {.k_n = 1e6}),
    shear_cell(),
    smooth_cell(),
    stirred_pile(),
    biaxial_box()};

class Continuation : public testing::TestWithParam<Scene> {
 protected:
  // The first rank names the file.
  Continuation() {
    int number = getpid();
    MPI_Bcast(&number, 1, MPI_INT, 0, MPI_COMM_WORLD);
    file_ = testing::TempDir() + "continuation" + std::to_string(number);
  }
  ~Continuation() override {
    MPI_Barrier(MPI_COMM_WORLD);
    for (const auto& entry : std::filesystem::directory_iterator(testing::TempDir())) {
      const std::string path = entry.path().string();
      std::error_code gone_already;
      if (path.starts_with(file_)) std::filesystem::remove(path, gone_already);
    }
  }

  State state() {
    State now{engine_.discs(), engine_.contacts(), {}};
    for (const char* id : {"bottom", "energy", "cell", "box"}) {
      if (engine_.lammps().modify->find_fix(id) < 0) continue;
      LAMMPS_NS::Fix& fix = engine_.fix(id);
      now.values.push_back(fix.compute_scalar());
      for (int i = 0; i < fix.size_vector; ++i) now.values.push_back(fix.compute_vector(i));
    }
    return now;
  }

  void create() { engine_.run("clear\n" + GetParam().created + GetParam().given + GetParam().prepared); }

  void read(const std::string& file) {
    engine_.run("clear\nnewton off\ncommunicate single vel yes\natom_modify map array\nread_restart " + file +
                "\nneighbor 0.002 bin\nneigh_modify delay 0\n" + GetParam().given);
  }

  /// The engine writes a file, and builds its neighbour list anew, every `steps`.
  std::string files_every(int steps) const { return fmt::format("restart {} {}.*\n", steps, file_); }

  std::string file_;
  Engine engine_;
};

void expect_equal(const State& one, const State& other, double rounding_of_sums = 0) {
  ASSERT_EQ(one.discs.size(), other.discs.size());
  int different = 0;
  for (const auto& [id, a] : one.discs) {
    const Disc& b = other.discs.at(id);
    different += a.x != b.x || a.y != b.y || a.v_x != b.v_x || a.v_y != b.v_y || a.omega != b.omega ||
                 a.f_x != b.f_x || a.f_y != b.f_y || a.torque != b.torque;
  }
  // The same arithmetic on the same numbers in the same order: no tolerance.
  EXPECT_EQ(different, 0) << "of " << one.discs.size() << " discs";
  ASSERT_EQ(one.contacts.size(), other.contacts.size());
  EXPECT_GT(one.contacts.size(), one.discs.size() / 2);
  different = 0;
  for (const auto& [ids, a] : one.contacts) {
    const Contact& b = other.contacts.at(ids);
    different += a.xi != b.xi || a.f_n != b.f_n || a.f_t != b.f_t;
  }
  EXPECT_EQ(different, 0) << "of " << one.contacts.size() << " contacts";
  ASSERT_EQ(one.values.size(), other.values.size());
  for (std::size_t i = 0; i < one.values.size(); ++i) {
    EXPECT_NEAR(one.values[i], other.values[i], rounding_of_sums * std::abs(one.values[i])) << "value " << i;
  }
}

TEST_P(Continuation, FromAFileWrittenDuringTheRun) {
  create();
  engine_.run(files_every(300) + "run 600\n");
  const State uninterrupted = state();
  read(file_ + ".300");
  engine_.run(files_every(300) + "run 300\n");
  expect_equal(uninterrupted, state());
}

TEST_P(Continuation, FromAFileWrittenBetweenTwoRuns) {
  create();
  engine_.run(fmt::format("run 300\nwrite_restart {0}\nrun 300\n", file_));
  const State went_on = state();
  read(file_);
  engine_.run("run 300\n");
  expect_equal(went_on, state());
}

// All discs drift, so that some are due for other ranks when the file is written.
TEST_P(Continuation, IsNotChangedByWritingAFile) {
  const std::string drift = "velocity all set 1 0 0 sum yes units box\nrun 40\n";
  create();
  engine_.run(drift + "write_restart " + file_ + "\nrun 40\n");
  const State written = state();
  create();
  engine_.run(drift + "run 40\n");
  // A file holds sums over the ranks, so that later ones are added up in another order.
  expect_equal(written, state(), 1e-14);
}

TEST_P(Continuation, OfARunByASecondRun) {
  create();
  engine_.run(files_every(300) + "run 600\n");
  const State uninterrupted = state();
  create();
  engine_.run(files_every(300) + "run 300\nrun 300\n");
  expect_equal(uninterrupted, state());
}

INSTANTIATE_TEST_SUITE_P(Scenes, Continuation, testing::ValuesIn(scenes),
                         [](const auto& info) { return info.param.name; });

class ContinuationOfManySteps : public Continuation {};

TEST_P(ContinuationOfManySteps, TenThousandFromAFile) {
  create();
  engine_.run(files_every(10000) + "run 20000\n");
  const State uninterrupted = state();
  read(file_ + ".10000");
  engine_.run(files_every(10000) + "run 10000\n");
  expect_equal(uninterrupted, state());
}

INSTANTIATE_TEST_SUITE_P(Scenes, ContinuationOfManySteps, testing::Values(scenes[2], scenes[5]),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace mikromakro::test
