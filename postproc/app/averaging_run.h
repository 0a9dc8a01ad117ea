// SPDX-License-Identifier: GPL-2.0-or-later
// One pass over the frames of the input: shared out among threads and ranks.
#pragma once

#include <CLI/CLI.hpp>

#include "app/input_options.h"
#include "averaging/parallel/ordered_sums.h"
#include "averaging/parallel/ranks.h"
#include "options/average_options.h"

namespace mikromakro {

struct RunOptions {
  int threads = 0;  ///< 0: as many as the machine has
  bool quiet = false;
};

void add_run_options(CLI::App& app, RunOptions& options);

int threads_of(const RunOptions& options, const Ranks& ranks);

/// The sums that `sum` makes of the frames over `volumes`, on rank 0; the others give their part. All ranks
/// call it together. `sums` is an empty average to fill. Rank 0 tells the notes of all. Throws what reading
/// throws, and where no frame was selected or the volumes hold nothing.
Averaged average_frames(const FrameSource& source, const VolumeOptions& volumes, const SumFrame& sum,
                        TimeAverage sums, const RunOptions& options, const Ranks& ranks);

}  // namespace mikromakro
