// SPDX-License-Identifier: GPL-2.0-or-later
// Thickness and stiffness as stored in the snapshot files of runs.
#pragma once

#include "io/frames/frame_stream.h"
#include "options/field_options.h"
#include "options/volume_options.h"

namespace mikromakro {

/// Takes the height from the files if no option gives it; an option that contradicts them takes precedence,
/// with a note. Throws if files contradict each other and no option decides, and on units other than SI.
void take_height(const FrameSource& source, double& height);
/// The same for k_n of the contacts between averaged discs. If it differs between pairs of types none is
/// taken, which is noted if `fields` need it.
void take_stiffness(const FrameSource& source, const std::vector<int>& bulk_types, FieldChoice& fields);

/// The same for mu of sliding_fraction, if that is among the names of `fields`.
void take_friction(const FrameSource& source, FieldChoice& fields);

/// Notes files of another law, k_n or mu than the first, and a file whose times begin before the last time of
/// the one before it in the same run.
void note_other_runs(const FrameSource& source);

/// Notes files whose rows lack the contacts with some walls.
void note_unrecorded_walls(const FrameSource& source);

/// Throws if step * `time_step` (s; 0: not given) is not the time that the file gives for the frame: the time
/// step of its run may have changed.
void check_time(const Frame& frame, const std::string& file, double time_step);

/// Notes a frame whose time is before `last`, the time of the previous frame (nan: not known), then updates
/// `last`.
void note_time(const Frame& frame, double& last, Notes& notes);

}  // namespace mikromakro
