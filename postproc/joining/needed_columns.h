// SPDX-License-Identifier: GPL-2.0-or-later
// Which columns of contacts a file must have, and which of them are read.
#pragma once

#include "model/columns.h"

namespace mikromakro {

/// The columns without which contacts cannot be joined: normal and overlap can be derived, and the force
/// where its two components along normal and tangent are given.
ColumnSet required_contact_columns(ColumnSet needed, ColumnSet given);

/// The columns that are read of those `given`: nothing that can be left out; all of them without any wish (to
/// copy frames); `closely`: those besides that can be checked.
ColumnSet wanted_contact_columns(ColumnSet needed, ColumnSet given, bool closely = false);

}  // namespace mikromakro
