// SPDX-License-Identifier: GPL-2.0-or-later
// What a frame of output costs in time and on the disk: snapshots, dumps of text and averages in the run,
// interleaved in one run with the same steps without output; prints a Markdown table.
//   build/bin/output_bench [run_a | NUMBER_OF_DISCS] [FRAMES] [REPETITIONS]
#include <fmt/format.h>
#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "scene_script.h"
#include "timer.h"

namespace mikromakro::bench {
namespace {

constexpr int steps_between = 50;  // few: their cost is subtracted

struct Output {
  std::string what, lines;  // FOLDER, STEPS: replaced
  std::vector<double> times = {};
  double megabytes = 0;
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::string text_dumps() {
  std::string columns;
  for (int k = 1; k <= 16; ++k) columns += fmt::format(" c_contacts[{}]", k);
  return "compute contacts all contact/disc\n"
         "dump particles all custom STEPS FOLDER/particles_*.txt id type x y z radius mass vx vy omegaz fx "
         "fy\n"
         "dump contacts all local STEPS FOLDER/contacts_*.txt" +
         columns + "\n";
}

std::vector<Output> outputs() {
  return {{"no output", ""},
          {"`fix snapshot/disc`", "fix output all snapshot/disc STEPS file FOLDER/snapshots.h5\n"},
          {"text, `dump custom` and `dump local`", text_dumps()},
          {"`fix ave/micromacro`, all default fields, 60 rings",
           "fix output all ave/micromacro STEPS STEPS file FOLDER/rings_*.csv rings RMIN RMAX 60 height "
           "0.006\n"}};
}

std::string filled_in(std::string lines, const DiscScene& scene, const std::string& folder) {
  const std::pair<std::string, std::string> words[] = {{"FOLDER", folder},
                                                       {"STEPS", std::to_string(steps_between)},
                                                       {"RMIN", fmt::format("{}", scene.r_inner)},
                                                       {"RMAX", fmt::format("{}", scene.r_outer)}};
  for (const auto& [word, value] : words)
    for (auto at = lines.find(word); at != std::string::npos; at = lines.find(word, at + value.size()))
      lines.replace(at, word.size(), value);
  return lines;
}

double megabytes_in(const std::string& folder) {
  double sum = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder))
    sum += static_cast<double>(file.file_size()) / 1e6;
  return sum;
}

void measure(Output& output, const DiscScene& scene, const std::string& file, int frames) {
  const std::string folder = file + ".output";
  std::filesystem::create_directory(folder);
  test::Engine engine(MPI_COMM_SELF);
  read_scene(engine, scene, file, "model disc/linear tangential disc/cundall_strack");
  engine.run(disc_integration(scene) + filled_in(output.lines, scene, folder) +
             fmt::format("run 0\nrun {}\n", frames * steps_between));
  output.times.push_back(engine.lammps().timer->array[TIME_LOOP] / frames * 1e3);
  engine.run("clear\n");
  output.megabytes = megabytes_in(folder) / frames;
  std::filesystem::remove_all(folder);
}

void run(int argc, char** argv) {
  const std::string size = argc > 1 ? argv[1] : "run_a";
  const int frames = argc > 2 ? std::stoi(argv[2]) : 20, repetitions = argc > 3 ? std::stoi(argv[3]) : 5;
  const DiscScene scene = size == "run_a" ? run_a() : large_cell(std::stoi(size));
  const auto file = temporary_file("output_bench");
  write_data_file(scene, file);
  auto all = outputs();
  for (int k = 0; k < repetitions; ++k)
    for (Output& output : all) measure(output, scene, file, frames);
  std::remove(file.c_str());
  const double without = median(all.front().times);
  fmt::print(
      "\n{} free discs, {} steps between two of {} frames, medians of {} runs in turn (least to most):\n\n",
      scene.free_discs(), steps_between, frames, repetitions);
  fmt::print(
      "| output | ms per frame, steps included | least to most | output alone, ms | in steps | MB per frame "
      "|\n"
      "| --- | --- | --- | --- | --- | --- |\n");
  for (const Output& output : all) {
    const auto [least, most] = std::minmax_element(output.times.begin(), output.times.end());
    const double alone = median(output.times) - without;
    fmt::print("| {} | {:.2f} | {:.2f} to {:.2f} | {:.2f} | {:.0f} | {:.2f} |\n", output.what,
               median(output.times), *least, *most, alone, alone / without * steps_between, output.megabytes);
  }
}

}  // namespace
}  // namespace mikromakro::bench

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  mikromakro::bench::run(argc, argv);
  MPI_Finalize();
}
