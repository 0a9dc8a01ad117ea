// SPDX-License-Identifier: GPL-2.0-or-later
// How often the errors of one column of a field cover the truth: tensors of known deviator, mu_c of known
// curvature, in noise.
#pragma once

#include "fields/field.h"
#include "statistics/error_trials.h"

namespace mikromakro {

struct FieldTrials {
  Eigen::Index volumes = 20;
  int runs = 1, frames = 64;  ///< runs that are averaged together, frames of each
  double rho = 0;             ///< correlation from frame to frame
  const Field* field = nullptr;
  Eigen::Index noises = 0;                      ///< number of noises, of variance 1, in each volume
  std::function<Rows(const Rows&)> input = {};  ///< numbers for Field::solve() from them
  Rows truth = {};                              ///< volumes x columns

  /// Standard deviation of the mean of a noise.
  double deviation_of_mean() const;
};

/// Principal axes of tensors of trace 20 with the axes e_r and e_phi. The noise is that of the trace and of
/// both components of the deviator, which is `ratios` (one for each volume) times the deviation of their
/// means. The direction of an isotropic tensor counts as 0.
FieldTrials axes_trials(FieldTrials layout, const Eigen::ArrayXd& ratios);

/// mu_c = 1 with noise in the curvature, which is `ratio` times the deviation of the mean of its components,
/// and `noise` times as much in the couple stress.
FieldTrials stiffness_trials(FieldTrials layout, double ratio, double noise);

/// Of `column` in the first `rows` volumes; the errors are made of all together.
Coverage coverage_of_column(const FieldTrials& trials, Eigen::Index column, Eigen::Index rows, int count);

}  // namespace mikromakro
