// SPDX-License-Identifier: GPL-2.0-or-later
// Whole-step times of the paper's cell (run A) and of larger ones: stock LIGGGHTS, the disc styles, stock
// LAMMPS, and the stand-alone loop of disc_reference.h, all from the same state, interleaved in one run.
// Prints a Markdown table.
//   build/bin/step_bench [run_a | NUMBER_OF_DISCS] [STEPS] [REPETITIONS] [disc]
//   mpirun -n 2 build/bin/step_bench ...    adds the engine on both ranks
// `disc` leaves out all but the disc styles, for a profiler.
#include <fmt/format.h>
#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>

#include "disc_reference.h"
#include "neighbor.h"
#include "scene_script.h"
#include "timer.h"
#include "update.h"

namespace mikromakro::bench {
namespace {

constexpr int warm_up = 100;

struct Task {
  const DiscScene& scene;
  const std::string& data_file;
  int steps;
};

double median(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  const std::size_t half = numbers.size() / 2;
  return numbers.size() % 2 ? numbers[half] : (numbers[half - 1] + numbers[half]) / 2;
}

/// One of those who run the race; measures microseconds per step.
struct Contender {
  std::string name;
  int ranks;
  std::function<double(const Task&)> measure;
  std::vector<double> times = {};

  double median() const { return bench::median(times); }
  double least() const { return *std::min_element(times.begin(), times.end()); }
  double most() const { return *std::max_element(times.begin(), times.end()); }
};

enum class Styles { stock, disc };

constexpr auto side_by_side = "disc styles, one run for each rank";

double run_liggghts(const Task& task, Styles styles, MPI_Comm ranks) {
  test::Engine engine(ranks);
  const bool stock = styles == Styles::stock;
  read_scene(engine, task.scene, task.data_file,
             stock ? "model hooke/stiffness tangential history absolute_damping on tangential_damping off"
                   : "model disc/linear tangential disc/cundall_strack");
  engine.run(stock ? stock_integration(task.scene) : disc_integration(task.scene));
  engine.run(fmt::format("run {}\nrun {}\n", warm_up, task.steps));
  return engine.lammps().timer->array[TIME_LOOP] / task.steps * 1e6;
}

double run_reference(const Task& task) {
  DiscReference reference(task.scene);
  reference.run(warm_up);
  const auto begin = std::chrono::steady_clock::now();
  reference.run(task.steps);
  const std::chrono::duration<double, std::micro> elapsed = std::chrono::steady_clock::now() - begin;
  return elapsed.count() / task.steps;
}

/// A LAMMPS as a program; without the variables of mpirun, which would make it one of its ranks. Open MPI 6
/// does not start without HOME.
double run_lammps(const Task& task, const std::string& program, const std::string& styles) {
  const std::string script = temporary_file("lammps_script");
  std::FILE* file = std::fopen(script.c_str(), "w");
  std::fputs(lammps_script(task.scene, task.data_file, styles, warm_up, task.steps).c_str(), file);
  std::fclose(file);
  std::FILE* output = popen(
      (R"(env -i PATH=/usr/bin:/bin HOME="$HOME" )" + program + " -log none -in " + script).c_str(), "r");
  char line[512];
  double seconds = NAN;
  std::string tail;
  while (std::fgets(line, sizeof line, output)) {
    std::sscanf(line, "Loop time of %lf", &seconds);  // that of the last run stays
    tail = line;
  }
  pclose(output);
  std::remove(script.c_str());
  if (std::isnan(seconds))
    throw std::runtime_error(program + ": expected 'Loop time of', got '" + tail + "'");
  return seconds / task.steps * 1e6;
}

/// The disc styles come first, on one rank, with which the others are compared, and on all of them, one
/// after the other, for the machine's speed changes within seconds.
std::vector<Contender> contenders(int ranks, bool only_disc_styles) {
  std::vector<Contender> all;
  all.push_back(
      {"disc styles", 1, [](const Task& t) { return run_liggghts(t, Styles::disc, MPI_COMM_SELF); }});
  if (ranks > 1) {
    // What the machine can give at most: a processor may lose speed when the others work.
    all.push_back({side_by_side, ranks, [](const Task& t) {
                     const double own = run_liggghts(t, Styles::disc, MPI_COMM_SELF);
                     double longest = own;
                     MPI_Allreduce(&own, &longest, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
                     return longest;
                   }});
    all.push_back(
        {"disc styles", ranks, [](const Task& t) { return run_liggghts(t, Styles::disc, MPI_COMM_WORLD); }});
  }
  if (only_disc_styles) return all;
  all.push_back({"stand-alone loop", 1, run_reference});
  all.push_back(
      {"stock LIGGGHTS", 1, [](const Task& t) { return run_liggghts(t, Styles::stock, MPI_COMM_SELF); }});
  all.push_back(
      {"stock LAMMPS", 1, [](const Task& t) { return run_lammps(t, "lmp", lammps_stock_styles(t.scene)); }});
#ifdef LMP_DISC
  all.push_back({"disc styles in LAMMPS", 1,
                 [](const Task& t) { return run_lammps(t, LMP_DISC, lammps_disc_styles(t.scene)); }});
#endif
  if (ranks > 1)
    all.push_back({"stock LIGGGHTS", ranks,
                   [](const Task& t) { return run_liggghts(t, Styles::stock, MPI_COMM_WORLD); }});
  return all;
}

/// Ranks that have nothing to do sleep, so that the one that works has the machine for itself.
void wait_for_rank_0() {
  int done = 0;
  MPI_Request request;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  while (!done) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (!done) usleep(2000);
  }
}

void race(std::vector<Contender>& all, const Task& task, int repetitions) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  for (int k = 0; k < repetitions; ++k) {
    for (auto& contender : all) {
      if (contender.ranks > 1 || rank == 0) contender.times.push_back(contender.measure(task));
      wait_for_rank_0();
    }
  }
}

/// How many times faster `fast` is than `slow`, in each repetition, whose runs follow each other.
std::vector<double> times_faster(const Contender& slow, const Contender& fast) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < slow.times.size(); ++k) ratios.push_back(slow.times[k] / fast.times[k]);
  return ratios;
}

/// Prints the speed of all ranks over that of one where the machine had all its processors to give: in the
/// repetitions in which neither one run alone nor separate runs at the same time took more than a tenth over
/// the fastest of those alone.
void print_undisturbed(const Contender& alone, const Contender& separate, const Contender& shared) {
  const auto ratios = times_faster(alone, shared);
  std::vector<double> undisturbed;
  for (std::size_t k = 0; k < ratios.size(); ++k) {
    if (std::max(alone.times[k], separate.times[k]) <= 1.1 * alone.least()) undisturbed.push_back(ratios[k]);
  }
  fmt::print("Repetitions in which separate runs at the same time took as long as one alone: {} of {}",
             undisturbed.size(), ratios.size());
  if (!undisturbed.empty())
    fmt::print("; speed of all ranks over that of one in these {:.2f}", median(undisturbed));
  fmt::print(".\n");
}

const Contender* find(const std::vector<Contender>& all, const std::string& name, int ranks) {
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Contender& c) { return c.name == name && c.ranks == ranks; });
  return found == all.end() ? nullptr : &*found;
}

/// Kinetic energy of the free discs after `steps` steps of the disc styles and of the stand-alone loop.
void compare_energies(const Task& task, int steps) {
  test::Engine engine(MPI_COMM_SELF);
  read_scene(engine, task.scene, task.data_file, "model disc/linear tangential disc/cundall_strack");
  engine.run(disc_integration(task.scene) + fmt::format("run {}\n", steps));
  double energy = 0;
  for (const auto& [id, d] : engine.discs()) {
    if (d.type < type_of_wheel)
      energy += (d.mass * (d.v_x * d.v_x + d.v_y * d.v_y) + d.inertia() * d.omega * d.omega) / 2;
  }
  DiscReference reference(task.scene);
  reference.run(steps);
  fmt::print(
      "\nAfter {} steps: {} contacts, {} neighbour pairs; kinetic energy {:.15g} J by the disc styles, "
      "{:.15g} J by the stand-alone loop, relative difference {:.1e}.\n",
      steps, reference.contacts(), reference.pairs(), energy, reference.kinetic_energy(),
      std::abs(reference.kinetic_energy() / energy - 1));
}

void print_table(const std::vector<Contender>& all, const Task& task, int repetitions) {
  fmt::print("\n{} free discs, {} wall discs; {} steps, median of {} runs in turn (least, most):\n\n",
             task.scene.free_discs(), task.scene.discs.size() - task.scene.free_discs(), task.steps,
             repetitions);
  fmt::print("| program | ranks | us per step | least | most | over the disc styles on one rank |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- |\n");
  for (const auto& c : all) {
    fmt::print("| {} | {} | {:.1f} | {:.1f} | {:.1f} | {:.2f} |\n", c.name, c.ranks, c.median(), c.least(),
               c.most(), c.median() / all.front().median());
  }
  const auto compare = [&](const char* text, const Contender* slow, const Contender* fast, double share) {
    if (slow && fast) fmt::print("{} {:.2f}.\n", text, share * median(times_faster(*slow, *fast)));
  };
  fmt::print("\n");
  const Contender* ours = &all.front();
  compare("On one rank, LIGGGHTS: stock over ours", find(all, "stock LIGGGHTS", 1), ours, 1);
  compare("On one rank, LIGGGHTS: stock LAMMPS over ours", find(all, "stock LAMMPS", 1), ours, 1);
  compare("On one rank, LAMMPS: stock over ours", find(all, "stock LAMMPS", 1),
          find(all, "disc styles in LAMMPS", 1), 1);
  const Contender* reference = find(all, "stand-alone loop", 1);
  compare("On one rank, ours over the stand-alone loop", ours, reference, 1);
  const int ranks = all.back().ranks;
  if (ranks == 1) return;
  const Contender* shared = find(all, "disc styles", ranks);
  const Contender* separate = find(all, side_by_side, ranks);
  compare("Speed of all ranks over that of one", ours, shared, 1);
  compare("Speed of all ranks over that of as many separate runs at the same time", separate, shared,
          1.0 / ranks);
  print_undisturbed(*ours, *separate, *shared);
}

int run(int argc, char** argv) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const std::string size = argc > 1 ? argv[1] : "run_a";
  const int steps = argc > 2 ? std::stoi(argv[2]) : 1000, repetitions = argc > 3 ? std::stoi(argv[3]) : 7;
  const bool only_disc_styles = argc > 4 && std::string(argv[4]) == "disc";

  DiscScene scene;
  if (rank == 0) scene = size == "run_a" ? run_a() : large_cell(std::stoi(size));
  wait_for_rank_0();
  std::string data_file = temporary_file("step_bench");
  data_file.resize(256);
  MPI_Bcast(data_file.data(), 256, MPI_CHAR, 0, MPI_COMM_WORLD);
  data_file.resize(data_file.find('\0') == std::string::npos ? 256 : data_file.find('\0'));
  double lengths[3] = {scene.r_inner, scene.r_outer, scene.skin};
  MPI_Bcast(lengths, 3, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  scene.r_inner = lengths[0], scene.r_outer = lengths[1], scene.skin = lengths[2];
  if (rank == 0) write_data_file(scene, data_file);
  wait_for_rank_0();

  const Task task{scene, data_file, steps};
  auto all = contenders(ranks, only_disc_styles);
  race(all, task, repetitions);
  if (rank == 0) {
    print_table(all, task, repetitions);
    if (!only_disc_styles) compare_energies(task, 1000);
    std::remove(data_file.c_str());
  }
  wait_for_rank_0();
  return 0;
}

}  // namespace
}  // namespace mikromakro::bench

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  const int result = mikromakro::bench::run(argc, argv);
  MPI_Finalize();
  return result;
}
