// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/averaging_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "averaging/repeated_frames.h"
#include "io/files/file_list.h"
#include "model/error.h"
#include "options/plausible_options.h"
#include "options/value_checks.h"
#include "verbs/coverage.h"
#include "verbs/progress.h"
#include "verbs/runs_used.h"
#include "verbs/warnings.h"

namespace mikromakro {
namespace {

// Checks on rank 0 that everything requested was found, in each of the runs.
void check_found(const FrameSource& source, const VolumeOptions& volumes, const TypesSeen& types,
                 const Averaged& averaged, const RunsUsed& runs) {
  if (averaged.sums.frames() == 0) throw source.no_frame_selected();
  check_types(source, types);
  if ((averaged.sums.mean() == 0).all()) check_coverage(source, volumes);
  note_unused_runs(source, runs);
  note_unlike_runs(source);
  if (runs.any_zero()) note_empty_frames(source, volumes, runs.all_zero());
}

// Number and mean position of the discs of the first frame: the same for a file by any name and in any
// format.
class FirstFrame {
 public:
  void look(const Frame& frame) {
    const std::scoped_lock lock(mutex_);
    const auto here = std::pair(frame.run, frame.index);
    if (!(here < first_) || frame.particles.empty()) return;
    first_ = here;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Particle& disc : frame.particles) sum += disc.position;
    const Eigen::Vector2d mean = sum / static_cast<double>(frame.particles.size());
    text_ =
        fmt::format("{} discs, mean position {:.5g} {:.5g} m", frame.particles.size(), mean.x(), mean.y());
  }
  /// Of all ranks. By run and frame in the order of texts, of which there is one from each rank.
  std::string text(const Ranks& ranks) const {
    Notes firsts;
    if (!text_.empty()) firsts.add(fmt::format("{:020} {:020} {}", first_.first, first_.second, text_));
    ranks.gather(firsts);
    const std::vector<std::string> all = firsts.lines();
    constexpr std::size_t numbers = 42;
    return all.empty() ? "" : all.front().substr(numbers);
  }

 private:
  std::mutex mutex_;
  std::pair<std::int64_t, std::int64_t> first_ = {std::numeric_limits<std::int64_t>::max(), 0};
  std::string text_;
};

constexpr const char* goes_on =
    "a run continues where another ended; as separate runs they count as independent (pieces of one run? "
    "give all files to one --particles)";

// Detects pieces of one run that were given as several runs, in any order.
class Continuations {
 public:
  /// Whether the frame is the first of its run and continues an earlier run at that run's frame interval, or
  /// an earlier run continues the run that has just ended.
  bool add(const FrameSums& frame) {
    const bool starts = runs_.empty() || frame.run != runs_.back().run;
    if (!starts) {
      runs_.back().interval = frame.step - runs_.back().last;
      runs_.back().last = frame.step;
      return false;
    }
    const bool follow = ends() || std::any_of(runs_.begin(), runs_.end(), [&](const Of& earlier) {
                          return follows(frame.step, earlier);
                        });
    runs_.push_back({frame.run, frame.step, frame.step, 0});
    return follow;
  }

  /// Whether an earlier run continues the last one.
  bool ends() const {
    return !runs_.empty() && std::any_of(runs_.begin(), runs_.end() - 1, [&](const Of& earlier) {
      return follows(earlier.first, runs_.back());
    });
  }

 private:
  struct Of {
    std::int64_t run, first, last, interval;
  };
  static bool follows(std::int64_t step, const Of& run) {
    return run.interval > 0 && step > run.last &&
           static_cast<double>(step - run.last) < 1.5 * static_cast<double>(run.interval);
  }

  std::vector<Of> runs_;
};

}  // namespace

int threads_of(const RunOptions& options, const Ranks& ranks) {
  if (options.threads > 0) return options.threads;
  return ranks.size() > 1 ? 1 : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void add_run_options(CLI::App& app, RunOptions& options) {
  app.add_option("--threads", options.threads,
                 "threads, default all of the machine; 1 for each rank under mpirun")
      ->transform(whole_number(1, 1024));
  app.add_flag("--quiet", options.quiet, "no progress bar");
}

void sum_frames(const FrameSource& source, const SumFrame& sum, const RunOptions& options, const Ranks& ranks,
                const TakeSums& take) {
  std::int64_t all_bytes = 0, frames = 0;
  ranks.agree([&] { all_bytes = total_size(source.files()); });
  Progress progress(all_bytes, options.quiet || !ranks.first());
  std::atomic<std::int64_t> bytes = 0;
  const auto read_and_sum = [&](const TakeSums& take_here) {
    FrameSource own = source;
    own.of_all_ranks = source.settled_selection();
    own.selection = ranks.own_part(*own.of_all_ranks);
    FrameStream stream(own);
    const auto next = [&] {
      MakeFrame make = stream.take();
      bytes = stream.bytes_read();
      return make;
    };
    sum_in_order(next, sum, threads_of(options, ranks), take_here);
  };
  ranks.gather_in_order(read_and_sum, [&](const FrameSums& frame) {
    take(frame);
    progress.update(bytes, ++frames);
  });
}

Averaged average_frames(const FrameSource& source, const VolumeOptions& volumes, const SumFrame& sum,
                        TimeAverage sums, const RunOptions& options, const Ranks& ranks,
                        const TakeSums& also) {
  Averaged averaged{std::move(sums), {}, {}, {}};
  FirstFrame first;
  TypesSeen types("--bulk-types", volumes.bulk_types);
  const SumFrame look_and_sum = [&](const Frame& frame) {
    types.look(frame);
    first.look(frame);
    note_volumes(frame, volumes, *source.notes);
    return sum(frame);
  };
  RunsUsed runs(1 + source.further_runs.size());
  RepeatedFrames repeated;
  Continuations continuations;
  std::int64_t last_step = 0;
  sum_frames(source, look_and_sum, options, ranks, [&](const FrameSums& frame) {
    if (!source.further_runs.empty() && repeated.add(frame))
      source.notes->add(
          "frames are the same in two runs and count twice (one run in two forms, or a common initial "
          "state?)",
          frame.step);
    if (continuations.add(frame)) source.notes->add(goes_on, frame.step);
    last_step = frame.step;
    runs.add(frame.run, (frame.sums == 0).all());
    averaged.add(frame.step, frame.sums, frame.run);
    if (also) also(frame);
  });
  if (continuations.ends()) source.notes->add(goes_on, last_step);
  ranks.gather(*source.notes);
  for (std::size_t i = 0; i < volumes.bulk_types.size(); ++i) ranks.gather(types.without(i));
  ranks.agree([&] {
    if (ranks.first()) check_found(source, volumes, types, averaged, runs);
  });
  averaged.first_frame = first.text(ranks);
  if (ranks.first()) tell(*source.notes);
  return averaged;
}

}  // namespace mikromakro
