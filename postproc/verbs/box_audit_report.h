// SPDX-License-Identifier: GPL-2.0-or-later
// Results of a box audit, as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include "audit/box_balance.h"
#include "audit/cell_balance.h"
#include "verbs/audit_report.h"

namespace mikromakro {

struct BoxAudit {
  AuditUnits units;
  BoxBalance box;
  double disc_volume = 0;  // of discs with their centres inside, per frame
  std::vector<CellBalance> cells;
  Balances balances;
};

std::string text_of(const BoxAudit& audit);
Json json_of(const BoxAudit& audit);

}  // namespace mikromakro
