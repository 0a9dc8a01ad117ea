#include "averaging/ordered_sums.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "io/error.h"
#include "lattice_frame.h"

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
  explicit Frames(int count, int bad = -1) : count_(count), bad_(bad) {}

  bool next(Frame& frame) {
    EXPECT_FALSE(busy_.exchange(true)) << "two threads read at once";
    if (read_ == bad_) {
      busy_ = false;
      throw bad_input({"file", 7}, "no frame", "a frame", "none");
    }
    const bool some = read_ < count_;
    if (some) {
      LatticeSetup lattice{1, 1.9 + 1e-3 * read_, 50, read_ == 5 ? 12 : 3, Eigen::Matrix2d::Identity()};
      frame = make_lattice(lattice);
      frame.step = 100 * read_++;
    }
    busy_ = false;
    return some;
  }

 private:
  int count_;
  int bad_;
  int read_ = 0;
  std::atomic<bool> busy_ = false;
};

struct Taken {
  std::vector<std::int64_t> steps;
  Rows total = Rows::Zero(0, 0);
};

void take_all(Frames& frames, int threads, Taken& taken) {
  const Averager averager = ring_averager();
  sum_in_order([&](Frame& frame) { return frames.next(frame); }, averager, threads,
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

TEST(SumInOrder, AnErrorOfTheReaderComesAfterAllEarlierFrames) {
  for (const int threads : {1, 2, 4}) {
    Frames frames(40, 9);
    Taken taken;
    EXPECT_THROW(take_all(frames, threads, taken), Error);
    EXPECT_EQ(taken.steps.size(), 9U);
  }
}

TEST(SumInOrder, AnErrorOfTheTakerEndsAllThreads) {
  const Averager averager = ring_averager();
  for (const int threads : {1, 3}) {
    Frames frames(1000000);
    EXPECT_THROW(sum_in_order([&](Frame& frame) { return frames.next(frame); }, averager, threads,
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
      [&](Frame& frame) {
        const bool some = frames.next(frame);
        read += some ? 1 : 0;
        return some;
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
