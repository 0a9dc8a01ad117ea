// SPDX-License-Identifier: GPL-2.0-or-later
// Warnings: what the reading has noted, told to the user.
#pragma once

#include "io/tables/csv_writer.h"
#include "model/notes.h"

namespace mikromakro {

/// One line 'mikromakro: warning: ...' on stderr for each note.
void tell(const Notes& notes);

/// And one line above a table.
void describe_notes(const Notes& notes, Preamble& lines);

}  // namespace mikromakro
