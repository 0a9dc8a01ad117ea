// fix snapshot/disc and fix ave/micromacro in the program, alone and under mpirun: what they write equals
// dumps and averages of dumps, goes on after restarts, and outlives a kill of one rank or of all.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

#include "engine_lines.h"
#include "io/frame_stream.h"
#include "io/hdf5_file.h"
#include "io/snapshot_reader.h"

namespace mikromakro::test {
namespace {

const std::string before_the_box = R"(
units si
newton off
atom_style granular
atom_modify map array
communicate single vel yes
processors * * 1
)";
const std::string discs_between_rings = R"(
dimension 2
boundary f f p
region box block -0.06 0.06 -0.06 0.06 -0.001 0.001 units box
create_box 4 box
create_ring 0 0 0.02 number 20 type 3 radius 0.00125 density 6
create_ring 0 0 0.045 number 40 type 4 radius 0.00125 density 6
create_discs ring 0 0 0.02 0.045 seed 3 density 6 velocity 1 discs 80 1 0.0025 discs 20 2 0.003
group inner type 3
group outer type 4
group wall type 3 4
group free type 1 2
)";
const std::string styles = R"(
neighbor 0.001 bin
neigh_modify delay 0
neigh_modify exclude group wall wall
fix kn all property/global kn peratomtypepair 4 400 400 400 400 400 400 400 400 400 400 400 400 400 400 400 400
fix kt all property/global kt peratomtypepair 4 300 300 300 300 300 300 300 300 300 300 300 300 300 300 300 300
fix gamman all property/global gamman_abs peratomtypepair 4 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0
fix mu all property/global coefficientFriction peratomtypepair 4 .4 .4 .4 .4 .4 .4 .4 .4 .4 .4 .4 .4 .4 .4 .4 .4
pair_style gran model disc/linear tangential disc/cundall_strack
pair_coeff * *
fix integrate free nve/disc
compute contacts all contact/disc
fix cell wall couette/2d center 0 0 inner rough inner 0.02 outer rough outer 0.045 omega_inner 5
timestep 2e-5
)";
const std::string scene = before_the_box + discs_between_rings + styles;

std::string from_restart(const std::string& file) {
  return before_the_box + "read_restart " + file + "\n" + styles;
}

// Particles and contacts as text, to the last bit.
std::string dumps(int every) {
  std::string columns;
  for (int k = 1; k <= 16; ++k) columns += fmt::format(" c_contacts[{}]", k);
  std::string format = "%.0f %.0f";
  for (int k = 3; k <= 16; ++k) format += " %.17g";
  return fmt::format(
      "dump p all custom {0} p_*.txt id type x y radius mass vx vy omegaz\n"
      "dump_modify p sort id format \"%d %d %.17g %.17g %.17g %.17g %.17g %.17g %.17g\"\n"
      "dump c all local {0} c_*.txt{1}\ndump_modify c format \"{2}\"\n",
      every, columns, format);
}

using Numbers = std::vector<double>;

Numbers numbers_of(const Particle& d) {
  return {static_cast<double>(d.id),
          static_cast<double>(d.type),
          d.position[0],
          d.position[1],
          d.radius,
          d.velocity[0],
          d.velocity[1],
          d.spin,
          d.mass};
}

// Every number of a frame; contacts have no order of their own.
struct Content {
  std::vector<Numbers> discs, contacts;
  bool operator==(const Content&) const = default;
};
Content content_of(FrameStream& stream, const Frame& frame) {
  Content content;
  for (const Particle& disc : frame.particles) content.discs.push_back(numbers_of(disc));
  for (const auto& row : stream.raw().contacts.rows)
    content.contacts.emplace_back(row.value.begin(), row.value.begin() + contact_disc_columns);
  std::sort(content.contacts.begin(), content.contacts.end());
  return content;
}
std::map<std::int64_t, Content> contents(const FrameSource& source) {
  std::map<std::int64_t, Content> frames;
  FrameStream stream(source);
  Frame frame;
  while (stream.next(frame)) frames[frame.step] = content_of(stream, frame);
  return frames;
}

class SnapshotOfARun : public testing::Test {
 protected:
  SnapshotOfARun() : folder_(testing::TempDir() + "snapshot" + std::to_string(getpid())) {
    std::filesystem::create_directories(folder_);
  }
  ~SnapshotOfARun() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& file) const { return (folder_ / file).string(); }

  std::string command(const std::string& script, int ranks) const {
    std::ofstream(folder_ / "in.test") << lines_of_engine(script);
    const std::string mpi =
        ranks > 1 ? fmt::format("{} --mca mpi_yield_when_idle 1 -n {} ", MPIEXEC, ranks) : "";
    return fmt::format("cd {} && exec {}{} -in in.test -log none </dev/null >screen.txt 2>&1",
                       folder_.string(), mpi, ENGINE_PROGRAM);
  }

  void run(const std::string& script, int ranks) const {
    const int status = std::system(("timeout 60 sh -c '" + command(script, ranks) + "'").c_str());
    ASSERT_EQ(status, 0) << text("screen.txt");
  }

  std::string text(const std::string& file) const {
    std::ifstream stream(folder_ / file);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }

  std::map<std::int64_t, Content> snapshots(const std::string& file = "s.h5") const {
    FrameSource source;
    source.snapshot_files = {path(file)};
    return contents(source);
  }

  std::map<std::int64_t, Content> dumped() const {
    FrameSource source;
    for (int step = 0; std::filesystem::exists(path(fmt::format("p_{}.txt", step))); step += 20) {
      source.particle_files.push_back(path(fmt::format("p_{}.txt", step)));
      source.contact_files.push_back(path(fmt::format("c_{}.txt", step)));
    }
    return contents(source);
  }

  // The lines below the '#' lines.
  std::string table(const std::string& file) const {
    std::istringstream lines(text(file));
    std::string numbers;
    for (std::string line; std::getline(lines, line);)
      if (!line.starts_with('#')) numbers += line + "\n";
    return numbers;
  }

  void average(const std::string& options, const std::string& out) const {
    const std::string command =
        fmt::format("cd {} && {} average s.h5 {} --out {}", folder_.string(), MIKROMAKRO, options, out);
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
  }

  std::filesystem::path folder_;
};

class OnRanks : public SnapshotOfARun, public testing::WithParamInterface<int> {};

// Also where the second run starts, which has a frame of this step already.
TEST_P(OnRanks, HasTheNumbersOfDumpsToTheLastBit) {
  run(scene + "fix s all snapshot/disc 20 file s.h5\n" + dumps(20) + "run 60\nrun 60\n", GetParam());
  const auto frames = snapshots();
  ASSERT_EQ(frames.size(), 7U);
  std::size_t contacts = 0;
  for (const auto& [step, frame] : frames) contacts += frame.contacts.size();
  EXPECT_GT(contacts, 50U);
  EXPECT_EQ(frames, dumped());
}

TEST_P(OnRanks, HasTheBoxBesideTheCell) {
  run(scene +
          "fix box free biaxial/2d type 1 left -0.05 fixed right 0.05 strain rate -2 bottom -0.05 fixed top "
          "0.05 fixed\nfix s all snapshot/disc 20 file s.h5\nrun 40\n",
      GetParam());
  const Hdf5File file = Hdf5File::open(path("s.h5"));
  std::vector<double> box(81), cell(27);
  file.dataset("/walls/box/value").read<double>({{0, 0}, {3, 27}}, box);
  file.dataset("/walls/cell/value").read<double>({{0, 0}, {3, 9}}, cell);
  for (const std::size_t frame : {0, 1, 2}) {
    const double* walls = &box[27 * frame];
    EXPECT_EQ(walls[0], -0.05);
    EXPECT_DOUBLE_EQ(walls[1], 0.05 - 2 * 20 * 2e-5 * static_cast<double>(frame));
    EXPECT_EQ(walls[5], -2);
    EXPECT_NEAR(walls[16], (walls[1] - 0.05) / 0.1, 1e-15);  // horizontal strain; rounding of 1 + strain
    EXPECT_EQ(cell[9 * frame + 6], 0.045);
  }
}

TEST_P(OnRanks, HasTheStateOfTheWallsAndWhatIsSimulated) {
  run(scene + "fix s all snapshot/disc 20 file s.h5 height 0.006\nrun 40\n", GetParam());
  const Hdf5File file = Hdf5File::open(path("s.h5"));
  std::vector<double> walls(27), k_t(16), height(1);
  file.dataset("/walls/cell/value").read<double>({{0, 0}, {3, 9}}, walls);
  for (const std::size_t frame : {0, 1, 2}) {
    EXPECT_DOUBLE_EQ(walls[9 * frame + 4], 5 * 20 * 2e-5 * static_cast<double>(frame));  // angle of the wheel
    EXPECT_EQ(walls[9 * frame + 6], 0.045);                                              // outer radius
  }
  file.dataset("/parameters/kt").read<double>({{0, 0}, {4, 4}}, k_t);
  EXPECT_EQ(k_t, std::vector<double>(16, 300));
  file.dataset("/parameters/height").read<double>({{0}, {1}}, height);
  EXPECT_EQ(height[0], 0.006);
  const auto effects = file.text_attribute("/parameters", "effects");
  const auto simulated = [&](const char* name) { return std::count(effects.begin(), effects.end(), name); };
  EXPECT_EQ(simulated("linear normal force"), 1);
  EXPECT_EQ(simulated("friction with spring"), 1);
  EXPECT_EQ(simulated("gravity"), 0);
  EXPECT_EQ(file.text_attribute("/parameters", "units"), std::vector<std::string>{"si"});
}

// The file was ahead of the restart by two frames, which are dropped and written again.
TEST_P(OnRanks, GoesOnFromARestart) {
  const std::string snapshot = "fix s all snapshot/disc 20 file {} append yes\n";
  run(scene + fmt::format(fmt::runtime(snapshot), "whole.h5") + "run 160\n", GetParam());
  run(scene + fmt::format(fmt::runtime(snapshot), "s.h5") + "run 50\nwrite_restart half.restart\nrun 50\n",
      GetParam());
  run(from_restart("half.restart") + fmt::format(fmt::runtime(snapshot), "s.h5") + "run 110\n", GetParam());
  EXPECT_NE(text("screen.txt").find("snapshot/disc: dropped 3 frames after step 50 from s.h5"),
            std::string::npos);
  const auto frames = snapshots(), whole = snapshots("whole.h5");
  ASSERT_EQ(frames.size(), 9U);
  for (const auto& [step, frame] : frames) {
    ASSERT_EQ(frame.discs.size(), whole.at(step).discs.size());
    for (std::size_t i = 0; i < frame.discs.size(); ++i)
      // Rounding of sums in another order, grown over 110 steps.
      for (const std::size_t k : {2U, 3U}) EXPECT_NEAR(frame.discs[i][k], whole.at(step).discs[i][k], 1e-14);
  }
}

TEST_P(OnRanks, StopsAtAFileOfAnotherSystem) {
  run(scene + "fix s all snapshot/disc 20 file s.h5\nrun 20\n", GetParam());
  const auto stopped = [&](const std::string& script, const std::string& line) {
    EXPECT_NE(std::system(("timeout 60 sh -c '" + command(script, GetParam()) + "'").c_str()), 0);
    const std::string output = text("screen.txt");
    EXPECT_NE(output.find("ERROR: snapshot/disc: s.h5: is of another system, " + line), std::string::npos)
        << output;
    EXPECT_EQ(output.find("ERROR"), output.rfind("ERROR"));
  };
  const std::string append = "fix s all snapshot/disc 20 file s.h5 append yes\nrun 20\n";
  stopped(scene + "set group outer diameter 0.0024\n" + append, "disc 21 differs");
  stopped(
      scene +
          "unfix kt\nunfix mu\nfix mu all property/global coefficientFriction peratomtypepair 4 .4 .4 .4 .4 "
          ".4 .4 .4 .4 .4 .4 .4 .4 .4 .4 .4 .4\npair_style gran model disc/linear tangential off\npair_coeff "
          "* *\n" +
          append,
      "effects differs");
}

TEST_P(OnRanks, AveragesAreThoseOfTheProgramToTheLastBit) {
  run(scene +
          "fix s all snapshot/disc 20 file s.h5\n"
          "fix r all ave/micromacro 20 60 file r_*.csv rings 0.02 0.045 5 bulk_types 1,2 kn 400 height "
          "0.006\n"
          "fix g all ave/micromacro 20 60 file g.csv grid -0.05 0.05 2 -0.05 0.05 2 weight centre branch "
          "contact "
          "fields solid_fraction,stress,sliding_fraction mu 0.4\n"
          "run 100\nrun 20\n",
      GetParam());
  average("--steps 20:60 --rings 0.02 0.045 5 --bulk-types 1,2 --kn 400 --height 0.006", "first.csv");
  average("--steps 80:120 --rings 0.02 0.045 5 --bulk-types 1,2 --kn 400 --height 0.006", "second.csv");
  average(
      "--steps 20:120 --grid -0.05 0.05 2 -0.05 0.05 2 --weight centre --branch contact "
      "--fields solid_fraction,stress,sliding_fraction --mu 0.4",
      "grid.csv");
  ASSERT_GT(table("first.csv").size(), 1000U);
  EXPECT_EQ(table("r_60.csv"), table("first.csv"));
  EXPECT_EQ(table("r_120.csv"), table("second.csv"));
  EXPECT_EQ(table("g.csv"), table("grid.csv"));
  EXPECT_NE(text("r_120.csv").find("# frames: 3, steps 80 to 120\n"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Program, OnRanks, testing::Values(1, 2));

class Killed : public SnapshotOfARun {
 protected:
  std::size_t frames_now() const {
    if (!std::filesystem::exists(path("s.h5"))) return 0;
    return summarise_snapshots(Hdf5File::open(path("s.h5")), path("s.h5")).steps.size();
  }

  // Ranks are the children of mpirun.
  static std::vector<pid_t> children_of(pid_t parent) {
    std::ifstream list(fmt::format("/proc/{0}/task/{0}/children", parent));
    std::vector<pid_t> children;
    for (pid_t child = 0; list >> child;) children.push_back(child);
    return children;
  }

  // Runs on two ranks until there are some frames; then the given ranks are killed.
  void run_and_kill(const std::string& script, const std::vector<std::size_t>& victims) const {
    const std::string line = command(script, 2);
    const pid_t mpirun = fork();
    if (mpirun == 0) {
      execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      _exit(127);
    }
    for (int k = 0; k < 3000 && frames_now() < 15; ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const auto ranks = children_of(mpirun);
    ASSERT_EQ(ranks.size(), 2U) << text("screen.txt");
    for (const std::size_t victim : victims) kill(ranks[victim], SIGKILL);
    int status = 0;
    waitpid(mpirun, &status, 0);
    ASSERT_FALSE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "the run ended before it was killed";
  }

  // The last restart file that is complete for sure: the one before the last.
  std::int64_t last_restart() const {
    std::int64_t step = 100;
    while (std::filesystem::exists(path(fmt::format("r.{}.restart", step + 200)))) step += 100;
    return step;
  }

  void expect_complete_frames(std::int64_t last) const {
    // Lists of neighbours are built anew where a restart file is written.
    run(scene +
            fmt::format("restart 100 w.*.restart\nfix s all snapshot/disc 20 file whole.h5\nrun {}\n", last),
        2);
    EXPECT_EQ(snapshots(), snapshots("whole.h5"));
    const std::string h5py = fmt::format(
        "/usr/bin/python3 -c 'import h5py, sys; f = h5py.File(\"{}\", \"r\", swmr=True); "
        "sys.exit(int(f[\"particles/discs/position/step\"][-1] != {}))'",
        path("s.h5"), last);
    EXPECT_EQ(std::system(h5py.c_str()), 0);
  }

  // Continues from the last restart file by 100 steps.
  void expect_to_go_on() const {
    const std::int64_t step = last_restart();
    run(from_restart(fmt::format("r.{}.restart", step)) +
            "fix s all snapshot/disc 20 file s.h5 append yes\nrun 100\n",
        2);
    const auto frames = snapshots();
    ASSERT_EQ(frames.size(), static_cast<std::size_t>(step + 100) / 20 + 1);
    EXPECT_EQ(frames.rbegin()->first, step + 100);
  }

  const std::string endless_ =
      scene + "restart 100 r.*.restart\nfix s all snapshot/disc 20 file s.h5\nrun 10000000\n";
};

TEST_F(Killed, OneRankThatWrites) {
  run_and_kill(endless_, {0});
  ASSERT_GE(frames_now(), 15U);
  expect_complete_frames(snapshots().rbegin()->first);
  expect_to_go_on();
}

TEST_F(Killed, OneRankThatDoesNotWrite) {
  run_and_kill(endless_, {1});
  ASSERT_GE(frames_now(), 15U);
  expect_complete_frames(snapshots().rbegin()->first);
  expect_to_go_on();
}

TEST_F(Killed, AllRanks) {
  run_and_kill(endless_, {0, 1});
  ASSERT_GE(frames_now(), 15U);
  expect_complete_frames(snapshots().rbegin()->first);
  expect_to_go_on();
}

}  // namespace
}  // namespace mikromakro::test
