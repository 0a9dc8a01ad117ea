// SPDX-License-Identifier: GPL-2.0-or-later
// Warnings: prints the notes collected while reading.
#pragma once

#include <string>

#include "io/tables/csv_writer.h"
#include "model/notes.h"

namespace mikromakro {

/// Prints one line 'mikromakro: warning: ...' on stderr per note, each text once, or passes them to the
/// Listener of this thread.
void tell(const Notes& notes);

/// Prints such a line.
void tell(const std::string& warning);

/// Adds one header line of a table per note.
void describe_notes(const Notes& notes, Preamble& lines);

}  // namespace mikromakro
