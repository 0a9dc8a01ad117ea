// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/averaging_run.h"

#include <algorithm>
#include <atomic>
#include <thread>

#include "app/coverage.h"
#include "app/plausible_options.h"
#include "app/progress.h"
#include "app/runs_used.h"
#include "app/warnings.h"
#include "averaging/repeated_frames.h"
#include "io/files/file_list.h"
#include "model/error.h"
#include "options/value_checks.h"

namespace mikromakro {
namespace {

// Checks on rank 0 that everything requested was found, in each of the runs.
void check_found(const FrameSource& source, const VolumeOptions& volumes, const TypesSeen& types,
                 const Averaged& averaged, const RunsUsed& runs) {
  if (averaged.sums.frames() == 0) throw source.no_frame_selected();
  check_types(source, "--bulk-types", types);
  if ((averaged.sums.mean() == 0).all()) check_coverage(source, volumes);
  note_unused_runs(source, runs);
  note_unlike_runs(source);
  if (runs.any_zero()) note_empty_frames(source, volumes, runs.all_zero());
}

// Detects pieces of one run that were given as several runs.
class Continuations {
 public:
  /// Whether the frame is the first of its run and continues the frame interval of the previous run.
  bool add(const FrameSums& frame) {
    const bool goes_on = frame.run != run_ && interval_ > 0 && frame.step > step_ &&
                         static_cast<double>(frame.step - step_) < 1.5 * static_cast<double>(interval_);
    interval_ = frame.run == run_ ? frame.step - step_ : 0;
    step_ = frame.step;
    run_ = frame.run;
    return goes_on;
  }

 private:
  std::int64_t run_ = -1, step_ = 0, interval_ = 0;
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

Averaged average_frames(const FrameSource& source, const VolumeOptions& volumes, const SumFrame& sum,
                        TimeAverage sums, const RunOptions& options, const Ranks& ranks) {
  std::int64_t all_bytes = 0;
  ranks.agree([&] { all_bytes = total_size(source.files()); });
  Progress progress(all_bytes, options.quiet || !ranks.first());
  Averaged averaged{std::move(sums), {}, {}};
  std::atomic<std::int64_t> bytes = 0;
  TypesSeen types(volumes.bulk_types);
  const SumFrame look_and_sum = [&](const Frame& frame) {
    types.look(frame);
    note_volumes(frame, volumes, *source.notes);
    return sum(frame);
  };
  const auto read_and_sum = [&](const TakeSums& take) {
    FrameSource own = source;
    own.of_all_ranks = source.settled_selection();
    own.selection = ranks.own_part(*own.of_all_ranks);
    FrameStream stream(own);
    const auto next = [&] {
      MakeFrame make = stream.take();
      bytes = stream.bytes_read();
      return make;
    };
    sum_in_order(next, look_and_sum, threads_of(options, ranks), take);
  };
  RunsUsed runs(1 + source.further_runs.size());
  RepeatedFrames repeated;
  Continuations continuations;
  ranks.gather_in_order(read_and_sum, [&](const FrameSums& frame) {
    if (!source.further_runs.empty() && repeated.add(frame))
      source.notes->add("frames are the same in two runs and count twice (one run in two forms?)",
                        frame.step);
    if (continuations.add(frame))
      source.notes->add(
          "a run goes on where the run before it ended; as runs they count as independent (pieces of one "
          "run? "
          "all files behind one --particles)",
          frame.step);
    runs.add(frame.run, (frame.sums == 0).all());
    averaged.add(frame.step, frame.sums, frame.run);
    progress.update(bytes, averaged.sums.frames());
  });
  ranks.gather(*source.notes);
  ranks.agree([&] {
    if (ranks.first()) check_found(source, volumes, types, averaged, runs);
  });
  if (ranks.first()) tell(*source.notes);
  return averaged;
}

}  // namespace mikromakro
