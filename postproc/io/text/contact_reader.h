// SPDX-License-Identifier: GPL-2.0-or-later
// Contact rows of text dumps.
#pragma once

#include <string>
#include <vector>

#include "io/text/dump_reader.h"
#include "model/contact_rows.h"

namespace mikromakro {

/// Column names of a dump (empty: as in its header), and its kind.
struct ContactFormat {
  const std::vector<std::string>& list;
  bool walls = false;
  bool closely = false;  ///< read all columns that can be checked
};

/// Reads the rows of a frame. Column names are those of the format (if empty: the header's own, or the 16
/// columns of `compute contact/disc` if the header says c_X[1] ... c_X[16]; for walls, the LIGGGHTS preset).
/// They must include `needed`, except for what can be derived. Other columns are skipped, whatever they hold.
/// Throws on missing columns, on rows that are not in a plane, and on everything that check_contact_row
/// throws on.
ContactRows read_contacts(const RowBlock& block, const ContactFormat& format, ColumnSet needed);

}  // namespace mikromakro
