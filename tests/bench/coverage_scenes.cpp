// SPDX-License-Identifier: GPL-2.0-or-later
#include "coverage_scenes.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace mikromakro::bench {
namespace {

// Makes a frame of noise without correlation in time.
using Steps = std::function<Eigen::ArrayXd(std::mt19937_64&)>;

Steps normal_steps(Eigen::Index series) {
  return [series](auto& random) {
    std::normal_distribution<double> normal;
    return Eigen::ArrayXd(Eigen::ArrayXd::NullaryExpr(series, [&] { return normal(random); }));
  };
}

// Of variance 1.
Steps heavy_steps(Eigen::Index series) {
  constexpr double freedom = 4;
  return [series](auto& random) {
    std::student_t_distribution<double> student(freedom);
    const double scale = std::sqrt((freedom - 2) / freedom);
    return Eigen::ArrayXd(Eigen::ArrayXd::NullaryExpr(series, [&] { return scale * student(random); }));
  };
}

// Normal, of variance 1, neighbours of the given correlation.
Steps steps_together(Eigen::Index series, double correlation) {
  return [steps = normal_steps(series), correlation](auto& random) {
    Eigen::ArrayXd noise = steps(random);
    const double rest = std::sqrt(1 - correlation * correlation);
    for (Eigen::Index i = 1; i < noise.size(); ++i) noise[i] = correlation * noise[i - 1] + rest * noise[i];
    return noise;
  };
}

// x_i = a x_(i-1) + b x_(i-2) + step, of which the first hundred are left out.
std::function<MakeRun(int)> autoregressive(double a, double b, const Steps& steps) {
  constexpr int before = 100;
  return [=](int frames) {
    return [=](auto& random) {
      std::vector<Rows> run;
      Eigen::ArrayXd last = steps(random), older = last;
      for (int i = 0; i < before + frames; ++i) {
        const Eigen::ArrayXd next = a * last + b * older + steps(random);
        older = std::exchange(last, next);
        if (i >= before) run.emplace_back(last);
      }
      return run;
    };
  };
}

// Means of `length` steps.
std::function<MakeRun(int)> moving_average(int length, const Steps& steps) {
  return [=](int frames) {
    return [=](auto& random) {
      std::vector<Eigen::ArrayXd> noise(static_cast<std::size_t>(frames + length));
      for (Eigen::ArrayXd& one : noise) one = steps(random);
      std::vector<Rows> run;
      for (std::size_t i = 0; i < static_cast<std::size_t>(frames); ++i) {
        run.emplace_back(noise[i]);
        for (std::size_t k = 1; k < static_cast<std::size_t>(length); ++k) run.back() += noise[i + k];
      }
      return run;
    };
  };
}

// Mean of the squares of `count` AR(1) series of variance 1, less 1.
std::function<MakeRun(int)> squares(int count, double rho, Eigen::Index series) {
  return [=](int frames) {
    return [=, noise = CorrelatedNoise(rho, series, count)](auto& random) {
      std::vector<Rows> run;
      for (const Rows& frame : noise(frames, random)) run.emplace_back(frame.square().rowwise().mean() - 1);
      return run;
    };
  };
}

std::function<MakeRun(int)> scaled(const std::function<MakeRun(int)>& run, double ratio) {
  return [=](int frames) {
    return [=, noise = run(frames)](auto& random) {
      std::vector<Rows> scaled = noise(random);
      for (Rows& frame : scaled)
        frame.colwise() *= Eigen::ArrayXd::LinSpaced(frame.rows(), 0, std::log(ratio)).exp();
      return scaled;
    };
  };
}

double two_tau(double rho) {
  return (1 + rho) / (1 - rho);
}

Scene oscillation(double decay, double period) {
  constexpr Eigen::Index series = 20;
  const double a = 2 * decay * std::cos(2 * std::numbers::pi / period), b = -decay * decay;
  const double variance = (1 - b) / ((1 + b) * (std::pow(1 - b, 2) - a * a));
  return {fmt::format("oscillation, {} per frame, period {}", decay, period),
          1 / std::pow(1 - a - b, 2) / variance, autoregressive(a, b, normal_steps(series)), series};
}

}  // namespace

std::vector<Scene> scenes_of_other_noise() {
  constexpr Eigen::Index series = 20;
  std::vector<Scene> scenes;
  for (const double rho : {0.0, 0.5}) {
    const std::string power = fmt::format("{}^k", rho);
    const double slow = std::sqrt(rho);
    scenes.push_back({"squares of normal noise, " + power, two_tau(rho), squares(1, slow, series), series});
    scenes.push_back({"exponential, " + power, two_tau(rho), squares(2, slow, series), series});
    scenes.push_back(
        {"t of 4 degrees, " + power, two_tau(rho), autoregressive(rho, 0, heavy_steps(series)), series});
  }
  for (const int length : {2, 4, 8})
    scenes.push_back({fmt::format("means of {} steps", length), 1.0 * length,
                      moving_average(length, normal_steps(series)), series});
  scenes.push_back(oscillation(0.8, 6));
  scenes.push_back(oscillation(0.8, 12));
  constexpr double rho = 0.5;
  scenes.push_back({"standard deviations 1 to 100, 0.5^k", two_tau(rho),
                    scaled(autoregressive(rho, 0, normal_steps(series)), 100), series});
  for (const double together : {0.5, 0.9})
    scenes.push_back({fmt::format("neighbours correlated by {}, 0.5^k", together), two_tau(rho),
                      autoregressive(rho, 0, steps_together(series, together)), series});
  for (const Eigen::Index count : {5, 200})
    scenes.push_back({fmt::format("{} series, 0.5^k", count), two_tau(rho),
                      autoregressive(rho, 0, normal_steps(count)), count});
  return scenes;
}

}  // namespace mikromakro::bench
