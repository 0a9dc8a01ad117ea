// SPDX-License-Identifier: GPL-2.0-or-later
// How often the standard errors of many artificial runs cover the truth: for tests and tests/bench.
#pragma once

#include <functional>
#include <random>
#include <vector>

#include "averaging/block_errors.h"

namespace mikromakro {

/// Frames of one run, in time order: volumes x sums each.
using MakeRun = std::function<std::vector<Rows>(std::mt19937_64&)>;

struct Trials {
  MakeRun run;
  int runs = 1;  ///< that are averaged together
  /// Instead of `run` and `runs`: runs of these numbers of frames.
  std::vector<int> lengths;
  std::function<std::vector<Rows>(int frames, std::mt19937_64&)> run_of;
  Solver solve;  ///< empty: the sums themselves
  Rows truth;    ///< of what is solved
  int count = 500;
  std::size_t blocks = 0;  ///< 0: as many as the program keeps
};

/// Of all numbers in all trials, and of those that had an error.
struct Coverage {
  double given = 0;
  double trials = 0;     ///< in which at least one had an error
  double one_sigma = 0;  ///< within one standard error: 0.683
  double two_sided = 0;  ///< within 1.96 of them: 0.95
};

using MakeErrors = std::function<Rows(const TimeAverage&, const Solver&)>;

Coverage coverage(const Trials& trials, const MakeErrors& errors);

/// block_errors, all columns as one field.
Rows errors_of_field(const TimeAverage& average, const Solver& solve);

/// What block_errors was before, with 64 blocks: each number decides by its own correlation, which must leave
/// 16 independent blocks, whether it has an error.
Rows errors_one_by_one(const TimeAverage& average, const Solver& solve);

/// x_(i+1) = rho x_i + noise, of mean 0 and variance 1: 2 tau = (1 + rho)/(1 - rho).
class CorrelatedNoise {
 public:
  CorrelatedNoise(double rho, Eigen::Index rows, Eigen::Index columns)
      : rho_(rho), rows_(rows), columns_(columns) {}
  /// `frames` frames, independent of what was made before.
  std::vector<Rows> operator()(int frames, std::mt19937_64& random) const;

 private:
  double rho_;
  Eigen::Index rows_, columns_;
};

}  // namespace mikromakro
