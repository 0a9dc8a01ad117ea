// SPDX-License-Identifier: GPL-2.0-or-later
// Forces on discs that are in none of our outputs.
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

/// At the start of a run: one warning that names the fixes (and styles of bonds) that push discs as contacts
/// do, or may do so, while a compute or fix of ours says what contacts there are. Body forces such as gravity
/// are no contacts and known; every fix that is not known is named.
void warn_of_unseen_forces(LAMMPS_NS::LAMMPS& engine);

}  // namespace mikromakro::styles
