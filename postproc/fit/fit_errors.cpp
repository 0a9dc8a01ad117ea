// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/fit_errors.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "model/error.h"
#include "statistics/between_runs.h"
#include "statistics/error_decision.h"
#include "statistics/student_t.h"

namespace mikromakro {
namespace {

constexpr double confidence = 0.95;
constexpr double normal_quantile = 1.959963984540054;
constexpr std::int64_t enough_runs = 8;
constexpr double enough_alike = 7;  // 1/sum share^2: effective number of runs of equal length

// One row per block: v0, s, and v in the rings used.
Eigen::ArrayXXd pseudo_values(const ExponentialProfile& fitted, const ColumnWithoutBlocks& blocks,
                              const FitValues& fit) {
  const Eigen::Index count = blocks.values.cols();
  Eigen::ArrayXXd without(count, 2 + static_cast<Eigen::Index>(fitted.used.size()));
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::ArrayXd values = blocks.values.col(i);
    const ExponentialProfile one = fit(values);
    without.row(i) << one.v0, one.s, values(fitted.used).transpose();
  }
  const auto m = static_cast<double>(count);
  return (-(m - 1) * without).rowwise() + (m * without.colwise().mean());
}

Eigen::ArrayXd variances(const Eigen::ArrayXXd& series) {
  return (series.rowwise() - series.colwise().mean()).square().colwise().mean();
}

// v0, s, and the rings that fluctuate beyond rounding. With `zone`, only the rings that determine v0 and s:
// those contributing at least a tenth as much as the ring that contributes most to either.
Eigen::ArrayXXd fluctuating(const Eigen::ArrayXXd& series, const ExponentialProfile& fitted, bool zone) {
  constexpr double least_part = 0.1;
  const Eigen::Index rings = series.cols() - 2;
  const Eigen::ArrayXd variance = variances(series).tail(rings),
                       rounding = 2e-15 * static_cast<double>(series.rows()) *
                                  series.rightCols(rings).colwise().mean().abs().transpose();
  const Eigen::ArrayXXd parts = fitted.change.array().square().rowwise() * variance.transpose();
  const Eigen::Array2d most = parts.rowwise().maxCoeff();
  std::vector<Eigen::Index> chosen = {0, 1};
  for (Eigen::Index i = 0; i < rings; ++i) {
    const bool told = !zone || (parts.col(i) >= least_part * most).any();
    if (told && std::sqrt(variance[i]) > rounding[i]) chosen.push_back(2 + i);
  }
  // All rows; Eigen::all was renamed in version 5.
  return series(Eigen::seqN(Eigen::Index{0}, series.rows()), chosen);
}

double correlation(const Eigen::ArrayXXd& series) {
  const Eigen::ArrayXXd deviation = series.leftCols(2).rowwise() - series.leftCols(2).colwise().mean();
  return (deviation.col(0) * deviation.col(1)).sum() /
         std::sqrt(deviation.col(0).square().sum() * deviation.col(1).square().sum());
}

void widen(const Eigen::Array2d& error, double freedom, FitErrors& errors) {
  errors.freedom = freedom;
  errors.error = student_width(freedom) * error;
  errors.half_width = student_t(confidence, freedom) * error;
}

// Errors from independent runs.
FitErrors errors_of_runs(const RunMeans& runs) {
  FitErrors errors;
  errors.method = "jackknife of runs";
  errors.remark = fmt::format("scatter of {} independent runs", runs.share.size());
  errors.correlation = correlation(runs.mean);
  errors.samples = runs.freedom() + 1;
  widen(runs.variance_of_mean().head(2).sqrt(), runs.freedom(), errors);
  return errors;
}

// Errors of v0 and s.
Eigen::Array2d errors_with(const Eigen::ArrayXXd& series, const Eigen::Array2d& time, double widening) {
  const auto count = static_cast<double>(series.rows());
  return widening * (variances(series.leftCols(2)).array() * time / (count - time)).sqrt();
}

FitErrors errors_of_series(const Eigen::ArrayXXd& series, const ExponentialProfile& fitted,
                           const ColumnWithoutBlocks& blocks) {
  CorrelationTime all = correlation_time(fluctuating(series, fitted, false), blocks.runs);
  // Differences between rings are accounted for by the zone.
  all.unknown_scatter = 0;
  const auto count = static_cast<double>(series.rows());
  const ErrorDecision decision = decide(all, count);
  const double of_zone = correlation_time(fluctuating(series, fitted, true), blocks.runs).time;
  FitErrors errors;
  errors.remark = fmt::format("{} blocks of {} frames", series.rows(), blocks.frames);
  if (std::isnan(all.time) || std::isnan(of_zone)) {
    errors.remark += ", too few to estimate 2 tau";
    return errors;
  }
  const Eigen::Array2d time = all.of_series.head(2).max(of_zone);
  errors.two_tau = blocks.frames * time.maxCoeff();
  errors.two_tau_error = errors.two_tau * all.uncertainty;
  errors.samples = count / time.maxCoeff();
  if (!decision.given || !(time < count).all()) {
    errors.remark += fmt::format(", {:.3g} effective samples of the {:.3g} that are needed", errors.samples,
                                 std::ceil(decision.needed));
    if (blocks.frames > 1) errors.remark += " (shorter blocks may do: average --error-blocks)";
    return errors;
  }
  errors.method = "jackknife of blocks";
  errors.correlation = correlation(series);
  widen(errors_with(series, time, decision.widening / student_width(decision.freedom)), decision.freedom,
        errors);
  return errors;
}

// If runs differ by more than their frames explain, errors come from their spread alone, if there are enough
// runs.
std::optional<FitErrors> errors_of_differing(const Eigen::ArrayXXd& series, const ExponentialProfile& fitted,
                                             const std::vector<std::int64_t>& of_block,
                                             const RunMeans& runs) {
  const BetweenRuns between = between_runs(fluctuating(series, fitted, true), of_block);
  if (!between.differ()) return {};
  FitErrors errors;
  if (decide_by_runs(runs.freedom()).given) errors = errors_of_runs(runs);
  errors.remark = fmt::format("{} runs that differ by more than their frames explain, chi^2 {:.2g}",
                              runs.share.size(), between.chi_square);
  if (errors.error.isNaN().any()) errors.remark += "; four runs of the same length are needed";
  return errors;
}

}  // namespace

FitErrors errors_from_blocks(const ExponentialProfile& fitted, const ColumnWithoutBlocks& blocks,
                             const FitValues& fit) {
  FitErrors none;
  none.remark = "the fit fails when one of the blocks is left out";
  try {
    const Eigen::ArrayXXd series = pseudo_values(fitted, blocks, fit);
    if (!series.isFinite().all()) return none;
    const RunMeans runs = run_means(series, blocks.runs);
    const bool alike = 1 / runs.squares() >= enough_alike;
    if (runs.share.size() >= enough_runs && alike) return errors_of_runs(runs);
    return errors_of_differing(series, fitted, blocks.runs, runs)
        .value_or(errors_of_series(series, fitted, blocks));
  } catch (const Error&) {
    return none;
  }
}

FitErrors errors_from_rings(const ExponentialProfile& fitted, const Eigen::ArrayXd& error_of_ring) {
  FitErrors errors;
  const Eigen::ArrayXd error = error_of_ring(fitted.used);
  if (!error.isFinite().all()) {
    errors.remark = "a ring has no error (more frames, or --blocks)";
    return errors;
  }
  errors.method = "rough, from the rings' errors";
  errors.remark = "as if the errors of all rings added up (--blocks accounts for their correlation)";
  errors.error = (fitted.change.cwiseAbs() * error.matrix()).array();
  errors.half_width = normal_quantile * errors.error;
  return errors;
}

}  // namespace mikromakro
