// SPDX-License-Identifier: GPL-2.0-or-later
// What options say beside what the frames show: numbers in other units, or of other runs. What a few discs do
// not show is looked for from 20 discs or contacts on.
#pragma once

#include "app/input_options.h"
#include "model/frame.h"
#include "model/notes.h"
#include "options/volume_options.h"

namespace mikromakro {

/// Notes a height of more than 100 radii (in mm, say) or less than 1e-4 of one, a kernel that is wider than
/// the box, and volumes that reach more than five times as far as the discs.
void note_volumes(const Frame& frame, const VolumeOptions& volumes, Notes& notes);

/// For stresses: notes that rows of stock engines in a box that is not periodic lack contacts with walls.
void note_walls(const Frame& frame, const InputOptions& input, Notes& notes);

/// For stresses: notes where branches that are as long as the radii (`--branch radius`) are too long by more
/// than 2 %, the mean overlap over the mean diameter.
void note_branch(const Frame& frame, const VolumeOptions& volumes, Notes& notes);

/// Notes where the median of f_n/overlap over some contacts is not `normal_stiffness` (N/m) within a factor
/// of three, more than dashpots and Hertz' law make. Nothing for 0, and where
/// fewer than five contacts have both.
void note_stiffness(const Frame& frame, double normal_stiffness, Notes& notes);

}  // namespace mikromakro
