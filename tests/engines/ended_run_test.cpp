// SPDX-License-Identifier: GPL-2.0-or-later
// Runs that are ended from outside, by a kill of one rank or of all or by a signal: their files have every
// complete frame, and a later run goes on from there.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "io/hdf5/hdf5_file.h"
#include "io/snapshot/snapshot_reader.h"
#include "snapshot_run.h"

namespace mikromakro::test {
namespace {

class EndedRun : public SnapshotOfARun {
 protected:
  std::size_t frames_now() const {
    if (!std::filesystem::exists(path("s.h5"))) return 0;
    return summarise_snapshots(Hdf5File::open(path("s.h5")), path("s.h5")).steps.size();
  }

  /// A run without an end, that has written some frames when this returns: mpirun, or the program.
  pid_t endless_run(int ranks) const {
    const std::string line =
        command(turning_cell +
                    "restart 100 r.*.restart\nfix s all snapshot/disc 20 file s.h5\n"
                    "fix g all ave/micromacro 20 60 file g.csv rings 0.02 0.045 5 kn 400\n"
                    "run 10000000\n",
                ranks);
    const pid_t process = fork();
    if (process == 0) {
      execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      _exit(127);
    }
    for (int k = 0; k < 3000 && frames_now() < 15; ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return process;
  }

  /// Frames as those of a run that ended by itself on as many ranks; the table is of frames of the file.
  void expect_complete_files(int ranks) const {
    ASSERT_GE(frames_now(), 15U);
    const std::int64_t last = snapshots().rbegin()->first;
    // Lists of neighbours are built anew where a restart file is written.
    run(turning_cell +
            fmt::format("restart 100 w.*.restart\nfix s all snapshot/disc 20 file whole.h5\nrun {}\n", last),
        ranks);
    EXPECT_EQ(snapshots(), snapshots("whole.h5"));
    const std::string h5py = fmt::format(
        "/usr/bin/python3 -c 'import h5py, sys; f = h5py.File(\"{}\", \"r\", swmr=True); "
        "sys.exit(int(f[\"particles/discs/position/step\"][-1] != {}))'",
        path("s.h5"), last);
    EXPECT_EQ(std::system(h5py.c_str()), 0);
    const std::string head = text("g.csv"), frames = "steps 20 to ";
    const auto place = head.find(frames);
    ASSERT_NE(place, std::string::npos) << head;
    average(fmt::format("--rings 0.02 0.045 5 --steps 20:{}", std::stol(head.substr(place + frames.size()))),
            "averaged.csv");
    EXPECT_EQ(table("g.csv"), table("averaged.csv"));
  }

  /// Continues by 100 steps from the last restart file that is complete for sure: the one before the last.
  void expect_to_go_on(int ranks) const {
    std::int64_t step = 100;
    while (std::filesystem::exists(path(fmt::format("r.{}.restart", step + 200)))) step += 100;
    run(turning_cell_from(fmt::format("r.{}.restart", step)) +
            "fix s all snapshot/disc 20 file s.h5 append yes\nrun 100\n",
        ranks);
    const auto frames = snapshots();
    ASSERT_EQ(frames.size(), static_cast<std::size_t>(step + 100) / 20 + 1);
    EXPECT_EQ(frames.rbegin()->first, step + 100);
  }
};

class Killed : public EndedRun {
 protected:
  // Ranks are the children of mpirun, of any of its threads.
  static std::vector<pid_t> children_of(pid_t parent) {
    std::vector<pid_t> children;
    for (const auto& thread : std::filesystem::directory_iterator(fmt::format("/proc/{}/task", parent))) {
      std::ifstream list(thread.path() / "children");
      for (pid_t child = 0; list >> child;) children.push_back(child);
    }
    std::sort(children.begin(), children.end());  // in the order of the ranks
    return children;
  }

  /// Of two ranks.
  void run_and_kill(const std::vector<std::size_t>& victims) const {
    const pid_t mpirun = endless_run(2);
    const auto ranks = children_of(mpirun);
    ASSERT_EQ(ranks.size(), 2U) << text("screen.txt");
    for (const std::size_t victim : victims) kill(ranks[victim], SIGKILL);
    int status = 0;
    waitpid(mpirun, &status, 0);
    ASSERT_FALSE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "the run ended before it was killed";
    expect_complete_files(2);
    expect_to_go_on(2);
  }
};

TEST_F(Killed, OneRankThatWrites) {
  run_and_kill({0});
}

TEST_F(Killed, OneRankThatDoesNotWrite) {
  run_and_kill({1});
}

TEST_F(Killed, AllRanks) {
  run_and_kill({0, 1});
}

/// LAMMPS has no handlers of signals: all of them end it in whatever instant. LIGGGHTS ends after the step.
class Signalled : public EndedRun, public testing::WithParamInterface<std::pair<int, int>> {};

TEST_P(Signalled, LeavesCompleteFiles) {
  const auto [signal, ranks] = GetParam();
  const pid_t process = endless_run(ranks);
  kill(process, signal);
  int status = 0;
  waitpid(process, &status, 0);
  expect_complete_files(ranks);
  expect_to_go_on(ranks);
}

INSTANTIATE_TEST_SUITE_P(Program, Signalled,
                         testing::Values(std::pair(SIGTERM, 1), std::pair(SIGTERM, 2), std::pair(SIGINT, 1),
                                         std::pair(SIGINT, 2)),
                         [](const auto& info) {
                           return std::string(info.param.first == SIGTERM ? "SIGTERM" : "SIGINT") + "_on_" +
                                  std::to_string(info.param.second);
                         });

}  // namespace
}  // namespace mikromakro::test
