// SPDX-License-Identifier: GPL-2.0-or-later
// Artificial runs of known mean 0 and known 2 tau, of other noise than AR(1) of normal steps.
#pragma once

#include <string>
#include <vector>

#include "statistics/error_trials.h"

namespace mikromakro::bench {

struct Scene {
  std::string name;
  double time = 1;  ///< 2 tau in frames, of the slowest series
  std::function<MakeRun(int frames)> run;
  Eigen::Index series = 20;
};

/// Squares of AR(1) series (less 1) and means of two of them, which are exponential; steps of Student's t
/// with four degrees of freedom; moving averages; AR(2) that oscillates; series of unlike variance; series
/// whose neighbours fluctuate together; few and many series.
std::vector<Scene> scenes_of_other_noise();

}  // namespace mikromakro::bench
