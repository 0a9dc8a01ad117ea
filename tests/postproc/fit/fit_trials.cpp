// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/fit_trials.h"

#include <cmath>

#include "averaging/block_errors.h"
#include "statistics/student_t.h"

namespace mikromakro {
namespace {

constexpr double r_i = 0.1032, r_o = 0.2524, v0 = 0.0074, s = 0.0127;

class RingNoise {
 public:
  RingNoise(int rings, double along) : rings_(rings), along_(along) {}

  Eigen::ArrayXd operator()(std::mt19937_64& random) {
    Eigen::ArrayXd values = Eigen::ArrayXd::NullaryExpr(rings_, [&] { return normal_(random); });
    for (Eigen::Index i = 1; i < rings_; ++i)
      values[i] = along_ * values[i - 1] + std::sqrt(1 - along_ * along_) * values[i];
    return values;
  }

 private:
  Eigen::Index rings_;
  double along_;
  std::normal_distribution<double> normal_;
};

TimeAverage average_of(const ProfileTrials& trials, const Eigen::ArrayXd& r, std::mt19937_64& random) {
  const double along = trials.length > 0 ? std::exp(-(r[1] - r[0]) / trials.length) : 0;
  RingNoise noise(trials.rings, along);
  const Eigen::ArrayXd profile = v0 * (-(r - r_i) / s).exp(), ground = 0 * r + trials.ground * v0;
  const double behind = trials.rho_behind < 0 ? trials.rho : trials.rho_behind;
  const Eigen::ArrayXd rho = (r < r_i + 0.015).select(0 * r + trials.rho, behind),
                       fresh = (1 - rho.square()).sqrt();
  TimeAverage average;
  for (int run = 0; run < trials.runs; ++run) {
    const Eigen::ArrayXd stays = 1 + trials.packing * trials.noise * noise(random);
    Eigen::ArrayXd x = noise(random), other = noise(random);
    for (int frame = 0; frame < trials.frames; ++frame) {
      average.add(profile * (stays + trials.noise * x) + ground * other, run);
      x = rho * x + fresh * noise(random);
      other = rho * other + fresh * noise(random);
    }
  }
  return average;
}

ColumnWithoutBlocks without_blocks(const TimeAverage& average) {
  const auto count = static_cast<Eigen::Index>(average.blocks().size());
  ColumnWithoutBlocks without{Eigen::ArrayXXd(average.mean().rows(), count), average.runs(),
                              static_cast<double>(average.block_length())};
  for (Eigen::Index i = 0; i < count; ++i)
    without.values.col(i) = average.blocks()[static_cast<std::size_t>(i)];
  const Eigen::ArrayXd total = without.values.rowwise().sum();
  without.values = (-without.values).colwise() + total;
  without.values /= static_cast<double>(count - 1);
  return without;
}

FitTrial trial_of(const ProfileTrials& trials, std::mt19937_64& random) {
  const double half = 0.5 * (r_o - r_i) / trials.rings;
  const Eigen::ArrayXd r = Eigen::ArrayXd::LinSpaced(trials.rings, r_i + half, r_o - half);
  TimeAverage average = average_of(trials, r, random);
  const FitValues fit = [r](const Eigen::ArrayXd& v) { return fit_exponential({r, v, {}}, r_i); };
  return {fit(average.mean().col(0)), without_blocks(average), std::move(average), fit};
}

}  // namespace

FitErrors fit_errors_of_blocks(const FitTrial& trial) {
  return errors_from_blocks(trial.fitted, trial.blocks, trial.fit);
}

FitErrors fit_errors_of_rings(const FitTrial& trial) {
  const BlockErrors errors =
      block_errors(trial.average, [](const Rows& sums) { return sums; }, {{"velocity", 1}});
  return errors_from_rings(trial.fitted, errors.error.col(0));
}

FitErrors fit_errors_of_scatter(const FitTrial& trial) {
  const ExponentialProfile& fitted = trial.fitted;
  const auto n = static_cast<double>(fitted.used.size());
  const double variance = fitted.residual_rms * fitted.residual_rms * n / (n - 2);
  FitErrors errors;
  errors.error = (variance * fitted.change.array().square().rowwise().sum()).sqrt();
  errors.half_width = student_t(0.95, n - 2) * errors.error;
  return errors;
}

FitCoverage coverage(const ProfileTrials& trials, const MakeFitErrors& errors) {
  // Scenes that are alike are to be others.
  std::seed_seq seeds{23,
                      trials.rings,
                      static_cast<int>(1e6 * trials.length),
                      static_cast<int>(100 * trials.rho),
                      trials.frames,
                      trials.runs,
                      static_cast<int>(100 * trials.packing)};
  std::mt19937_64 random(seeds);
  FitCoverage covered{0, {0, 0}, {0, 0}, {0, 0}};
  Eigen::Array2d square_error = {0, 0}, square_distance = {0, 0};
  for (int i = 0; i < trials.count; ++i) {
    const FitTrial trial = trial_of(trials, random);
    const Eigen::Array2d distance = {std::abs(trial.fitted.v0 - v0), std::abs(trial.fitted.s - s)};
    square_distance += distance.square();
    const FitErrors made = errors(trial);
    if (!made.error.isFinite().all()) continue;
    ++covered.given;
    square_error += made.error.square();
    covered.one_sigma += (distance < made.error).cast<double>();
    covered.two_sided += (distance < made.half_width).cast<double>();
  }
  covered.one_sigma /= covered.given;
  covered.two_sided /= covered.given;
  covered.width = (square_error / covered.given / (square_distance / trials.count)).sqrt();
  covered.given /= trials.count;
  return covered;
}

}  // namespace mikromakro
