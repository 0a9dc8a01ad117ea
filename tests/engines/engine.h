// SPDX-License-Identifier: GPL-2.0-or-later
// An engine with the disc styles inside the test process: tests give it input lines and read its
// discs and contacts back in full precision.
#pragma once

#include <mpi.h>

#include <map>
#include <string>
#include <vector>

#include "engine_lines.h"
#include "lammps.h"

namespace LAMMPS_NS {
class Compute;
class Fix;
}  // namespace LAMMPS_NS

namespace mikromakro::test {

struct Disc {
  int type;
  double radius, mass, x, y, v_x, v_y, omega, f_x, f_y, torque;
  double inertia() const { return mass * radius * radius / 2; }
};

/// A row of compute contact/disc.
struct Contact {
  double id1, id2, x1, y1, x2, y2, n_x, n_y, overlap, f_x, f_y, f_n, f_t, xi, v_n, v_t;
};

class Engine {
 public:
  explicit Engine(MPI_Comm ranks = MPI_COMM_WORLD);

  /// Runs lines of LIGGGHTS (engine_lines.h) as a script would; an error of the engine ends the process.
  void run(const std::string& lines);

  /// All discs of all ranks by id.
  std::map<int, Disc> discs() const;

  /// Rows of `compute ID contact/disc` of all ranks, the smaller id first, by the pair of ids.
  std::map<std::pair<int, int>, Contact> contacts(const std::string& compute_id = "contacts") const;

  LAMMPS_NS::LAMMPS& lammps() { return *lammps_; }
  /// The fix or compute of this id; the test fails where there is none.
  LAMMPS_NS::Fix& fix(const std::string& id) const;
  LAMMPS_NS::Compute& compute(const std::string& id) const;

 private:
  EngineLines lines_;
  MPI_Comm ranks_;
  LAMMPS_NS::LAMMPS* lammps_;
};

/// The lines every scene starts with: units, two dimensions, box [-size, size]^2 with the given boundary,
/// types, and the material constants k_n, gamma_n, k_t, gamma_t, mu for all pairs of types.
struct Material {
  double k_n = 352.1, gamma_n = 0.19, k_t = 281.68, gamma_t = 0.15, mu = 0.44;
};
std::string scene(const std::string& pair_style, const Material& material, double size = 1, int types = 2,
                  const std::string& boundary = "f f p", const std::string& skin = "0.001");

/// The lines with the material constants alone, for all pairs of types.
std::string constants(const Material& material, int types);

/// Lines that create one disc; areal density in kg/m^2.
std::string disc(int id, double x, double y, double radius, double density = 6.36, int type = 1);

/// Lines that set the velocity and the spin of one disc.
std::string motion(int id, double v_x, double v_y, double omega = 0);

}  // namespace mikromakro::test
