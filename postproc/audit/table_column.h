// SPDX-License-Identifier: GPL-2.0-or-later
// Table columns by name.
#pragma once

#include <stdexcept>
#include <string_view>

#include "model/table.h"

namespace mikromakro {

/// The column of this name, whose field the caller must have requested. Throws std::logic_error if it is
/// missing.
inline Eigen::ArrayXd column_of(const Table& table, std::string_view name) {
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (table.columns[i].name == name) return table.rows.col(static_cast<Eigen::Index>(i));
  throw std::logic_error("the table has no such column");
}

}  // namespace mikromakro
