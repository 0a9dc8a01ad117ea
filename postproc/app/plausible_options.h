// SPDX-License-Identifier: GPL-2.0-or-later
// Plausibility of options in view of the frames: values in other units or from other runs. Checks that need
// statistics require at least 20 discs or contacts.
#pragma once

#include "app/input_options.h"
#include "model/frame.h"
#include "model/notes.h"
#include "options/volume_options.h"

namespace mikromakro {

/// Throws on --branch and --height if none of the fields depends on them.
void check_use(const VolumeOptions& given, const Averager& averager);

/// Notes a height above 100 radii (e.g. given in mm) or below 1e-4 radii, a kernel wider than the box, and
/// volumes that extend more than five times as far as the discs.
void note_volumes(const Frame& frame, const VolumeOptions& volumes, Notes& notes);

/// For stresses: notes that contact rows of stock engines lack contacts with walls, unless the box is
/// periodic.
void note_walls(const Frame& frame, const InputOptions& input, Notes& notes);

/// For stresses: notes if branch vectors of the length of the radii (`--branch radius`) are too long by more
/// than 2 %, from the mean overlap over the mean diameter.
void note_branch(const Frame& frame, const VolumeOptions& volumes, Notes& notes);

/// Notes if the median of f_n/overlap over a sample of contacts differs from `normal_stiffness` (N/m) by more
/// than a factor of three, which dashpots and Hertz's law do not reach. Does nothing for 0, or if fewer than
/// five contacts have both.
void note_stiffness(const Frame& frame, double normal_stiffness, Notes& notes);

}  // namespace mikromakro
