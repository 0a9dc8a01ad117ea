// SPDX-License-Identifier: GPL-2.0-or-later
// Rejects averages that exceed the memory of the machine.
#pragma once

#include "averaging/averager.h"

namespace mikromakro {

/// Memory held at the same time by one average.
struct MemoryNeed {
  double numbers = 0;  ///< numbers in the sums over one frame
  int threads = 1;
  double blocks = 0;  ///< blocks of frames kept for errors
};

/// Throws if more memory is needed than the machine has. `option` is the one that defines the volumes.
void check_memory(const MemoryNeed& need, std::string_view option);

}  // namespace mikromakro
