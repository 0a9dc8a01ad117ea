// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/pseudo_values.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace mikromakro {
namespace {

constexpr unsigned groups = 8;  // of successive blocks

// Wraps deviations of angles to at most half a period.
void take_around(const std::vector<ColumnsOfField>& fields, Rows& deviations) {
  Eigen::Index begin = 0;
  for (const ColumnsOfField& field : fields) {
    for (std::size_t i = 0; i < field.columns.size(); ++i) {
      const double period = field.columns[i].period;
      if (period == 0) continue;
      auto column = deviations.col(begin + static_cast<Eigen::Index>(i));
      column = column.unaryExpr([period](double apart) { return std::remainder(apart, period); }).eval();
    }
    begin += field.count;
  }
}

// A block without a disc leaves a quotient unchanged: its deviation is 0. If this holds for most blocks, the
// others must come from several visits, since a single visit does not show how the next would differ.
bool is_told(const std::vector<Rows>& deviations, Eigen::Index place, double least) {
  constexpr double most = 0.5;
  constexpr int fewest_visits = 8;
  int occupied = 0, visits = 0;
  bool before = false;
  for (const Rows& deviation : deviations) {
    const bool now = std::abs(deviation.data()[place]) > least;
    occupied += now ? 1 : 0;
    visits += now && !before ? 1 : 0;
    before = now;
  }
  return occupied > most * static_cast<double>(deviations.size()) || visits >= fewest_visits;
}

// `smallest`: the smallest deviation of each series.
void leave_seldom_ones(const Rows& smallest, PseudoValues& values) {
  constexpr double nothing = 1e-9;
  for (Eigen::Index place = 0; place < smallest.size(); ++place) {
    const double least = nothing * std::sqrt(values.variance.data()[place]);
    bool& fluctuates = values.fluctuate.data()[place];
    if (fluctuates && smallest.data()[place] <= least) fluctuates = is_told(values.deviations, place, least);
  }
}

struct Groups {
  std::array<Rows, groups> sums;
  std::array<double, groups> counts = {};
};

Groups grouped(const std::vector<Rows>& blocks) {
  Groups grouped;
  grouped.sums.fill(Rows::Zero(blocks.front().rows(), blocks.front().cols()));
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const std::size_t group = i * groups / blocks.size();
    grouped.sums[group] += blocks[i];
    ++grouped.counts[group];
  }
  return grouped;
}

// The mean of the groups where this Walsh function is +1 (`half` 0) or -1, and their share of all blocks.
std::pair<Rows, double> half_of(const Groups& of, unsigned wave, int half) {
  Rows sum = Rows::Zero(of.sums[0].rows(), of.sums[0].cols());
  double count = 0, all = 0;
  for (unsigned group = 0; group < groups; ++group) {
    all += of.counts[group];
    if (std::popcount(wave & group) % 2 != half) continue;
    sum += of.sums[group];
    count += of.counts[group];
  }
  sum /= count;
  return {std::move(sum), count / all};
}

// Root mean square of (q(a) + q(b))/2 - q over the halves a and b of each Walsh function.
Rows curvature(const Groups& of, const Rows& whole, const Solver& solve,
               const std::vector<ColumnsOfField>& fields) {
  Rows squares = Rows::Zero(whole.rows(), whole.cols()), known = squares;
  for (unsigned wave = 1; wave < groups; ++wave) {
    Rows bend = Rows::Zero(whole.rows(), whole.cols());
    for (const int half : {0, 1}) {
      const auto [mean, share] = half_of(of, wave, half);
      Rows deviations = solve(mean) - whole;
      take_around(fields, deviations);
      bend += share * deviations;
    }
    squares += bend.isFinite().select(bend.square(), 0);
    known += bend.isFinite().cast<double>();
  }
  return (squares / known).sqrt();
}

}  // namespace

PseudoValues pseudo_values(const std::vector<Rows>& blocks, const Solver& solve,
                           const std::vector<ColumnsOfField>& fields) {
  const auto count = static_cast<double>(blocks.size());
  const Groups of = grouped(blocks);
  Rows total = of.sums.front();
  for (std::size_t i = 1; i < groups; ++i) total += of.sums[i];
  const Rows whole = solve(total / count);
  PseudoValues values;
  values.deviations.reserve(blocks.size());
  Rows mean = Rows::Zero(whole.rows(), whole.cols()), squares = mean;
  Rows smallest = Rows::Constant(whole.rows(), whole.cols(), std::numeric_limits<double>::infinity());
  for (const Rows& block : blocks) {
    values.deviations.emplace_back(whole - solve((total - block) / (count - 1)));
    take_around(fields, values.deviations.back());
    // In a single pass, since grids have a million of them.
    double* const deviation = values.deviations.back().data();
    for (Eigen::Index i = 0; i < whole.size(); ++i) {
      const double one = deviation[i] *= count - 1;
      mean.data()[i] += one;
      squares.data()[i] += one * one;
      smallest.data()[i] = std::min(smallest.data()[i], std::abs(one));
    }
  }
  mean /= count;
  squares /= count;
  values.variance = squares - mean.square();
  const double rounding = 2e-15 * count;
  // False for nan as well.
  values.fluctuate = values.variance.sqrt() > rounding * (whole + mean).abs();
  values.curvature = curvature(of, whole, solve, fields);
  leave_seldom_ones(smallest, values);
  return values;
}

}  // namespace mikromakro
