// SPDX-License-Identifier: GPL-2.0-or-later
// How often standard errors cover the truth, in artificial runs whose truth is known, as Markdown:
//   build/bin/coverage_bench [TRIALS [TITLE]]
// all tables, or those with TITLE in their title; fit: those of fitted profiles; tensors: those of principal
// axes and mu_c. "before" is the rule that
// decided number by number, "now" that of block_errors. Where fewer than one trial in fifty has errors,
// nothing is said of their coverage.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "coverage_scenes.h"
#include "fit_coverage.h"
#include "statistics/error_trials.h"
#include "tensor_coverage.h"

namespace mikromakro::bench {
namespace {

int trials = 500;
std::string wanted;

// Whether the table with this title, which begins, is wanted.
bool head(const std::string& title) {
  if (title.find(wanted) == std::string::npos) return false;
  fmt::print("\n{}\n\n| series | frames | frames/(2 tau) | before: given % | 68 % | 95 % | now: given % | ",
             title);
  fmt::print("68 % | 95 % |\n|---|---|---|---|---|---|---|---|---|\n");
  return true;
}

std::string cells(const Coverage& covered) {
  constexpr double fewest_trials = 0.02;
  const double given = 100 * covered.given;
  if (covered.trials < fewest_trials) return fmt::format("{:.1f} | - | -", given);
  return fmt::format("{:.1f} | {:.1f} | {:.1f}", given, 100 * covered.one_sigma, 100 * covered.two_sided);
}

// Of the rule before, and of that of now.
std::string both(Trials scene, const MakeErrors& before, const MakeErrors& now) {
  scene.count = trials;
  const std::string of_now = cells(coverage(scene, now));
  scene.blocks = 64;
  return cells(coverage(scene, before)) + " | " + of_now;
}

void line(const std::string& name, int frames, double time, const Trials& scene) {
  constexpr double fewest_samples = 3;
  if (frames < fewest_samples * time) return;
  fmt::print("| {} | {} | {:.1f} | {} |\n", name, frames, frames / time,
             both(scene, errors_one_by_one, errors_of_field));
}

double two_tau(double rho) {
  return (1 + rho) / (1 - rho);
}

Trials field_of(Eigen::Index volumes, Eigen::Index columns, double rho, int frames) {
  Trials scene;
  scene.run = [=, noise = CorrelatedNoise(rho, volumes, columns)](auto& random) {
    return noise(frames, random);
  };
  scene.truth = Rows::Zero(volumes, columns);
  return scene;
}

void correlated(Eigen::Index volumes) {
  if (!head(fmt::format("AR(1), a field of {} series", volumes))) return;
  for (const double rho : {0.0, 0.3, 0.5, 0.7, 0.9})
    for (const int frames : {10, 20, 41, 64, 100, 200, 1000})
      line(fmt::format("correlation {:.1f}", rho), frames, two_tau(rho), field_of(volumes, 1, rho, frames));
}

// A part of the variance is AR(1), the rest white.
Trials partly_slow(double slow, double rho, Eigen::Index volumes, int frames) {
  Trials scene;
  scene.truth = Rows::Zero(volumes, 1);
  scene.run = [=](auto& random) {
    std::vector<Rows> series = CorrelatedNoise(rho, volumes, 1)(frames, random);
    const std::vector<Rows> fast = CorrelatedNoise(0, volumes, 1)(frames, random);
    for (std::size_t i = 0; i < series.size(); ++i)
      series[i] = std::sqrt(slow) * series[i] + std::sqrt(1 - slow) * fast[i];
    return series;
  };
  return scene;
}

void two_scales() {
  constexpr Eigen::Index volumes = 20;
  constexpr double rho = 0.9;
  if (!head(fmt::format("Two time scales, a field of {} series", volumes))) return;
  for (const double slow : {0.9, 0.1}) {
    for (const int frames : {41, 64, 100, 200, 1000}) {
      const Trials scene = partly_slow(slow, rho, volumes, frames);
      line(fmt::format("{:.1f} of correlation {}", slow, rho), frames, 1 - slow + slow * two_tau(rho), scene);
    }
  }
}

// The correlation of the slow part lasts as long as the run.
void slow_parts() {
  constexpr Eigen::Index volumes = 20;
  if (!head(fmt::format("Slow parts, a field of {} series (2 tau of the slow part)", volumes))) return;
  for (const double slow : {0.1, 0.3, 0.5}) {
    for (const double rho : {0.95, 0.98, 0.995}) {
      for (const int frames : {41, 100, 200}) {
        const Trials scene = partly_slow(slow, rho, volumes, frames);
        fmt::print("| {:.1f} of correlation {} | {} | {:.1f} | {} |\n", slow, rho, frames,
                   frames / two_tau(rho), both(scene, errors_one_by_one, errors_of_field));
      }
    }
  }
}

// One volume that is AR(1) among nineteen of white noise.
void one_slow() {
  constexpr Eigen::Index volumes = 20;
  if (!head("One slow volume of twenty (of which errors are counted), the others white")) return;
  for (const double rho : {0.8, 0.9, 0.98}) {
    for (const int frames : {20, 40, 80, 200}) {
      Trials scene;
      scene.truth = Rows::Zero(1, 1);
      scene.run = [=](auto& random) {
        std::vector<Rows> series = CorrelatedNoise(0, volumes, 1)(frames, random);
        const std::vector<Rows> slow = CorrelatedNoise(rho, 1, 1)(frames, random);
        for (std::size_t i = 0; i < series.size(); ++i) series[i](0, 0) = slow[i](0, 0);
        return series;
      };
      const auto part = [](const MakeErrors& errors) {
        return [errors](const TimeAverage& average, const Solver&) {
          return Rows(errors(average, [](const Rows& sums) { return sums; }).topRows(1));
        };
      };
      scene.solve = [](const Rows& sums) { return Rows(sums.topRows(1)); };
      fmt::print("| correlation {} | {} | {:.1f} | {} |\n", rho, frames, frames / two_tau(rho),
                 both(scene, part(errors_one_by_one), part(errors_of_field)));
    }
  }
}

// Ten volumes of correlation 0 and ten of 0.7, as a field of one column; then each half alone.
void unlike() {
  constexpr Eigen::Index half = 10;
  if (!head("Volumes that differ: ten of correlation 0, ten of 0.7 (2 tau of the slower ones)")) return;
  for (const int frames : {41, 64, 100, 200, 400, 1000}) {
    for (const bool slow : {false, true}) {
      Trials scene;
      scene.truth = Rows::Zero(half, 1);
      scene.run = [=](auto& random) {
        std::vector<Rows> series = CorrelatedNoise(0, half, 2)(frames, random);
        const std::vector<Rows> other = CorrelatedNoise(0.7, half, 1)(frames, random);
        for (std::size_t i = 0; i < series.size(); ++i) series[i].col(1) = other[i];
        return series;
      };
      // Errors of both together, of which those of one half are counted.
      const auto part = [slow](const MakeErrors& errors) {
        return [slow, errors](const TimeAverage& average, const Solver&) {
          return Rows(errors(average, [](const Rows& sums) { return sums; }).col(slow ? 1 : 0));
        };
      };
      scene.solve = [slow](const Rows& sums) { return Rows(sums.col(slow ? 1 : 0)); };
      fmt::print("| {} | {} | {:.1f} | {} |\n", slow ? "slow ones" : "fast ones", frames,
                 frames / two_tau(0.7), both(scene, part(errors_one_by_one), part(errors_of_field)));
    }
  }
}

// Quotients as E and G are, and angles of principal axes: of sums 10 + x, 20 + y, 4 + z with AR(1) x, y, z.
void solved() {
  constexpr Eigen::Index volumes = 20;
  const Solver quotient = [](const Rows& sums) { return Rows((sums.col(1) + 20) / (sums.col(0) + 10)); };
  const Solver angle = [](const Rows& sums) {
    Rows angles(sums.rows(), 1);
    for (Eigen::Index i = 0; i < sums.rows(); ++i)
      angles(i, 0) = 0.5 * std::atan2(2 * (sums(i, 2) + 4), sums(i, 1) - sums(i, 0) + 10);
    return angles;
  };
  if (!head(fmt::format("Solved columns, {} volumes", volumes))) return;
  for (const auto& [name, solve] : {std::pair("quotient", quotient), std::pair("angle", angle)}) {
    for (const double rho : {0.0, 0.5, 0.9}) {
      for (const int frames : {20, 41, 100, 1000}) {
        Trials scene = field_of(volumes, 3, rho, frames);
        scene.solve = solve;
        scene.truth = solve(Rows::Zero(volumes, 3));
        line(fmt::format("{}, correlation {:.1f}", name, rho), frames, two_tau(rho), scene);
      }
    }
  }
}

// The variance of a number about its measured mean, as of one disc in each volume: sums x and x^2.
void covariances() {
  constexpr Eigen::Index volumes = 20;
  if (!head(fmt::format("Variance about the measured mean, {} volumes (2 tau of the mean)", volumes))) return;
  for (const double rho : {0.0, 0.5, 0.9}) {
    for (const int frames : {41, 100, 400, 1000}) {
      Trials scene;
      scene.truth = Rows::Ones(volumes, 1);
      scene.run = [=](auto& random) {
        std::vector<Rows> series = CorrelatedNoise(rho, volumes, 1)(frames, random);
        for (Rows& frame : series) frame = (Rows(volumes, 2) << frame, frame.square()).finished();
        return series;
      };
      scene.solve = [](const Rows& sums) { return Rows(sums.col(1) - sums.col(0).square()); };
      line(fmt::format("correlation {:.1f}", rho), frames, two_tau(rho), scene);
    }
  }
}

void other_noise() {
  if (!head("Noise of other kinds")) return;
  for (const Scene& scene : scenes_of_other_noise()) {
    for (const int frames : {20, 41, 100, 400}) {
      Trials one;
      one.run = scene.run(frames);
      one.truth = Rows::Zero(scene.series, 1);
      line(scene.name, frames, scene.time, one);
    }
  }
}

// White noise of standard deviation 1 and an offset of each run, as of packings: of all volumes, or of each
// of them. frames/(2 tau) of the frames alone.
void runs_that_differ() {
  constexpr Eigen::Index volumes = 20;
  if (!head(fmt::format("Runs that differ, a field of {} series (frames of all runs)", volumes))) return;
  struct Of {
    std::vector<int> lengths;
    double offset;
    bool shared;
  };
  const std::vector<int> one_long = {200, 20, 20, 20, 20, 20, 20, 20};
  for (const Of& of :
       {Of{{100, 100}, 0.2, true}, Of{{100, 100}, 0.5, true}, Of{{100, 100}, 0.5, false},
        Of{{100, 100, 100}, 0.2, true}, Of{{100, 100, 100}, 0.5, true}, Of{{100, 100, 100}, 0.5, false},
        Of{{100, 100, 100, 100}, 0.2, true}, Of{{100, 100, 100, 100}, 0.5, true},
        Of{{100, 100, 100, 100}, 0.5, false}, Of{std::vector<int>(8, 50), 0.5, true},
        Of{std::vector<int>(8, 50), 0.5, false}, Of{std::vector<int>(8, 100), 3, true}, Of{one_long, 0, true},
        Of{one_long, 0.5, true}, Of{one_long, 0.5, false}}) {
    Trials scene;
    scene.truth = Rows::Zero(volumes, 1);
    scene.lengths = of.lengths;
    scene.run_of = [=](int frames, auto& random) {
      std::normal_distribution<double> normal(0, of.offset);
      const double shared = normal(random);
      const Rows off = Rows::NullaryExpr(volumes, 1, [&] { return of.shared ? shared : normal(random); });
      std::vector<Rows> series = CorrelatedNoise(0, volumes, 1)(frames, random);
      for (Rows& frame : series) frame += off;
      return series;
    };
    int frames = 0;
    for (const int length : of.lengths) frames += length;
    line(fmt::format("{} runs of {}{}, offsets {} {}", of.lengths.size(), of.lengths.front(),
                     of.lengths.front() == of.lengths.back() ? "" : fmt::format(" to {}", of.lengths.back()),
                     of.offset, of.shared ? "of all volumes" : "of each"),
         frames, 1, scene);
  }
}

void several_runs() {
  constexpr Eigen::Index volumes = 20;
  if (!head(
          fmt::format("Runs that are averaged together, a field of {} series (frames of all runs)", volumes)))
    return;
  for (const double rho : {0.0, 0.5, 0.7, 0.9}) {
    for (const int runs : {2, 4, 8}) {
      for (const int frames : {10, 41, 100}) {
        Trials scene = field_of(volumes, 1, rho, frames);
        scene.runs = runs;
        line(fmt::format("correlation {:.1f}, {} runs", rho, runs), runs * frames, two_tau(rho), scene);
      }
    }
  }
}

}  // namespace
}  // namespace mikromakro::bench

int main(int argc, char** argv) {
  using namespace mikromakro::bench;
  if (argc > 1) trials = std::max(1, std::atoi(argv[1]));
  if (argc > 2) wanted = argv[2];
  if (wanted.empty() || wanted == "fit") print_fit_coverage(trials);
  if (wanted == "fit") return 0;
  if (wanted.empty() || wanted == "tensors") print_tensor_coverage(trials);
  if (wanted == "tensors") return 0;
  for (const Eigen::Index volumes : {20, 4, 1}) correlated(volumes);
  two_scales();
  slow_parts();
  one_slow();
  unlike();
  solved();
  covariances();
  several_runs();
  runs_that_differ();
  other_noise();
}
