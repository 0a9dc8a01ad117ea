// SPDX-License-Identifier: GPL-2.0-or-later
#include "statistics/field_trials.h"

#include <cmath>

#include "fields/principal_axes.h"
#include "fields/rotational_stiffness.h"

namespace mikromakro {
namespace {

const PrincipalAxes axes({"fabric_axes", "fabric", "F", "1", false});
const RotationalStiffness stiffness;

}  // namespace

double FieldTrials::deviation_of_mean() const {
  return std::sqrt((1 + rho) / (1 - rho) / (runs * frames));
}

FieldTrials axes_trials(FieldTrials layout, const Eigen::ArrayXd& ratios) {
  const Eigen::ArrayXd deviator = ratios * layout.deviation_of_mean();
  constexpr double mean_trace = 20;
  layout.field = &axes;
  layout.noises = 3;
  layout.input = [=](const Rows& noise) {
    const Eigen::ArrayXd trace = noise.col(0) + mean_trace, along = noise.col(1) + deviator;
    Rows tensor(noise.rows(), 4);
    tensor << (trace + along) / 2, noise.col(2) / 2, noise.col(2) / 2, (trace - along) / 2;
    return tensor;
  };
  const Eigen::ArrayXd zero = Eigen::ArrayXd::Zero(deviator.size());
  layout.truth.resize(deviator.size(), 5);
  layout.truth << zero + mean_trace, deviator, zero, (mean_trace + deviator) / 2, (mean_trace - deviator) / 2;
  return layout;
}

FieldTrials stiffness_trials(FieldTrials layout, double ratio, double noise) {
  const double curvature = ratio * layout.deviation_of_mean();
  layout.field = &stiffness;
  layout.noises = 4;
  layout.input = [=](const Rows& noises) {
    Rows numbers(noises.rows(), 4);
    numbers << curvature + noise * noises.col(0), noise * noises.col(1), curvature + noises.col(2),
        noises.col(3);
    return numbers;
  };
  layout.truth = Rows::Ones(layout.volumes, 1);
  return layout;
}

Coverage coverage_of_column(const FieldTrials& trials, Eigen::Index column, Eigen::Index rows, int count) {
  const std::vector<Column> columns = trials.field->columns({"r", "phi"});
  const std::vector<ColumnsOfField> fields = {{"field", std::ssize(columns), columns}};
  const Solver all = [&](const Rows& sums) {
    Rows solved(sums.rows(), std::ssize(columns));
    trials.field->solve({}, sums, solved);
    return solved;
  };
  Trials made;
  made.runs = trials.runs;
  made.count = count;
  made.run = [&](auto& random) {
    std::vector<Rows> frames =
        CorrelatedNoise(trials.rho, trials.volumes, trials.noises)(trials.frames, random);
    for (Rows& frame : frames) frame = trials.input(frame);
    return frames;
  };
  made.truth = trials.truth.block(0, column, rows, 1);
  made.solve = [&](const Rows& sums) { return Rows(all(sums).block(0, column, rows, 1)); };
  return coverage(made, [&](const TimeAverage& average, const Solver&) {
    return Rows(block_errors(average, all, fields).error.block(0, column, rows, 1));
  });
}

}  // namespace mikromakro
