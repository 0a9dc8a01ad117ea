// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/parallel/ordered_sums.h"

#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

namespace mikromakro {
namespace {

Eigen::ArrayXd numbers_of_walls(const Frame& frame) {
  std::vector<double> numbers;
  for (const WallState& wall : frame.walls)
    numbers.insert(numbers.end(), wall.numbers.begin(), wall.numbers.end());
  return Eigen::Map<const Eigen::ArrayXd>(numbers.data(), std::ssize(numbers));
}

// From all parts of the list: discs that move as prescribed may come first, and are the same in all runs.
double sum_of_places(const Frame& frame) {
  constexpr std::size_t some = 64;
  const std::size_t stride = 1 + frame.particles.size() / some;
  double sum = 0;
  for (std::size_t i = 0; i < frame.particles.size(); i += stride)
    sum += frame.particles[i].position.x() + 0.7 * frame.particles[i].position.y();
  return sum;
}

// The frames in flight: each thread without other work reads the next frame and sums it.
class FramesUnderWay {
 public:
  FramesUnderWay(const NextFrame& next, const SumFrame& sum, int threads)
      : next_(next), sum_(sum), most_(2 * threads + 2) {}

  // Loop of the worker threads, until there are no more frames to read.
  void work() {
    Frame frame;
    Lock lock(mutex_);
    while (!over_) {
      if (may_read()) {
        read_and_sum(frame, lock);
      } else {
        changed_.wait(lock);
      }
    }
  }

  // Loop of the calling thread: passing on the sums that are next in order has priority.
  void take_all(const TakeSums& take) {
    Frame frame;
    Lock lock(mutex_);
    while (!over_ || taken_ < read_) {
      if (const auto next = done_.find(taken_); next != done_.end()) {
        const Outcome outcome = std::move(next->second);
        done_.erase(next);
        lock.unlock();
        if (outcome.error) std::rethrow_exception(outcome.error);
        take(outcome.sums);
        lock.lock();
        ++taken_;
        changed_.notify_all();
      } else if (may_read()) {
        read_and_sum(frame, lock);
      } else {
        changed_.wait(lock);
      }
    }
  }

  void stop() {
    const Lock lock(mutex_);
    over_ = true;
    changed_.notify_all();
  }

 private:
  using Lock = std::unique_lock<std::mutex>;
  // Errors are ordered with the sums.
  struct Outcome {
    FrameSums sums;
    std::exception_ptr error;
  };

  bool may_read() const { return !over_ && !reading_ && read_ - taken_ < most_; }

  // Releases the lock while working.
  void read_and_sum(Frame& frame, Lock& lock) {
    Outcome outcome;
    MakeFrame make;
    reading_ = true;
    lock.unlock();
    attempt(outcome, [&] { make = next_(); });
    lock.lock();
    reading_ = false;
    const bool some = make || outcome.error;
    over_ = over_ || !make;
    const std::int64_t index = some ? read_++ : 0;
    changed_.notify_all();
    if (!some) return;
    lock.unlock();
    if (make)
      attempt(outcome, [&] {
        make(frame);
        outcome.sums = {frame.index, frame.step,           frame.run,
                        frame.time,  sum_of_places(frame), numbers_of_walls(frame),
                        sum_(frame)};
      });
    lock.lock();
    over_ = over_ || outcome.error;
    done_.emplace(index, std::move(outcome));
    changed_.notify_all();
  }

  template <typename Action>
  static void attempt(Outcome& outcome, const Action& action) {
    try {
      action();
    } catch (...) {
      outcome.error = std::current_exception();
    }
  }

  const NextFrame& next_;
  const SumFrame& sum_;
  const std::int64_t most_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::int64_t, Outcome> done_;
  std::int64_t read_ = 0;   // frames read so far
  std::int64_t taken_ = 0;  // of these, handed over
  bool reading_ = false;
  bool over_ = false;
};

// Joins the worker threads before the frames are destroyed, whatever the calling thread throws.
class OtherThreads {
 public:
  OtherThreads(FramesUnderWay& frames, int count) : frames_(frames) {
    for (int i = 0; i < count; ++i) threads_.emplace_back([&frames] { frames.work(); });
  }
  ~OtherThreads() { frames_.stop(); }
  OtherThreads(const OtherThreads&) = delete;
  OtherThreads& operator=(const OtherThreads&) = delete;

 private:
  FramesUnderWay& frames_;
  std::vector<std::jthread> threads_;
};

}  // namespace

void sum_in_order(const NextFrame& next, const SumFrame& sum, int threads, const TakeSums& take) {
  FramesUnderWay frames(next, sum, threads);
  const OtherThreads others(frames, threads - 1);
  frames.take_all(take);
}

}  // namespace mikromakro
