// SPDX-License-Identifier: GPL-2.0-or-later
// Leaves out the frames during which something still drifts.
#pragma once

#include <string>

#include "verbs/averaging_run.h"

namespace mikromakro {

/// Reads all selected frames of `source`, and changes its selection to the frames from which on the mean of
/// `column` over the volumes does not drift (statistics/steady_state.h). Prints (unless there is a Listener)
/// and returns which frame that is, and why. Throws if there is no such column, if there are several runs or
/// too few frames, if the column is nan in all volumes of a frame, and (failed run) if it drifts to the end.
/// Collective.
std::string cut_to_steady_part(const std::string& column, const Averager& averager, const RunOptions& options,
                               const Ranks& ranks, FrameSource& source);

}  // namespace mikromakro
