// SPDX-License-Identifier: GPL-2.0-or-later
// Quantities by which discs can be coloured.
#pragma once

#include <string>
#include <vector>

#include "model/columns.h"
#include "model/frame.h"

namespace mikromakro {

enum class DiscQuantity { radius, velocity, spin, pressure, contacts, type };

/// A quantity with its colour bar texts and the dump columns that it needs.
struct QuantityInfo {
  DiscQuantity quantity;
  std::string_view name;   ///< on the command line
  std::string_view label;  ///< next to the colour bar
  std::string_view unit;   ///< SI, empty if dimensionless
  ColumnSet particles_needed;
  ColumnSet contacts_needed;
};

/// Throws on an unknown name.
const QuantityInfo& disc_quantity(const std::string& name);
/// All names, for the help.
std::vector<std::string_view> disc_quantity_names();

/// The quantity of each disc, in the order of the frame. SI units.
/// pressure: p = -tr(sigma^p)/2 with sigma^p = 1/V^p sum_c l^pc f^pc (Latzel2001 Eq. 15), l = a_p n, V^p = pi
/// a^2 h; > 0 under compression.
std::vector<double> disc_values(const Frame& frame, DiscQuantity quantity, double height);

}  // namespace mikromakro
