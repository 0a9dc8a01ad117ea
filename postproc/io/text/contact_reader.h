// SPDX-License-Identifier: GPL-2.0-or-later
// Contact rows of text dumps.
#pragma once

#include <string>
#include <vector>

#include "io/text/dump_reader.h"
#include "model/contact_rows.h"

namespace mikromakro {

/// How the columns of a dump are called (empty: as its header says), and which kind of dump it is.
struct ContactFormat {
  const std::vector<std::string>& list;
  bool walls = false;
  bool closely = false;  ///< all columns that can be checked are read
};

/// Reads the rows of a frame. The names are those of the format (none: the header's own, or the 16 columns of
/// `compute contact/disc` where the header says c_X[1] ... c_X[16]; of walls the preset of LIGGGHTS);
/// `needed` must be among them, except for what can be derived. Columns that are not wanted are skipped,
/// whatever they hold. Throws: missing columns, rows that are not in a plane, and all that check_contact_row
/// throws.
ContactRows read_contacts(const RowBlock& block, const ContactFormat& format, ColumnSet needed);

}  // namespace mikromakro
