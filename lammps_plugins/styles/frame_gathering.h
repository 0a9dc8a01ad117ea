// SPDX-License-Identifier: GPL-2.0-or-later
// The discs and contacts of all ranks as one frame, as postproc reads it from a file.
#pragma once

#include "io/frames/frame_format.h"

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace mikromakro::styles {

/// The discs of a group, by id, and the contacts of this step between them and with walls, as
/// append_contact_rows gives them, rank after rank; the states of the walls, on every rank; complete on the
/// first rank, and empty but for step, time and box on the others. Ends the run on all ranks where the forces
/// of this step were not recorded: `style` is who asks. Every rank has to call it.
RawFrame gather_frame(LAMMPS_NS::LAMMPS& engine, int group_bit, const std::string& style);

/// One warning where there are discs that are not in the group of the fix: frames lack the contacts with
/// them.
void warn_of_discs_outside(LAMMPS_NS::LAMMPS& engine, const LAMMPS_NS::Fix& fix);

}  // namespace mikromakro::styles
