// SPDX-License-Identifier: GPL-2.0-or-later
// Detects frames that occur in several runs, whatever files they were read from.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <map>
#include <vector>

#include "averaging/parallel/ordered_sums.h"

namespace mikromakro {

/// Recognises a frame by its step and its sums, weighted so that their distribution over the volumes matters:
/// the same run again in another format, with fewer digits, or in part. Stores three numbers per sum and
/// frame.
class RepeatedFrames {
 public:
  /// Whether an earlier run contains this frame: the same step, and all sums equal to 1e-4. Never true for
  /// frames with fewer than four non-zero sums, nor for runs in which nothing moves, since frames of another
  /// run may resemble these by chance.
  bool add(const FrameSums& frame);

 private:
  struct Seen {
    std::int64_t run = 0;
    Eigen::ArrayXd sums, sizes;  ///< sum_k k q_k and sum_k k |q_k| over volumes k, for each sum q
  };
  static bool same(const Seen& one, const Seen& other);

  std::map<std::int64_t, std::vector<Seen>> by_step_;
  Seen last_;
};

}  // namespace mikromakro
