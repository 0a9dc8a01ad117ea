// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/parallel/ordered_sums.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "lattice_frame.h"
#include "model/error.h"

namespace mikromakro {
namespace {

Averager ring_averager() {
  return {std::make_unique<const RingVolumes>(Eigen::Vector2d(0.3, 0.1), equal_ring_edges(0, 8, 16), 1),
          make_weight("sliced"),
          make_fields({}),
          {}};
}

// A lattice that is different in every frame; frame 5 takes longer than its neighbours.
class Frames {
 public:
  explicit Frames(int count) : count_(count) {}
  // One that cannot be found, one that cannot be made.
  Frames(int count, int missing, int bad) : count_(count), missing_(missing), bad_(bad) {}

  MakeFrame next() {
    EXPECT_FALSE(busy_.exchange(true)) << "two threads read at once";
    const int index = found_;
    if (index < count_) ++found_;
    busy_ = false;
    if (index == missing_) throw bad_input({"file", 7}, "no frame", "a frame", "none");
    if (index == count_) return {};
    return [this, index](Frame& frame) {
      if (index == bad_) throw bad_input({"file", 8}, "no frame", "a frame", "none");
      const LatticeSetup lattice{1, 1.9 + 1e-3 * index, 50, index == 5 ? 12 : 3, Eigen::Matrix2d::Identity()};
      frame = make_lattice(lattice);
      frame.step = 100 * index;
    };
  }

 private:
  int count_;
  int missing_ = -1;
  int bad_ = -1;
  int found_ = 0;
  std::atomic<bool> busy_ = false;
};

struct Taken {
  std::vector<std::int64_t> steps;
  Rows total = Rows::Zero(0, 0);
};

void take_all(Frames& frames, int threads, Taken& taken) {
  const Averager averager = ring_averager();
  sum_in_order([&] { return frames.next(); }, averager, threads,
               [&](const FrameSums& sums) {
                 taken.steps.push_back(sums.step);
                 taken.total = taken.total.size() == 0 ? sums.sums : Rows(taken.total + sums.sums);
               });
}

TEST(SumInOrder, IsTheSameToTheLastBitOnAnyNumberOfThreads) {
  Frames alone(40);
  Taken reference;
  take_all(alone, 1, reference);
  ASSERT_EQ(reference.steps.size(), 40U);
  for (const int threads : {2, 3, 8}) {
    Frames frames(40);
    Taken taken;
    take_all(frames, threads, taken);
    EXPECT_EQ(taken.steps, reference.steps);
    EXPECT_TRUE((taken.total == reference.total).all());
  }
}

TEST(SumInOrder, NoFramesAreNoError) {
  for (const int threads : {1, 4}) {
    Frames frames(0);
    Taken taken;
    take_all(frames, threads, taken);
    EXPECT_TRUE(taken.steps.empty());
  }
}

// The first bad frame ends the sum, whether it is bad when it is found or when it is made, and in front of
// others that are.
TEST(SumInOrder, AnErrorOfTheReaderComesAfterAllEarlierFrames) {
  struct Bad {
    int missing, bad;
    std::string place;
  };
  for (const Bad& bad :
       {Bad{9, -1, "file:7"}, Bad{-1, 9, "file:8"}, Bad{10, 9, "file:8"}, Bad{9, 10, "file:7"}}) {
    for (const int threads : {1, 2, 4}) {
      Frames frames(40, bad.missing, bad.bad);
      Taken taken;
      try {
        take_all(frames, threads, taken);
        ADD_FAILURE() << "no error";
      } catch (const Error& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with(bad.place)) << error.what();
      }
      EXPECT_EQ(taken.steps.size(), 9U);
    }
  }
}

// While one thread finds a frame, others make theirs: that is what makes text faster on two threads.
TEST(SumInOrder, FramesAreMadeWhileOthersAreFound) {
  const Averager averager = ring_averager();
  Frames frames(8);
  std::atomic<int> making = 0;
  std::atomic<bool> together = false;
  const auto next = [&]() -> MakeFrame {
    if (making > 0) together = true;
    MakeFrame make = frames.next();
    if (!make) return {};
    return [&, make](Frame& frame) {
      ++making;
      for (int wait = 0; wait < 200 && !together; ++wait)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      make(frame);
      --making;
    };
  };
  sum_in_order(next, averager, 2, [](const FrameSums&) {});
  EXPECT_TRUE(together);
}

TEST(SumInOrder, AnErrorOfTheTakerEndsAllThreads) {
  const Averager averager = ring_averager();
  for (const int threads : {1, 3}) {
    Frames frames(1000000);
    EXPECT_THROW(sum_in_order([&] { return frames.next(); }, averager, threads,
                              [](const FrameSums&) { throw bad_input({"taker"}, "full", "room", "none"); }),
                 Error);
  }
}

// 2 threads + 2 frames at most are read before the first is taken.
TEST(SumInOrder, ReadsOnlyAFewFramesAhead) {
  const Averager averager = ring_averager();
  std::atomic<int> read = 0;
  int most = 0;
  int taken = 0;
  Frames frames(60);
  sum_in_order(
      [&] {
        MakeFrame make = frames.next();
        read += make ? 1 : 0;
        return make;
      },
      averager, 3,
      [&](const FrameSums&) {
        if (taken == 0) std::this_thread::sleep_for(std::chrono::milliseconds(50));
        most = std::max(most, read - taken++);
      });
  EXPECT_EQ(taken, 60);
  EXPECT_LE(most, 8);
}

}  // namespace
}  // namespace mikromakro
