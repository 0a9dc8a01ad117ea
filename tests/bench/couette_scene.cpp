#include "couette_scene.h"

#include <fmt/format.h>

namespace mikromakro::bench {
namespace {

constexpr double r_inner = 0.1032, r_outer = 0.2524, r_start = 0.328, density = 6.36, time_step = 4e-5;

std::string properties() {
  const auto constant = [](const char* name, double value) {
    std::string line = fmt::format("fix {0} all property/global {0} peratomtypepair 4", name);
    for (int k = 0; k < 16; ++k) line += fmt::format(" {}", value);
    return line + "\n";
  };
  return constant("kn", 352.1) + constant("kt", 281.68) + constant("gamman_abs", 0.19) +
         constant("gammat_abs", 0.15) + constant("coefficientFriction", 0.44);
}

constexpr auto settings =
    "atom_style granular\natom_modify map array\nunits si\ndimension 2\nnewton off\ncommunicate single vel "
    "yes\n"
    "processors * * 1\nboundary f f p\n";
constexpr auto neighbours = "neighbor 0.0008 bin\nneigh_modify delay 0 exclude group wall wall\n";

}  // namespace

void prepare_couette_cell(const std::string& restart_file) {
  test::Engine engine;
  engine.run(settings);
  engine.run("region box block -0.34 0.34 -0.34 0.34 -0.005 0.005 units box\ncreate_box 4 box\n");
  engine.run(
      fmt::format("create_ring 0 0 {} pitch 0.0053 type 3 radius 0.00125 density {}\n", r_inner, density));
  engine.run(
      fmt::format("create_ring 0 0 {} number 299 type 4 radius 0.00125 density {}\n", r_start, density));
  engine.run(
      fmt::format("create_discs ring 0 0 {} {} seed 1 density {} velocity 0.05 discs 2511 1 0.00371 discs "
                  "400 2 0.004495\n",
                  r_inner, r_start, density));
  engine.run("group free type 1 2\ngroup inner type 3\ngroup outer type 4\ngroup wall type 3 4\n");
  engine.run(neighbours + properties() +
             "pair_style gran model disc/linear tangential disc/viscous\npair_coeff * *\n");
  engine.run(fmt::format("timestep {}\nfix integrate free nve/disc\n", time_step));
  engine.run(
      fmt::format("fix cell wall couette/2d center 0 0 inner rough inner {} outer rough outer {} omega_inner "
                  "0 compact {} 0.5\n",
                  r_inner, r_start, r_outer));
  engine.run("run 15000\nunfix cell\n");
  engine.run(fmt::format(
      "fix cell wall couette/2d center 0 0 inner rough inner {} outer rough outer {} omega_inner 0.1\n",
      r_inner, r_outer));
  engine.run("run 5000\nunfix cell\nunfix integrate\nwrite_restart " + restart_file + "\n");
}

void start_couette_cell(test::Engine& engine, const std::string& restart_file, const Simulation& simulation) {
  engine.run(settings);
  engine.run("read_restart " + restart_file + "\n");
  engine.run(neighbours + properties() + "pair_style gran " + simulation.pair_style + "\npair_coeff * *\n");
  engine.run(fmt::format("timestep {}\n", time_step) + simulation.integration);
}

}  // namespace mikromakro::bench
