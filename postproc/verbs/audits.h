// SPDX-License-Identifier: GPL-2.0-or-later
// `audit`: balances over rings or a box.
#pragma once

#include "verbs/audit_input.h"
#include "verbs/audit_report.h"

namespace mikromakro {

/// Torque, radial momentum, forces on discs, volume over rings.
AuditReport audit_rings(const AuditOptions& options);

/// Stress of volume and walls, forces on discs and walls, volume, momentum of cells: for --box, --grid or,
/// with neither, the rectangle between the walls of each frame.
AuditReport audit_box(const AuditOptions& options);

/// Either of them, as the options have it, with what they leave open taken from the files.
AuditReport audit(AuditOptions options);

}  // namespace mikromakro
