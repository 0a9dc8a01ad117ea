// SPDX-License-Identifier: GPL-2.0-or-later
// Averages that would not fit into the memory of the machine.
#pragma once

#include "averaging/averager.h"

namespace mikromakro {

/// What one average holds at the same time.
struct MemoryNeed {
  double numbers = 0;  ///< of all sums over one frame
  int threads = 1;
  double blocks = 0;  ///< of frames, for errors
};

/// Throws where that is more than the machine has. `option` is the one that gives the volumes.
void check_memory(const MemoryNeed& need, std::string_view option);

}  // namespace mikromakro
