// SPDX-License-Identifier: GPL-2.0-or-later
// Record of what a run simulates, as stored in snapshots.
#pragma once

#include "io/snapshot/snapshot_parameters.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

/// Units, the group whose discs are in the file, names of the simulated effects, engine, the given material
/// constants by name, and the thickness if given (m, > 0). Call when a run starts.
SnapshotParameters run_record(LAMMPS_NS::LAMMPS& engine, const std::string& group, double height);

}  // namespace mikromakro::styles
