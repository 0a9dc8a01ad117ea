// SPDX-License-Identifier: GPL-2.0-or-later
// Plausibility of options in view of the frames: values in other units or from other runs. Checks that need
// statistics require at least 20 discs or contacts.
#pragma once

#include "model/frame.h"
#include "model/notes.h"
#include "options/volume_options.h"

namespace mikromakro {

/// Notes a height (m; 0: not given) that is not plausible: in mm, say.
void note_height(const Frame& frame, double height, Notes& notes);

/// Notes an areal density (kg/m^2) above that of metals for discs of this height (m; 0: five diameters): in
/// kg/m^3, say.
void note_density(const Frame& frame, double density, double height, Notes& notes);

/// Notes a height that is not plausible (given in mm, say), a kernel wider than the box, and volumes that
/// together extend more than five times as far as the discs, or less than a radius.
void note_volumes(const Frame& frame, const VolumeOptions& volumes, Notes& notes);

/// For stresses: notes if branch vectors of the length of the radii (`--branch radius`) are too long by more
/// than 2 %, from the mean overlap over the mean diameter.
void note_branch(const Frame& frame, const VolumeOptions& volumes, Notes& notes);

/// Notes if, in half of the frames that show it, most contacts at or above |f_t| = mu |f_n| are above it, or
/// several have one and the same largest ratio below mu. Does nothing for 0.
void note_friction(const Frame& frame, double mu, Notes& notes);

/// Notes if, in half of the frames, `normal_stiffness` (N/m) is not that of f_n/overlap over a sample of
/// contacts: by a tenth if it is `given` by the user and these are alike, else by a factor of ten, since
/// dashpots add to forces. Does nothing for 0 or nan, or if fewer than five contacts have both.
void note_stiffness(const Frame& frame, double normal_stiffness, bool given, Notes& notes);

}  // namespace mikromakro
