// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit_coverage.h"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "fit/fit_trials.h"

namespace mikromakro::bench {
namespace {

std::string percent(const Eigen::Array2d& share) {
  return fmt::format("{:.1f}, {:.1f}", 100 * share[0], 100 * share[1]);
}

void head(const std::string& title) {
  fmt::print(
      "\n{}\n\n| scene | before: 95 % | --blocks: given % | 68 % | 95 % | rings alone: 95 % | width "
      "|\n|---|---|---|---|---|---|---|\n",
      title);
}

void line(const std::string& name, const ProfileTrials& trials) {
  const FitCoverage before = coverage(trials, fit_errors_of_scatter),
                    blocks = coverage(trials, fit_errors_of_blocks),
                    rings = coverage(trials, fit_errors_of_rings);
  const bool given = blocks.given > 0, of_rings = rings.given > 0;
  fmt::print("| {} | {} | {:.1f} | {} | {} | {} | {} |\n", name, percent(before.two_sided),
             100 * blocks.given, given ? percent(blocks.one_sigma) : "-",
             given ? percent(blocks.two_sided) : "-", of_rings ? percent(rings.two_sided) : "-",
             of_rings ? fmt::format("{:.2f}, {:.2f}", rings.width[0], rings.width[1]) : "-");
}

void one_run(ProfileTrials trials, const std::vector<double>& correlations) {
  for (const double length : {0.0, 0.004, 0.008, 0.015}) {
    for (const double rho : correlations) {
      trials.length = length;
      trials.rho = rho;
      line(fmt::format("{} rings, {:g} mm, correlation {}", trials.rings, 1e3 * length, rho), trials);
    }
  }
}

// Rings of another memory than those of which v0 and s are told.
void unlike(ProfileTrials trials) {
  trials.length = 0.008;
  for (const int rings : {20, 60}) {
    for (const int frames : {100, 400}) {
      for (const auto& [near, behind] : {std::pair(0.7, 0.0), std::pair(0.8, 0.3), std::pair(0.0, 0.7)}) {
        trials.rings = rings;
        trials.frames = frames;
        trials.rho = near;
        trials.rho_behind = behind;
        line(fmt::format("{} rings, {} frames, correlation {}, {} behind", rings, frames, near, behind),
             trials);
      }
    }
  }
}

void several_runs(ProfileTrials trials) {
  trials.length = 0.008;
  trials.rho = 0.5;
  for (const double packing : {0.0, 0.3}) {
    for (const int runs : {1, 2, 4, 8, 12}) {
      trials.packing = packing;
      trials.runs = runs;
      line(fmt::format("{} runs, of packings {}", runs, packing), trials);
    }
  }
}

}  // namespace

void print_fit_coverage(int trials) {
  const std::vector<double> correlations = {0, 0.5, 0.7, 0.9};
  ProfileTrials scene;
  scene.count = trials;
  head("v0, s of a fit: 100 frames, noise of 0.25 v, correlated along r and in time");
  for (const int rings : {20, 60}) {
    scene.rings = rings;
    one_run(scene, correlations);
  }
  head("The same, 400 frames");
  scene.frames = 400;
  one_run(scene, {0.9});
  head("100 frames, noise of 0.15 v and 0.0025 v0");
  scene.frames = 100;
  scene.noise = 0.15;
  scene.ground = 0.0025;
  one_run(scene, correlations);
  scene.noise = 0.25;
  scene.ground = 0;
  head("Other memory from 15 mm behind the wheel on, 8 mm");
  unlike(scene);
  head("Runs that are fitted together, 60 rings; of packings: noise that lasts, over that of a frame");
  several_runs(scene);
}

}  // namespace mikromakro::bench
