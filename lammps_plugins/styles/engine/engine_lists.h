// SPDX-License-Identifier: GPL-2.0-or-later
// Fixes and computes in script order, independent of how the engine stores them.
#pragma once

#include <cstddef>
#include <span>

#include "compute.h"
#include "fix.h"
#include "modify.h"

namespace mikromakro::styles {

namespace lists {

template <class Modify>
std::span<LAMMPS_NS::Fix* const> fixes(const Modify& modify) {
  if constexpr (requires { modify.fix[modify.nfix]; }) {
    return {modify.fix, static_cast<std::size_t>(modify.nfix)};
  } else {
    // get_fix_list() is not const, but changes nothing.
    return const_cast<Modify&>(modify).get_fix_list();
  }
}

template <class Modify>
std::span<LAMMPS_NS::Compute* const> computes(const Modify& modify) {
  if constexpr (requires { modify.compute[modify.ncompute]; }) {
    return {modify.compute, static_cast<std::size_t>(modify.ncompute)};
  } else {
    return const_cast<Modify&>(modify).get_compute_list();
  }
}

template <class Modify>
int mask_of(const Modify& modify, LAMMPS_NS::Fix* fix) {
  if constexpr (requires { modify.get_fix_mask(fix); }) {
    return modify.get_fix_mask(fix);
  } else {
    const auto all = fixes(modify);
    for (std::size_t k = 0; k < all.size(); ++k)
      if (all[k] == fix) return modify.fmask[k];
    return 0;
  }
}

}  // namespace lists

inline std::span<LAMMPS_NS::Fix* const> fixes(const LAMMPS_NS::Modify& modify) {
  return lists::fixes(modify);
}

inline std::span<LAMMPS_NS::Compute* const> computes(const LAMMPS_NS::Modify& modify) {
  return lists::computes(modify);
}

/// The fix's mask: the points of a step at which it is called (FixConst).
inline int mask_of(const LAMMPS_NS::Modify& modify, LAMMPS_NS::Fix* fix) {
  return lists::mask_of(modify, fix);
}

}  // namespace mikromakro::styles
