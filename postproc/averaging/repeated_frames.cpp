// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/repeated_frames.h"

#include <algorithm>
#include <cmath>

namespace mikromakro {

bool RepeatedFrames::same(const Seen& one, const Seen& other) {
  constexpr double digits = 1e-4;
  constexpr Eigen::Index fewest = 4;  // solid fractions alone agree between all runs of the same discs
  const auto differs = (one.sums - other.sums).abs() > digits * one.sizes.max(other.sizes);
  return (one.sizes > 0).count() >= fewest && (one.sums.isNaN() == other.sums.isNaN()).all() &&
         !differs.any();
}

Eigen::Index RepeatedFrames::changed(const Seen& one, const Seen& before) {
  constexpr double clearly = 1e-4;
  if (before.run != one.run || before.sums.size() == 0) return 0;
  return ((one.sums - before.sums).abs() > clearly * one.sizes && one.sums != one.sums.round()).count();
}

bool RepeatedFrames::same_to_all_digits(const Seen& one, const Seen& other) {
  constexpr double digits = 1e-12;
  return (one.sums.isNaN() == other.sums.isNaN()).all() &&
         !((one.sums - other.sums).abs() > digits * one.sizes.max(other.sizes)).any();
}

bool RepeatedFrames::add(const FrameSums& frame) {
  const Eigen::ArrayXd place =
      Eigen::ArrayXd::LinSpaced(frame.sums.rows(), 1, static_cast<double>(frame.sums.rows()));
  Seen seen{frame.run, frame.places, (frame.sums.colwise() * place).colwise().sum().transpose(),
            (frame.sums.abs().colwise() * place).colwise().sum().transpose()};
  const bool moves = last_.sums.size() == 0 || last_.run != seen.run || !same(last_, seen);
  std::vector<Seen>& at_this_step = by_step_[frame.step];
  constexpr Eigen::Index fewest = 2;
  const Eigen::Index changes = changed(seen, last_);
  bool again = moves && std::any_of(at_this_step.begin(), at_this_step.end(), [&](const Seen& earlier) {
                 return earlier.run != seen.run &&
                        (same(earlier, seen) || (changes >= fewest && same_to_all_digits(seen, earlier)));
               });
  if (last_.run == seen.run && last_.places != seen.places && !std::isnan(seen.places)) {
    const auto [first, is_new] = run_of_places_.try_emplace(seen.places, seen.run);
    again = again || (!is_new && first->second != seen.run);
  }
  last_ = seen;
  at_this_step.push_back(std::move(seen));
  return again;
}

}  // namespace mikromakro
