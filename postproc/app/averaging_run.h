// One pass over the frames of the input: shared out among threads and ranks.
#pragma once

#include <CLI/CLI.hpp>

#include "app/input_options.h"
#include "averaging/ordered_sums.h"
#include "averaging/ranks.h"
#include "options/average_options.h"

namespace mikromakro {

struct RunOptions {
  int threads = 0;  ///< 0: as many as the machine has
  bool quiet = false;
};

void add_run_options(CLI::App& app, RunOptions& options);

/// The sums that `sum` makes of the frames, on rank 0; the others give their part. All ranks call it
/// together. `sums` is an empty average to fill. Rank 0 tells the notes of all. Throws what reading throws.
Averaged average_frames(const FrameSource& source, const SumFrame& sum, TimeAverage sums,
                        const RunOptions& options, const Ranks& ranks);

/// Throws where no frame was selected.
void require_frames(const Averaged& averaged, const FrameSource& source);

}  // namespace mikromakro
