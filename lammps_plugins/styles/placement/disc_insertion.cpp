// SPDX-License-Identifier: GPL-2.0-or-later
#include "placement/disc_insertion.h"

#include <mpi.h>

#include <algorithm>
#include <numbers>

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "engine/arguments.h"
#include "engine/engine_access.h"
#include "engine/engine_lists.h"
#include "fix.h"
#include "lammps.h"
#include "modify.h"

namespace mikromakro::styles {
namespace {

int largest_id(const LAMMPS_NS::LAMMPS& engine) {
  const LAMMPS_NS::Atom& atom = *engine.atom;
  int largest = 0;
  for (int i = 0; i < atom.nlocal; ++i) largest = std::max(largest, atom.tag[i]);
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_INT, MPI_MAX, engine.world);
  return largest;
}

bool in_own_part(const LAMMPS_NS::Domain& domain, const double* position) {
  for (int k = 0; k < 3; ++k) {
    if (position[k] < domain.sublo[k] || position[k] >= domain.subhi[k]) return false;
  }
  return true;
}

void add_disc(LAMMPS_NS::Atom& atom, const NewDisc& disc, double* position, double areal_density) {
  atom.avec->create_atom(disc.type, position);
  const int i = atom.nlocal - 1;
  const double radius = disc.place.radius;
  atom.radius[i] = radius;
  store_density(atom, i, areal_density);
  atom.rmass[i] = std::numbers::pi * radius * radius * areal_density;
  atom.v[i][0] = disc.velocity.x;
  atom.v[i][1] = disc.velocity.y;
}

// Does what the engine's own create_atoms does after adding atoms.
void announce_new_atoms(LAMMPS_NS::LAMMPS& engine, int first) {
  LAMMPS_NS::Atom& atom = *engine.atom;
  for (LAMMPS_NS::Fix* fix : fixes(*engine.modify)) {
    if (!fix->create_attribute) continue;
    announce_set_arrays(*fix);
    for (int i = first; i < atom.nlocal; ++i) fix->set_arrays(i);
  }
  if (atom.map_style) {
    atom.nghost = 0;
    atom.map_init();
    atom.map_set();
  }
}

}  // namespace

void check_ready_for_discs(LAMMPS_NS::LAMMPS& engine, const std::string& style) {
  const LAMMPS_NS::Atom& atom = *engine.atom;
  if (!engine.domain->box_exist) stop(engine, style, "expected a simulation box, define one with create_box");
  if (engine.domain->dimension != 2) stop(engine, style, "expected 'dimension 2', got dimension 3");
  if (engine.domain->triclinic != 0)
    stop(engine, style, "expected an orthogonal box (region block), got a tilted one (region prism)");
  if (!stores_discs(atom))
    stop(engine, style,
         "expected an atom style with radius and density, such as " + std::string(disc_atom_style));
  if (!atom.tag_enable) stop(engine, style, "expected atoms with ids");
  if (engine.modify->nfix_restart_peratom)
    stop(engine, style,
         "expected no fix data still pending from a restart file; start a run before this command");
}

void check_inside_box(LAMMPS_NS::LAMMPS& engine, const std::string& style, const std::string& what,
                      const physics::Rectangle& bounds) {
  const LAMMPS_NS::Domain& domain = *engine.domain;
  const double low[2] = {bounds.x_min, bounds.y_min};
  const double high[2] = {bounds.x_max, bounds.y_max};
  for (int k = 0; k < 2; ++k) {
    // 2 and 3 are the engine's shrink-wrapped sides.
    const bool low_fits = domain.boundary[k][0] >= 2 || low[k] >= domain.boxlo[k];
    const bool high_fits = domain.boundary[k][1] >= 2 || high[k] <= domain.boxhi[k];
    if (low_fits && high_fits) continue;
    const std::string axis = k == 0 ? "x" : "y";
    stop(engine, style,
         what + ": expected to fit into the box, whose " + axis + " goes from " + text_of(domain.boxlo[k]) +
             " to " + text_of(domain.boxhi[k]) + ", got " + text_of(low[k]) + " to " + text_of(high[k]));
  }
}

void insert_discs(LAMMPS_NS::LAMMPS& engine, const std::string& style, const std::vector<NewDisc>& discs,
                  double areal_density) {
  LAMMPS_NS::Atom& atom = *engine.atom;
  const int first_local = atom.nlocal;
  int id = largest_id(engine);
  for (const NewDisc& disc : discs) {
    ++id;
    double position[3] = {disc.place.x, disc.place.y, 0.0};
    if (!in_own_part(*engine.domain, position)) continue;
    add_disc(atom, disc, position, areal_density);
    atom.tag[atom.nlocal - 1] = id;
  }
  announce_new_atoms(engine, first_local);

  const auto before = atom.natoms;
  LAMMPS_NS::bigint owned = atom.nlocal;
  MPI_Allreduce(&owned, &atom.natoms, 1, MPI_LMP_BIGINT, MPI_SUM, engine.world);
  const auto missing = static_cast<long long>(discs.size()) - (atom.natoms - before);
  if (missing != 0)
    stop(engine, style, std::to_string(missing) + " discs lie outside of the box (is z = 0 inside it?)");
}

namespace {

// Adds images that reach, or nearly reach, into the box through its periodic boundaries.
void add_images(const LAMMPS_NS::Domain& domain, std::vector<physics::PlacedDisc>& discs) {
  double largest = 0;
  for (const auto& disc : discs) largest = std::max(largest, disc.radius);
  const double near = 2 * largest;
  const int sides_x = domain.xperiodic ? 1 : 0, sides_y = domain.yperiodic ? 1 : 0;
  const std::size_t own = discs.size();
  for (std::size_t k = 0; k < own; ++k)
    for (int i = -sides_x; i <= sides_x; ++i)
      for (int j = -sides_y; j <= sides_y; ++j) {
        const double x = discs[k].x + i * domain.prd[0], y = discs[k].y + j * domain.prd[1];
        const bool reaches = x > domain.boxlo[0] - near && x < domain.boxhi[0] + near &&
                             y > domain.boxlo[1] - near && y < domain.boxhi[1] + near;
        if ((i != 0 || j != 0) && reaches) discs.push_back({x, y, discs[k].radius});
      }
}

}  // namespace

std::vector<physics::PlacedDisc> existing_discs(LAMMPS_NS::LAMMPS& engine) {
  const LAMMPS_NS::Atom& atom = *engine.atom;
  std::vector<physics::PlacedDisc> own;
  own.reserve(atom.nlocal);
  for (int i = 0; i < atom.nlocal; ++i) own.push_back({atom.x[i][0], atom.x[i][1], atom.radius[i]});

  constexpr int doubles_per_disc = sizeof(physics::PlacedDisc) / sizeof(double);
  const int own_size = static_cast<int>(own.size()) * doubles_per_disc;
  std::vector<int> sizes(engine.comm->nprocs);
  MPI_Allgather(&own_size, 1, MPI_INT, sizes.data(), 1, MPI_INT, engine.world);
  std::vector<int> starts(sizes.size(), 0);
  for (std::size_t k = 1; k < sizes.size(); ++k) starts[k] = starts[k - 1] + sizes[k - 1];
  std::vector<physics::PlacedDisc> all((starts.back() + sizes.back()) / doubles_per_disc);
  MPI_Allgatherv(own.data(), own_size, MPI_DOUBLE, all.data(), sizes.data(), starts.data(), MPI_DOUBLE,
                 engine.world);
  add_images(*engine.domain, all);
  return all;
}

void say(LAMMPS_NS::LAMMPS& engine, const std::string& line) {
  if (engine.comm->me != 0) return;
  for (FILE* out : {engine.screen, engine.logfile}) {
    if (out) std::fprintf(out, "%s\n", line.c_str());
  }
}

}  // namespace mikromakro::styles
