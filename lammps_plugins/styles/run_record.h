// SPDX-License-Identifier: GPL-2.0-or-later
// What a run simulates, as its snapshots say it.
#pragma once

#include "io/snapshot/snapshot_parameters.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mikromakro::styles {

/// Units, the group whose discs are in the file, names of the effects that are simulated, engine, and the
/// material constants that are given under their names; the thickness where it is given (m, > 0). To be
/// called when a run starts.
SnapshotParameters run_record(LAMMPS_NS::LAMMPS& engine, const std::string& group, double height);

}  // namespace mikromakro::styles
