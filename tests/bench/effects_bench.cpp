// SPDX-License-Identifier: GPL-2.0-or-later
// What each effect of the contact law costs per step and holds in memory per contact, in the paper's cell
// (run A), interleaved in one run; prints a Markdown table.
//   build/bin/effects_bench [STEPS] [REPETITIONS]
#include <fmt/format.h>
#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "engine/engine_access.h"
#include "law/disc_law.h"
#include "loop_by_hand.h"
#include "scene_script.h"
#include "timer.h"

namespace mikromakro::bench {
namespace {

struct Law {
  std::string what, pair_style;
  std::string also = {};          // lines before the run
  bool stock_integrator = false;  // which leaves no state open, so that loops may be compared alone
  bool closed = false;            // otherwise contacts act while discs are moved, in no time of their own
  std::vector<double> pair_times = {}, step_times = {};
  double bytes_per_contact = 0;
};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

const std::string off = "model disc/linear tangential off ",
                  viscous = "model disc/linear tangential disc/viscous ",
                  spring = "model disc/linear tangential disc/cundall_strack ";

/// A box around the cell: what smooth walls cost where no disc touches them, with the closed state that they
/// ask for.
const std::string untouched_walls =
    "fix box free biaxial/2d type 4 left -0.2615 fixed right 0.2615 fixed bottom -0.2615 fixed top 0.2615 "
    "fixed\n";

std::vector<Law> laws() {
  return {{"loop without friction by hand, nve/sphere", "model bench/by_hand tangential off", "", true, true},
          {"friction off, nve/sphere", off, "", true, true},
          {"friction off, no dashpot", off + "damping off"},
          {"friction off", off},
          {"friction off, no attraction", off + "limitForce on"},
          {"Eq. 1", viscous},
          {"spring", spring},
          {"spring + dashpot", spring + "tangential_damping on"},
          {"spring, no attraction", spring + "limitForce on"},
          {"Hertz, spring", "model disc/hertz tangential disc/cundall_strack"},
          {"spring, bottom friction", spring, "fix bottom free bottom/friction 2e-5 9.81\n"},
          {"spring, smooth walls besides, untouched", spring, untouched_walls},
          {"spring, contacts recorded in each step", spring, "compute contacts all contact/disc\nthermo 1\n",
           false, true},
          {"spring, thermo line in each step, nothing recorded", spring, "thermo 1\n", false, true}};
}

/// Bytes that the law holds for pairs and contacts; springs are held by the engine too, with the flag of each
/// pair of its neighbour list.
double bytes_per_contact(test::Engine& engine) {
  const auto* law = styles::active_disc_law(engine.lammps());
  if (!law) return 0;
  return static_cast<double>(law->bytes_of_pairs() + law->pair_lists().bytes_in_engine()) /
         static_cast<double>(law->contacts());
}

void measure(Law& law, const DiscScene& scene, const std::string& file, int steps) {
  test::Engine engine(MPI_COMM_SELF);
  read_scene(engine, scene, file, law.pair_style);
  engine.run(law.stock_integrator ? "fix integrate free nve/sphere\nfix plane all enforce2d\n"
                                  : disc_integration(scene));
  engine.run(law.also + "run 0\n");
  law.bytes_per_contact = bytes_per_contact(engine);  // of the same contacts for all
  engine.run(fmt::format("run 100\nrun {}\n", steps));
  const double* times = engine.lammps().timer->array;
  law.pair_times.push_back(times[TIME_PAIR] / steps * 1e6);
  law.step_times.push_back(times[TIME_LOOP] / steps * 1e6);
}

void print(const std::vector<Law>& all, int steps) {
  fmt::print("\nRun A, {} steps, median of {} runs in turn (least to most), us:\n\n", steps,
             all.front().pair_times.size());
  fmt::print(
      "| effects | pair loop | whole step | least to most | bytes per contact |\n| --- | --- | --- | --- | "
      "--- |\n");
  for (const auto& law : all) {
    const auto [pair_least, pair_most] = std::minmax_element(law.pair_times.begin(), law.pair_times.end());
    const auto [least, most] = std::minmax_element(law.step_times.begin(), law.step_times.end());
    const auto pair_loop =
        fmt::format("{:.1f} ({:.1f} to {:.1f})", median(law.pair_times), *pair_least, *pair_most);
    fmt::print("| {} | {} | {:.1f} | {:.1f} to {:.1f} | {} |\n", law.what, law.closed ? pair_loop : "-",
               median(law.step_times), *least, *most,
               law.bytes_per_contact > 0 ? fmt::format("{:.0f}", law.bytes_per_contact) : "-");
  }
  fmt::print("\nPair loop, friction off over the loop by hand: {:.3f} of the medians, {:.3f} of the least.\n",
             median(all[1].pair_times) / median(all[0].pair_times),
             *std::min_element(all[1].pair_times.begin(), all[1].pair_times.end()) /
                 *std::min_element(all[0].pair_times.begin(), all[0].pair_times.end()));
}

void run(int argc, char** argv) {
  const int steps = argc > 1 ? std::stoi(argv[1]) : 1000, repetitions = argc > 2 ? std::stoi(argv[2]) : 7;
  const auto scene = run_a();
  const auto file = temporary_file("effects_bench");
  write_data_file(scene, file);
  register_loop_by_hand();
  auto all = laws();
  for (int k = 0; k < repetitions; ++k) {
    for (auto& law : all) measure(law, scene, file, steps);
  }
  print(all, steps);
  std::remove(file.c_str());
}

}  // namespace
}  // namespace mikromakro::bench

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  mikromakro::bench::run(argc, argv);
  MPI_Finalize();
}
