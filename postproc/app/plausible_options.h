// What options say beside what the frames show: numbers in other units, or of other runs.
#pragma once

#include "io/frame.h"
#include "io/notes.h"
#include "options/volume_options.h"

namespace mikromakro {

/// Notes a height of more than 100 radii (in mm, say), and a kernel that is wider than the box.
void note_volumes(const Frame& frame, const VolumeOptions& volumes, Notes& notes);

/// Notes where the median of f_n/overlap over some contacts is not `normal_stiffness` (N/m) within a factor
/// of three, more than dashpots and Hertz' law make. Nothing for 0, and where
/// fewer than five contacts have both.
void note_stiffness(const Frame& frame, double normal_stiffness, Notes& notes);

}  // namespace mikromakro
