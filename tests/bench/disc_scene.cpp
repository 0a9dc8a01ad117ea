// SPDX-License-Identifier: GPL-2.0-or-later
#include "disc_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "scene_script.h"

namespace mikromakro::bench {
namespace {

constexpr double radius_small = 0.00371, radius_large = 0.004495, radius_wall = 0.00125, pitch = 0.0053;
constexpr double pi = std::numbers::pi;

double area(double radius) {
  return pi * radius * radius;
}

std::vector<test::Disc> discs_of(const test::Engine& engine) {
  std::vector<test::Disc> discs;
  for (const auto& [id, disc] : engine.discs()) discs.push_back(disc);
  return discs;
}

/// A square periodic packing of small and large discs, 2511 to 400.
std::vector<test::Disc> periodic_packing(double solid_fraction, double& side) {
  constexpr int small = 2511, large = 400, stages = 60;
  const double discs_area = small * area(radius_small) + large * area(radius_large);
  const double first = std::sqrt(discs_area / 0.45), last = std::sqrt(discs_area / solid_fraction);
  test::Engine engine(MPI_COMM_SELF);
  DiscScene scene;
  engine.run(settings("p p p"));
  engine.run(fmt::format("region box block 0 {0} 0 {0} -0.005 0.005 units box\ncreate_box 4 box\n", first));
  engine.run(
      fmt::format("create_discs box 0 {0} 0 {0} seed 1 density {1} velocity 0.05 discs {2} 1 {3} "
                  "discs {4} 2 {5}\n",
                  first, scene.density, small, radius_small, large, radius_large));
  engine.run(fmt::format("neighbor {} bin\nneigh_modify delay 0\n", scene.skin) + constants(scene.material) +
             "pair_style gran model disc/linear tangential disc/viscous\npair_coeff * *\n");
  engine.run(fmt::format("timestep {}\nfix integrate all nve/disc\n", scene.time_step));
  for (int stage = 1; stage <= stages; ++stage) {
    const double now = first + (last - first) * stage / stages;
    engine.run(fmt::format("change_box all x final 0 {0:.17g} y final 0 {0:.17g} remap units box\nrun {1}\n",
                           now, stage < stages ? 150 : 3000));
  }
  side = last;
  return discs_of(engine);
}

void add_ring(std::vector<test::Disc>& discs, double r, int number, int type) {
  for (int k = 0; k < number; ++k) {
    test::Disc disc{};
    disc.type = type;
    disc.radius = radius_wall;
    disc.x = r * std::cos(2 * pi * k / number);
    disc.y = r * std::sin(2 * pi * k / number);
    discs.push_back(disc);
  }
}

/// Free discs of copies of the packing that find room between the rings.
std::vector<test::Disc> cut_out(const std::vector<test::Disc>& packing, double side, double r_inner,
                                double r_outer) {
  std::vector<test::Disc> discs;
  const int copies = static_cast<int>(r_outer / side) + 1;
  for (int n_x = -copies; n_x < copies; ++n_x) {
    for (int n_y = -copies; n_y < copies; ++n_y) {
      for (auto disc : packing) {
        disc.x += n_x * side;
        disc.y += n_y * side;
        const double r = std::hypot(disc.x, disc.y), room = disc.radius + radius_wall;
        if (r - r_inner > room && r_outer - r > room) discs.push_back(disc);
      }
    }
  }
  return discs;
}

/// Presses the discs together until the outer ring has the radius r_end, and shears a little.
void compact(DiscScene& scene, double r_end) {
  const std::string file = temporary_file("compaction");
  write_data_file(scene, file);
  test::Engine engine(MPI_COMM_SELF);
  read_scene(engine, scene, file, "model disc/linear tangential disc/viscous");
  const auto cell = [&](double omega, const std::string& course) {
    return fmt::format(
        "fix cell wall couette/2d center 0 0 inner rough inner {:.17g} outer rough outer {:.17g} "
        "omega_inner {} {}\n",
        scene.r_inner, scene.r_outer, omega, course);
  };
  engine.run("fix integrate free nve/disc\n" + cell(0, fmt::format("compact {:.17g} 0.1", r_end)));
  engine.run("run 2500\nunfix cell\n");
  scene.r_outer = r_end;
  engine.run(cell(scene.omega, "") + "run 1500\n");
  scene.discs = discs_of(engine);
  std::remove(file.c_str());
}

}  // namespace

std::size_t DiscScene::free_discs() const {
  return std::count_if(discs.begin(), discs.end(), [](const auto& d) { return d.type < type_of_wheel; });
}

DiscScene run_a() {
  DiscScene scene;
  scene.r_inner = 0.1032;
  scene.r_outer = 0.2524;
  const double r_start = 0.328;
  test::Engine engine(MPI_COMM_SELF);
  engine.run(settings("f f p"));
  engine.run("region box block -0.34 0.34 -0.34 0.34 -0.005 0.005 units box\ncreate_box 4 box\n");
  engine.run(fmt::format("create_ring 0 0 {} pitch {} type 3 radius {} density {}\n", scene.r_inner, pitch,
                         radius_wall, scene.density));
  engine.run(fmt::format("create_ring 0 0 {} number 299 type 4 radius {} density {}\n", r_start, radius_wall,
                         scene.density));
  engine.run(
      fmt::format("create_discs ring 0 0 {} {} seed 1 density {} velocity 0.05 discs 2511 1 {} discs "
                  "400 2 {}\n",
                  scene.r_inner, r_start, scene.density, radius_small, radius_large));
  set_up_law(engine, scene, "model disc/linear tangential disc/viscous");
  engine.run("fix integrate free nve/disc\n");
  const auto cell = [&](double r_outer, const std::string& rest) {
    return fmt::format("fix cell wall couette/2d center 0 0 inner rough inner {} outer rough outer {} {}\n",
                       scene.r_inner, r_outer, rest);
  };
  engine.run(cell(r_start, fmt::format("omega_inner 0 compact {} 0.5", scene.r_outer)));
  engine.run("run 15000\nunfix cell\n");
  engine.run(cell(scene.r_outer, "omega_inner 0.1") + "run 5000\n");
  scene.discs = discs_of(engine);
  return scene;
}

DiscScene large_cell(int free_discs) {
  constexpr double loose = 0.818, dense = 0.824;
  const double scale = std::sqrt(free_discs / 2911.0);
  double side = 0;
  const auto packing = periodic_packing(loose, side);
  DiscScene scene;
  scene.r_inner = 0.1032 * scale;
  scene.r_outer = 0.2524 * scale;
  scene.discs = cut_out(packing, side, scene.r_inner, scene.r_outer);
  double discs_area = 0;
  for (const auto& disc : scene.discs) discs_area += area(disc.radius);
  const double r_end = std::sqrt(discs_area / (pi * dense) + scene.r_inner * scene.r_inner);
  add_ring(scene.discs, scene.r_inner, static_cast<int>(2 * pi * scene.r_inner / pitch), type_of_wheel);
  add_ring(scene.discs, scene.r_outer, static_cast<int>(2 * pi * scene.r_outer / pitch), type_of_outer_ring);
  compact(scene, r_end);
  // Of so many discs the fastest leaves a thin skin soon. All programs of the benchmark are faster with a
  // thick one (300,000, skins of 0.8 and 3.2 mm: stock LIGGGHTS 50.1 and 45.5 ms per step, the disc
  // styles 9.9 and 7.0).
  scene.skin *= 4;
  return scene;
}

void write_data_file(const DiscScene& scene, const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  const auto write = [&](const std::string& text) { std::fputs(text.c_str(), file); };
  write(fmt::format("discs between two rings\n\n{} atoms\n4 atom types\n", scene.discs.size()));
  write(fmt::format("{0} {1} xlo xhi\n{0} {1} ylo yhi\n-0.005 0.005 zlo zhi\n\nAtoms\n\n", -scene.box(),
                    scene.box()));
  for (std::size_t k = 0; k < scene.discs.size(); ++k) {
    const auto& d = scene.discs[k];
    write(fmt::format("{} {} {:.17g} {} {:.17g} {:.17g} 0\n", k + 1, d.type, 2 * d.radius, scene.density, d.x,
                      d.y));
  }
  write("\nVelocities\n\n");
  for (std::size_t k = 0; k < scene.discs.size(); ++k) {
    const auto& d = scene.discs[k];
    write(fmt::format("{} {:.17g} {:.17g} 0 0 0 {:.17g}\n", k + 1, d.v_x, d.v_y, d.omega));
  }
  std::fclose(file);
}

}  // namespace mikromakro::bench
