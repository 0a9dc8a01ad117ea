// SPDX-License-Identifier: GPL-2.0-or-later
// Which contact columns a file must have, and which of them are read.
#pragma once

#include "model/columns.h"

namespace mikromakro {

/// The columns required to join contacts: normal and overlap can be derived, and so can the force if its
/// normal and tangential components are given.
ColumnSet required_contact_columns(ColumnSet needed, ColumnSet given);

/// The columns to read out of those `given`: only what is needed, or all of them if nothing in particular is
/// needed (to copy frames). `closely` adds those that serve as checks.
ColumnSet wanted_contact_columns(ColumnSet needed, ColumnSet given, bool closely = false);

}  // namespace mikromakro
