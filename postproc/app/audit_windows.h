// SPDX-License-Identifier: GPL-2.0-or-later
// Audits as functions of time.
#pragma once

#include <memory>

#include "app/audits.h"

namespace mikromakro {

using MakeAuditor = std::unique_ptr<Auditor> (*)(const AuditOptions&);

/// Prints a table with the balances of each window. Throws (failed run) if a balance of any window is off by
/// more than the bound. Overlapping windows cost as many times the work as they have frames.
void audit_windows(const AuditOptions& options, MakeAuditor make);

}  // namespace mikromakro
