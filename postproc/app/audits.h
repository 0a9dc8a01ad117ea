// SPDX-License-Identifier: GPL-2.0-or-later
// The audits of `mikromakro audit`. Each prints its table and returns its balances.
#pragma once

#include "app/audit_input.h"
#include "app/audit_report.h"

namespace mikromakro {

/// Torque, radial momentum, forces on discs, volume over rings.
Balances audit_rings(const AuditOptions& options);

/// Stress of volume and walls, forces on discs and walls, volume, momentum of cells: for --box, --grid or,
/// with neither, the rectangle between the walls of each frame.
Balances audit_box(const AuditOptions& options);

}  // namespace mikromakro
