// SPDX-License-Identifier: GPL-2.0-or-later
// How often the intervals of fitted profiles hold the truth, in artificial runs: for tests and tests/bench.
#pragma once

#include <random>
#include <string>

#include "fit/fit_errors.h"

namespace mikromakro {

/// Frames of v = v0 exp(-(r - R_i)/s) (1 + `noise` x) + `ground` v0 x' over the rings of the shear cell, x
/// and x' of variance 1, AR(1) in time, exp(-dr/length) from ring to ring.
struct ProfileTrials {
  int rings = 60;
  double length = 0;       ///< m
  double rho = 0;          ///< from frame to frame
  double rho_behind = -1;  ///< the same from 15 mm behind R_i on; below 0: as before it
  int frames = 100, runs = 1;
  double noise = 0.25, ground = 0;
  double packing = 0;  ///< noise that stays the same in all frames of a run, over `noise`
  int count = 500;
};

/// Of v0 and s; of all trials, and of those with an interval.
struct FitCoverage {
  double given = 0;
  Eigen::Array2d one_sigma, two_sided;  ///< within the standard error, within the interval of 95 %
  Eigen::Array2d width;                 ///< standard errors over the scatter of v0 and s, root mean square
};

struct FitTrial {
  ExponentialProfile fitted;
  ColumnWithoutBlocks blocks;
  TimeAverage average;
  FitValues fit;
};

using MakeFitErrors = std::function<FitErrors(const FitTrial&)>;

FitCoverage coverage(const ProfileTrials& trials, const MakeFitErrors& errors);

/// What the program gives with --blocks, and with a table that has errors.
FitErrors fit_errors_of_blocks(const FitTrial& trial);
FitErrors fit_errors_of_rings(const FitTrial& trial);
/// What it was before: from the scatter about the line, rings taken as independent and alike.
FitErrors fit_errors_of_scatter(const FitTrial& trial);

}  // namespace mikromakro
