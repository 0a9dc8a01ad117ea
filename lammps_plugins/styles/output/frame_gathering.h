// SPDX-License-Identifier: GPL-2.0-or-later
// Gathers discs and contacts of all ranks into one frame, in the form that postproc reads from a file.
#pragma once

#include "io/frames/frame_format.h"

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace mikromakro::styles {

/// Gathers the discs of a group, sorted by id, and this step's contacts between them and with walls, as from
/// append_contact_rows(), rank by rank; the states of the walls are on every rank. Complete on the first
/// rank; the others hold only step, time, box and walls. Stops the run on all ranks if the forces of this
/// step were not recorded. `style`: caller, for messages. Collective.
RawFrame gather_frame(LAMMPS_NS::LAMMPS& engine, int group_bit, const std::string& style);

/// Stops the run if the box is tilted: frames hold none.
void require_orthogonal_box(LAMMPS_NS::LAMMPS& engine, const std::string& style);

/// Warns if a height (m; 0: not given) is not plausible beside the radii: in mm, say.
void warn_of_height(LAMMPS_NS::LAMMPS& engine, const LAMMPS_NS::Fix& fix, double height);

/// Warns once if there are discs outside the group of the fix: frames lack the contacts with them.
void warn_of_discs_outside(LAMMPS_NS::LAMMPS& engine, const LAMMPS_NS::Fix& fix);

}  // namespace mikromakro::styles
