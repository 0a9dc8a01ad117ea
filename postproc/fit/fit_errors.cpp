#include "fit/fit_errors.h"

#include <fmt/format.h>

#include <cmath>

#include "averaging/block_errors.h"
#include "fit/student_t.h"
#include "io/error.h"

namespace mikromakro {
namespace {

constexpr double confidence = 0.95;
constexpr double normal_quantile = 1.959963984540054;
constexpr std::int64_t enough_runs = 8;

// A row for each block: v0, s, and v in the rings that are used.
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

// v0, s, and the rings of which they are told: those that do a tenth or more of what the ring does that does
// most to one of them.
Eigen::ArrayXXd series_of_zone(const Eigen::ArrayXXd& series, const ExponentialProfile& fitted) {
  constexpr double least_part = 0.1;
  const Eigen::Index rings = series.cols() - 2;
  const Eigen::ArrayXXd deviation = series.rowwise() - series.colwise().mean();
  const Eigen::ArrayXd variance = deviation.rightCols(rings).square().colwise().mean();
  const Eigen::ArrayXXd parts = fitted.change.array().square().rowwise() * variance.transpose();
  const Eigen::Array2d most = parts.rowwise().maxCoeff();
  std::vector<Eigen::Index> chosen = {0, 1};
  for (Eigen::Index i = 0; i < rings; ++i)
    if ((parts.col(i) >= least_part * most).any()) chosen.push_back(2 + i);
  return series(Eigen::all, chosen);
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

// Of independent runs with `frames` of all frames each; rows of `series` are their values.
FitErrors errors_of_runs(const Eigen::ArrayXXd& series, const Eigen::ArrayXd& share) {
  const auto runs = static_cast<double>(series.rows());
  FitErrors errors;
  errors.method = "jackknife of runs";
  errors.remark = fmt::format("scatter of {} independent runs", series.rows());
  errors.correlation = correlation(series);
  Eigen::Array2d variance;
  for (Eigen::Index i = 0; i < 2; ++i) {
    const double mean = (share * series.col(i)).sum();
    variance[i] = (share * (series.col(i) - mean)).square().sum() * runs / (runs - 1);
  }
  errors.samples = 1 / share.square().sum();
  widen(variance.sqrt(), runs - 1, errors);
  return errors;
}

// Each block is a frame of an average that keeps all of them, of one volume.
BlockErrors errors_of_field(const Eigen::ArrayXXd& series, const std::vector<std::int64_t>& runs) {
  TimeAverage average(static_cast<std::size_t>(series.rows()));
  for (Eigen::Index i = 0; i < series.rows(); ++i)
    average.add(series.row(i), runs[static_cast<std::size_t>(i)]);
  return block_errors(average, [](const Rows& values) { return values; }, {{"fit", series.cols()}});
}

std::string too_few(const ErrorDecision& decision) {
  if (decision.samples < decision.needed)
    return fmt::format(", {:.3g} effective samples of the {:.3g} that are needed", decision.samples,
                       std::ceil(decision.needed));
  return ", v0 and s change too slowly for the run to know how much";
}

// Of v0 and of s; the errors are not finite where 2 tau is as long as the run, or not to be told.
struct Slowest {
  Eigen::Array2d time, error;
};

Slowest slower_of(const BlockErrors& all, double of_zone, double count) {
  const Eigen::Array2d own = all.correlation_time.leftCols(2).transpose();
  const Eigen::Array2d time = own.max(std::isnan(of_zone) ? count : of_zone);
  const Eigen::Array2d longer = time / (count - time) * (count - own) / own;
  return {time, all.error.leftCols(2).transpose() * longer.sqrt()};
}

FitErrors errors_of_series(const Eigen::ArrayXXd& series, const Eigen::ArrayXXd& zone,
                           const ColumnWithoutBlocks& blocks) {
  const BlockErrors all = errors_of_field(series, blocks.runs);
  const CorrelationTime& time = all.fields.front().correlation;
  const ErrorDecision& decision = all.fields.front().decision;
  const auto count = static_cast<double>(series.rows());
  FitErrors errors;
  errors.remark = fmt::format("{} blocks of {} frames", series.rows(), blocks.frames);
  if (all.fields.front().series == 0 || std::isnan(time.time)) {
    errors.remark += ", too few to tell 2 tau";
    return errors;
  }
  const double of_zone = errors_of_field(zone, blocks.runs).fields.front().correlation.time;
  const Slowest slower = slower_of(all, of_zone, count);
  const bool given = slower.error.isFinite().all();
  const double slowest = given ? slower.time.maxCoeff() : time.time;
  errors.two_tau = blocks.frames * slowest;
  errors.two_tau_error = errors.two_tau * time.uncertainty;
  errors.samples = count / slowest;
  if (!given) errors.remark += too_few(decision);
  if (!given) return errors;
  errors.method = "jackknife of blocks";
  errors.correlation = correlation(series);
  widen(slower.error / student_width(decision.freedom), decision.freedom, errors);
  return errors;
}

struct Runs {
  Eigen::ArrayXXd mean;  // a row for each run
  Eigen::ArrayXd share;  // of all blocks
};

Runs by_run(const Eigen::ArrayXXd& series, const std::vector<std::int64_t>& runs) {
  std::vector<Eigen::Index> begins;
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (i == 0 || runs[i] != runs[i - 1]) begins.push_back(static_cast<Eigen::Index>(i));
  const auto count = static_cast<Eigen::Index>(begins.size());
  begins.push_back(series.rows());
  Runs result{Eigen::ArrayXXd(count, series.cols()), Eigen::ArrayXd(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto run = static_cast<std::size_t>(i);
    const Eigen::Index length = begins[run + 1] - begins[run];
    result.mean.row(i) = series.middleRows(begins[run], length).colwise().mean();
    result.share[i] = static_cast<double>(length) / static_cast<double>(series.rows());
  }
  return result;
}

}  // namespace

FitErrors errors_from_blocks(const ExponentialProfile& fitted, const ColumnWithoutBlocks& blocks,
                             const FitValues& fit) {
  FitErrors none;
  none.remark = "there is no such profile without one of the blocks";
  try {
    const Eigen::ArrayXXd series = pseudo_values(fitted, blocks, fit);
    if (!series.isFinite().all()) return none;
    const Runs runs = by_run(series, blocks.runs);
    return runs.share.size() >= enough_runs
               ? errors_of_runs(runs.mean, runs.share)
               : errors_of_series(series, series_of_zone(series, fitted), blocks);
  } catch (const Error&) {
    return none;
  }
}

FitErrors errors_from_rings(const ExponentialProfile& fitted, const Eigen::ArrayXd& error_of_ring) {
  FitErrors errors;
  const Eigen::ArrayXd error = error_of_ring(fitted.used);
  if (!error.isFinite().all()) {
    errors.remark = "a ring has no error";
    return errors;
  }
  errors.method = "upper bound from the rings' errors";
  errors.remark = "however rings fluctuate together";
  errors.error = (fitted.change.cwiseAbs() * error.matrix()).array();
  errors.half_width = normal_quantile * errors.error;
  return errors;
}

}  // namespace mikromakro
