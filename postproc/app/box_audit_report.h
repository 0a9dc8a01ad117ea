// SPDX-License-Identifier: GPL-2.0-or-later
// Results of a box audit, as text and as JSON.
#pragma once

#include <vector>

#include "app/audit_report.h"
#include "audit/box_balance.h"
#include "audit/cell_balance.h"

namespace mikromakro {

struct BoxAudit {
  AuditUnits units;
  BoxBalance box;
  double disc_volume = 0;  // of discs with their centres inside, per frame
  std::vector<CellBalance> cells;
  Balances balances;
};

void print_text(const BoxAudit& audit);
void print_json(const BoxAudit& audit);

}  // namespace mikromakro
