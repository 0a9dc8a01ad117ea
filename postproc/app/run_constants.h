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

/// Notes if `mu` is given (above 0) and differs from that of a file.
void compare_friction(const FrameSource& source, double mu);

/// Throws if step * `time_step` (s; 0: not given) is not the time that the file gives for the frame: the time
/// step of its run may have changed.
void check_time(const Frame& frame, const std::string& file, double time_step);

/// Notes a frame whose time is before `last`, the time of the previous frame (nan: not known), then updates
/// `last`.
void note_time(const Frame& frame, double& last, Notes& notes);

}  // namespace mikromakro
