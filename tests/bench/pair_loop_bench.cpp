// SPDX-License-Identifier: GPL-2.0-or-later
// Pair time per step of the stock contact law and of ours in the paper's cell (run A), interleaved in one
// run; prints the ratios.
//   build/bin/pair_loop_bench
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>

#include "scene_script.h"
#include "timer.h"

namespace {

using mikromakro::test::Engine;

struct Law {
  const char *name, *pair_style;
};
constexpr Law stock_laws[] = {
    {"stock/off", "model hooke/stiffness tangential off absolute_damping on"},
    {"stock/no_history", "model hooke/stiffness tangential no_history absolute_damping on"},
    {"stock/history", "model hooke/stiffness tangential history absolute_damping on"}};
constexpr Law disc_laws[] = {{"disc/off", "model disc/linear tangential off"},
                             {"disc/viscous", "model disc/linear tangential disc/viscous"},
                             {"disc/cundall_strack", "model disc/linear tangential disc/cundall_strack"}};

/// Walls stand still in the pair benchmark: nothing moves them, so they need no fix.
constexpr auto integration = "fix integrate free nve/sphere\nfix plane all enforce2d\n";

struct Scene {
  mikromakro::bench::DiscScene discs;
  std::string data_file;
};

/// Seconds that the engine spent in the pair style during `steps` steps of the sheared cell.
double pair_seconds(const Law& law, const Scene& scene, int steps) {
  Engine engine;
  mikromakro::bench::read_scene(engine, scene.discs, scene.data_file, law.pair_style);
  engine.run(integration);
  engine.run(fmt::format("run 100\nrun {}\n", steps));
  return engine.lammps().timer->array[TIME_PAIR];
}

void pair_time(benchmark::State& state, const Law& law, const Scene& scene) {
  constexpr int steps = 1000;
  for (auto _ : state) state.SetIterationTime(pair_seconds(law, scene, steps) / steps);
}

/// The console table, and the medians for the ratios.
class Medians : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const auto& run : runs) {
      if (run.aggregate_name == "median") medians_[run.run_name.function_name] = run.GetAdjustedRealTime();
    }
    ConsoleReporter::ReportRuns(runs);
  }
  bool has(const std::string& name) const { return medians_.contains(name); }
  double operator[](const std::string& name) const { return medians_.at(name); }

 private:
  std::map<std::string, double> medians_;
};

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  std::vector<char*> arguments(argv, argv + argc);
  std::string repetitions = "--benchmark_repetitions=7",
              interleaving = "--benchmark_enable_random_interleaving=true",
              aggregates = "--benchmark_report_aggregates_only=true";
  arguments.insert(arguments.begin() + 1, {repetitions.data(), interleaving.data(), aggregates.data()});
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  const Scene scene{mikromakro::bench::run_a(), mikromakro::bench::temporary_file("pair_loop_bench")};
  mikromakro::bench::write_data_file(scene.discs, scene.data_file);
  for (const auto* laws : {&stock_laws, &disc_laws}) {
    for (const auto& law : *laws) {
      benchmark::RegisterBenchmark(law.name, pair_time, law, scene)
          ->UseManualTime()
          ->Iterations(1)
          ->Unit(benchmark::kMicrosecond)
          ->ComputeStatistics(
              "min", [](const std::vector<double>& v) { return *std::min_element(v.begin(), v.end()); });
    }
  }
  Medians medians;
  benchmark::RunSpecifiedBenchmarks(&medians);
  for (int k = 0; k < 3; ++k) {
    if (!medians.has(stock_laws[k].name) || !medians.has(disc_laws[k].name)) continue;  // filtered out
    fmt::print("pair loop, {} over {}: {:.1f}\n", stock_laws[k].name, disc_laws[k].name,
               medians[stock_laws[k].name] / medians[disc_laws[k].name]);
  }
  std::remove(scene.data_file.c_str());
  MPI_Finalize();
}
