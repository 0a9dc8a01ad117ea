// SPDX-License-Identifier: GPL-2.0-or-later
#include "scene_script.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <numbers>

namespace mikromakro::bench {
namespace {

constexpr auto groups = "group free type 1 2\ngroup inner type 3\ngroup outer type 4\ngroup wall type 3 4\n";

std::string neighbours(const DiscScene& scene) {
  return fmt::format("neighbor {} bin\nneigh_modify delay 0 exclude group wall wall\n", scene.skin);
}

double period(const DiscScene& scene) {
  return 2 * std::numbers::pi / scene.omega;
}

}  // namespace

std::string settings(const std::string& boundary) {
  return "atom_style granular\natom_modify map array\nunits si\ndimension 2\nnewton off\ncommunicate single "
         "vel yes\nprocessors * * 1\nboundary " +
         boundary + "\n";
}

std::string constants(const physics::ContactParameters& material) {
  const auto constant = [](const char* name, double value) {
    std::string line = fmt::format("fix {0} all property/global {0} peratomtypepair 4", name);
    for (int k = 0; k < 16; ++k) line += fmt::format(" {}", value);
    return line + "\n";
  };
  return constant("kn", material.normal_stiffness) + constant("kt", material.tangential_stiffness) +
         constant("gamman_abs", material.normal_damping) +
         constant("gammat_abs", material.tangential_damping) +
         constant("coefficientFriction", material.friction);
}

void set_up_law(test::Engine& engine, const DiscScene& scene, const std::string& pair_style) {
  engine.run(groups + neighbours(scene) + constants(scene.material) + "pair_style gran " + pair_style +
             "\npair_coeff * *\n" + fmt::format("timestep {}\n", scene.time_step));
}

void read_scene(test::Engine& engine, const DiscScene& scene, const std::string& file,
                const std::string& pair_style) {
  engine.run(settings("f f p") + "read_data " + file + "\n");
  set_up_law(engine, scene, pair_style);
}

std::string disc_integration(const DiscScene& scene) {
  return fmt::format(
      "fix integrate free nve/disc\nfix cell wall couette/2d center 0 0 inner rough inner {:.17g} outer "
      "rough outer {:.17g} omega_inner {}\n",
      scene.r_inner, scene.r_outer, scene.omega);
}

std::string stock_integration(const DiscScene& scene) {
  return fmt::format(
      "fix integrate free nve/sphere\nfix plane all enforce2d\nfix wheel inner move rotate 0 0 0 0 0 1 {}\n",
      period(scene));
}

std::string lammps_stock_styles(const DiscScene& scene) {
  const auto& m = scene.material;
  // Damping of this pair style is a rate, multiplied by the effective mass; that of two small discs.
  const double m12 = scene.density * std::numbers::pi * 0.00371 * 0.00371 / 2;
  return fmt::format("pair_style gran/hooke/history {} {} {} NULL {} 0\npair_coeff * *\n", m.normal_stiffness,
                     m.tangential_stiffness, m.normal_damping / m12, m.friction) +
         fmt::format(
             "fix integrate free nve/sphere disc\nfix plane all enforce2d\n"
             "fix wheel inner move rotate 0 0 0 0 0 1 {}\n",
             period(scene));
}

std::string lammps_disc_styles(const DiscScene& scene) {
  const auto& m = scene.material;
  return fmt::format(
             "pair_style disc/linear tangential disc/cundall_strack\n"
             "pair_coeff * * kn {} kt {} gamman {} mu {}\n",
             m.normal_stiffness, m.tangential_stiffness, m.normal_damping, m.friction) +
         disc_integration(scene);
}

std::string lammps_script(const DiscScene& scene, const std::string& data_file, const std::string& styles,
                          int warm_up, int steps) {
  return "units si\natom_style sphere\ndimension 2\nnewton off\ncomm_modify vel yes\nprocessors * * 1\n"
         "boundary f f p\nread_data " +
         data_file + fmt::format("\nset group all density/disc {}\n", scene.density) + groups +
         neighbours(scene) + fmt::format("timestep {}\n", scene.time_step) + styles +
         fmt::format("run {}\nrun {}\n", warm_up, steps);
}

std::string temporary_file(const std::string& name) {
  return std::filesystem::temp_directory_path() / fmt::format("mikromakro_{}.{}", name, getpid());
}

}  // namespace mikromakro::bench
