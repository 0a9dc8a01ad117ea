// SPDX-License-Identifier: GPL-2.0-or-later
// Detects frames that occur in several runs, regardless of the files they come from.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <map>
#include <vector>

#include "averaging/parallel/ordered_sums.h"

namespace mikromakro {

/// Recognises a frame by its step and its sums, weighted so that their distribution over the volumes matters:
/// the same run again in another format, with fewer digits, or in part. If discs are in the same places to
/// the last bit, the steps need not: the same run with its steps counted from elsewhere. Stores three numbers
/// per sum and frame.
class RepeatedFrames {
 public:
  /// Whether an earlier run contains this frame: the same step, and at least four non-zero sums, all equal to
  /// 1e-4. If there are fewer sums, as for velocity alone, two of them must have changed since the previous
  /// frame, and all must be equal to 1e-12; numbers of discs do not count, since they agree by chance. Never
  /// true for runs in which nothing moves.
  bool add(const FrameSums& frame);

 private:
  struct Seen {
    std::int64_t run = 0;
    double places = not_given;
    Eigen::ArrayXd sums, sizes;  ///< sum_k k q_k and sum_k k |q_k| over volumes k, for each sum q
  };
  static bool same(const Seen& one, const Seen& other);
  static bool same_to_all_digits(const Seen& one, const Seen& other);
  /// Number of sums that are not those of the frame before, of the same run.
  static Eigen::Index changed(const Seen& one, const Seen& before);

  std::map<std::int64_t, std::vector<Seen>> by_step_;
  std::map<double, std::int64_t> run_of_places_;  ///< that had them first
  Seen last_;
};

}  // namespace mikromakro
