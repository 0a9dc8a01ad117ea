// SPDX-License-Identifier: GPL-2.0-or-later
// What an audit of a box has found, as text and as JSON.
#pragma once

#include <vector>

#include "app/audit_report.h"
#include "audit/box_balance.h"
#include "audit/cell_balance.h"

namespace mikromakro {

struct BoxAudit {
  AuditUnits units;
  BoxBalance box;
  double disc_volume = 0;  // of discs with their centres inside, a frame
  std::vector<CellBalance> cells;
  Balances balances;
};

void print_text(const BoxAudit& audit);
void print_json(const BoxAudit& audit);

}  // namespace mikromakro
