// SPDX-License-Identifier: GPL-2.0-or-later
// One pass over the input frames, distributed over threads and ranks.
#pragma once

#include <CLI/CLI.hpp>

#include "averaging/parallel/ordered_sums.h"
#include "averaging/parallel/ranks.h"
#include "options/average_options.h"
#include "verbs/input_options.h"

namespace mikromakro {

struct RunOptions {
  int threads = 0;  ///< 0: as many as the machine has
  bool quiet = false;
};

void add_run_options(CLI::App& app, RunOptions& options);

int threads_of(const RunOptions& options, const Ranks& ranks);

/// Sums each frame with `sum` and passes the results to `take` on rank 0, in order. Collective.
void sum_frames(const FrameSource& source, const SumFrame& sum, const RunOptions& options, const Ranks& ranks,
                const TakeSums& take);

/// Sums the frames over `volumes` with `sum`; returns the result on rank 0, to which the other ranks
/// contribute. Collective. `sums` is an empty average to fill; `also` receives the frames on rank 0, in
/// order. Rank 0 prints the notes of all ranks. Throws on read errors, if no frame was selected, and if the
/// volumes contain nothing.
Averaged average_frames(const FrameSource& source, const VolumeOptions& volumes, const SumFrame& sum,
                        TimeAverage sums, const RunOptions& options, const Ranks& ranks,
                        const TakeSums& also = {});

}  // namespace mikromakro
