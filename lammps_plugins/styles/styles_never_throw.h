// SPDX-License-Identifier: GPL-2.0-or-later
// What stands beside the engine's base class of a style has to promise as much as it does.
#pragma once

#include <type_traits>

#include "pointers.h"

namespace mikromakro::styles {

/// Later LAMMPS lets the destructors of its styles throw.
inline constexpr bool styles_never_throw = std::is_nothrow_destructible_v<LAMMPS_NS::Pointers>;

}  // namespace mikromakro::styles
