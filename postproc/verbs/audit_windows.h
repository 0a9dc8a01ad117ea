// SPDX-License-Identifier: GPL-2.0-or-later
// Audits as functions of time.
#pragma once

#include <memory>

#include "verbs/audits.h"

namespace mikromakro {

using MakeAuditor = std::unique_ptr<Auditor> (*)(const AuditOptions&);

/// A table with the balances of each window, and the first of those that are off by more than the bound.
/// Overlapping windows cost as many times the work as they have frames.
AuditReport audit_windows(const AuditOptions& options, MakeAuditor make);

}  // namespace mikromakro
