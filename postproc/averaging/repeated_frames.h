// SPDX-License-Identifier: GPL-2.0-or-later
// Frames that are in several runs, whatever files they were read from.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <map>
#include <vector>

#include "averaging/parallel/ordered_sums.h"

namespace mikromakro {

/// Knows a frame again by its step and its sums, weighted so that what lies where counts: the same run once
/// more in another format, with fewer digits, or a part of its frames. Keeps three numbers per sum and frame.
class RepeatedFrames {
 public:
  /// Whether a frame of an earlier run is this one: the same step, and all sums to 1e-4. Never
  /// those with fewer than four sums that are not 0, nor those of a run in which nothing moves, since those
  /// of another run may be like them.
  bool add(const FrameSums& frame);

 private:
  struct Seen {
    std::int64_t run = 0;
    Eigen::ArrayXd sums, sizes;  ///< sum_k k q_k and sum_k k |q_k| over the volumes k, of each sum q
  };
  static bool same(const Seen& one, const Seen& other);

  std::map<std::int64_t, std::vector<Seen>> by_step_;
  Seen last_;
};

}  // namespace mikromakro
