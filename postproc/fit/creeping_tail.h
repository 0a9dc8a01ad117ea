// SPDX-License-Identifier: GPL-2.0-or-later
// Where a velocity profile leaves its exponential and creeps.
#pragma once

#include "fit/fit_choices.h"

namespace mikromakro {

/// A profile up to the ring from which on it falls more slowly.
struct CreepingTail {
  bool found = false;
  double last_r = 0;           ///< of the last ring before the tail (m)
  Eigen::Index rings = 0;      ///< in the tail
  double s = 0;                ///< decay length of the tail (m); nan or negative: it does not decay
  double evidence = 0;         ///< BIC of one line less that of two, > 0 if found
  Eigen::Index sign_from = 0;  ///< rings at the outer end, from the first that moves the other way on
};

/// Two straight lines through log v against r, the first through at least 4 rings and the second, which falls
/// less, through at least 3, break at the ring at which the sum of their squared residuals is least. The tail
/// is found if they have a smaller BIC = m log(sum/n) + k log m (Schwarz1978), k = 5 with the break, than one
/// line, k = 2; of the n rings, m are independent: neighbours share discs. Rings from the first on that moves
/// the other way have no logarithm and belong to the tail.
CreepingTail creeping_tail(const RingProfile& profile);

}  // namespace mikromakro
