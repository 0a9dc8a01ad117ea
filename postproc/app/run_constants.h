// SPDX-License-Identifier: GPL-2.0-or-later
// Thickness and stiffness as snapshot files of runs hold them.
#pragma once

#include "io/frames/frame_stream.h"
#include "options/field_options.h"
#include "options/volume_options.h"

namespace mikromakro {

/// Takes over the height that the files hold, where no option gives one: an option that contradicts them
/// counts, which is noted. Throws where files contradict each other and no option decides, and on units other
/// than SI.
void take_height(const FrameSource& source, double& height);
/// The same for k_n, of the contacts of averaged discs; where it differs from pair to pair of types none is
/// taken, which is noted where `fields` need it.
void take_stiffness(const FrameSource& source, const std::vector<int>& bulk_types, FieldChoice& fields);

/// Notes where `mu` is given (above 0) and is not the one of a file.
void compare_friction(const FrameSource& source, double mu);

/// Throws where step * `time_step` (s; 0: not given) is not the time that the file gives the frame: the time
/// step of its run may have changed.
void check_time(const Frame& frame, const std::string& file, double time_step);

/// Notes a frame whose time is before `last`, that of the frame before it (nan: not known), and goes on to
/// it.
void note_time(const Frame& frame, double& last, Notes& notes);

}  // namespace mikromakro
