// SPDX-License-Identifier: GPL-2.0-or-later
// Plausibility of options in view of the frames: values in other units or from other runs. Checks that need
// statistics require at least 20 discs or contacts.
#pragma once

#include "app/input_options.h"
#include "model/frame.h"
#include "model/notes.h"
#include "options/volume_options.h"

namespace mikromakro {

/// Notes a height that is not plausible (given in mm, say), a kernel wider than the box, and volumes that
/// together extend more than five times as far as the discs, or less than a radius.
void note_volumes(const Frame& frame, const VolumeOptions& volumes, Notes& notes);

/// Whether the contact rows are those of stock engines, without a file of those with walls.
bool lack_walls(const InputOptions& input);

/// For stresses: notes that contact rows of stock engines lack contacts with walls, unless the box is
/// periodic.
void note_walls(const Frame& frame, const InputOptions& input, Notes& notes);

/// For stresses: notes if branch vectors of the length of the radii (`--branch radius`) are too long by more
/// than 2 %, from the mean overlap over the mean diameter.
void note_branch(const Frame& frame, const VolumeOptions& volumes, Notes& notes);

/// Notes if, in half of the frames, more than a tenth of a sample of contacts carry |f_t| > mu |f_n|, or
/// several have one and the same largest ratio below mu. Does nothing for 0.
void note_friction(const Frame& frame, double mu, Notes& notes);

/// Notes if, in half of the frames, `normal_stiffness` (N/m) is not that of f_n/overlap over a sample of
/// contacts: by a tenth if these are alike, by a factor of ten if dashpots scatter them. Does nothing for 0,
/// or if fewer than five contacts have both.
void note_stiffness(const Frame& frame, double normal_stiffness, Notes& notes);

}  // namespace mikromakro
