// SPDX-License-Identifier: GPL-2.0-or-later
// A cell of discs between two rough rings as plain numbers, from which every program of the benchmark starts.
#pragma once

#include <string>
#include <vector>

#include "engine.h"
#include "physics/contact/contact_law.h"

namespace mikromakro::bench {

inline constexpr int type_of_wheel = 3, type_of_outer_ring = 4;

struct DiscScene {
  std::vector<test::Disc> discs;  // number 1 first; types 3 and 4 are the wall discs
  double r_inner = 0, r_outer = 0;
  double omega = 0.1;  // of the inner ring [1/s]
  double time_step = 4e-5;
  double skin = 0.0008;
  double density = 6.36;  // areal [kg/m^2]
  physics::ContactParameters material{352.1, 0.19, 281.68, 0.15, 0.44};

  std::size_t free_discs() const;
  double box() const { return r_outer + 0.01; }  // half of its side
};

/// Run A of the paper: 2511 + 400 free discs, compacted and sheared for 0.2 s.
DiscScene run_a();

/// A cell of about as many free discs of the same kinds and of the density of run A, cut out of copies of a
/// small periodic packing and pressed together between its rings.
DiscScene large_cell(int free_discs);

/// For `read_data` of LIGGGHTS (atom style granular) and LAMMPS (atom style sphere).
void write_data_file(const DiscScene& scene, const std::string& path);

}  // namespace mikromakro::bench
