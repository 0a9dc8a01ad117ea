// SPDX-License-Identifier: GPL-2.0-or-later
// noexcept of destructors: an additional base class of a style must promise what the engine's base class
// does.
#pragma once

#include <type_traits>

#include "pointers.h"

namespace mikromakro::styles {

/// Destructors of styles may throw in newer LAMMPS.
inline constexpr bool styles_never_throw = std::is_nothrow_destructible_v<LAMMPS_NS::Pointers>;

}  // namespace mikromakro::styles
