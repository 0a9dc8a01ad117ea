// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/disc_check.h"

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "compute.h"
#include "domain.h"
#include "engine/arguments.h"
#include "engine/engine_access.h"
#include "engine/engine_lists.h"
#include "engine/first_rank.h"
#include "fix.h"
#include "lammps.h"
#include "law/disc_law.h"
#include "law/fix_on_rows.h"
#include "modify.h"
#include "update.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;

namespace {

constexpr int none = std::numeric_limits<int>::max();

/// Smallest id, over all ranks, of the discs that satisfy a condition.
template <class Condition>
int first_disc(const LAMMPS& engine, Condition condition) {
  const Atom& atom = *engine.atom;
  int first = none;
  for (int i = 0; i < atom.nlocal; ++i) {
    if (condition(i)) first = std::min(first, static_cast<int>(atom.tag[i]));
  }
  MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, engine.world);
  return first;
}

void check_positive(LAMMPS& engine, const std::string& style, const std::string& what, const double* values) {
  const int disc =
      first_disc(engine, [values](int i) { return !(values[i] > 0 && std::isfinite(values[i])); });
  if (disc == none) return;
  stop(engine, style,
       "disc " + std::to_string(disc) + ": expected a " + what +
           " above 0; 'set ... diameter' and a density give it");
}

/// Radii of the two largest discs.
std::array<double, 2> largest_radii(LAMMPS& engine) {
  std::array<double, 2> mine{};
  const auto take = [](std::array<double, 2>& two, double radius) {
    if (radius > two[0])
      two = {radius, two[0]};
    else
      two[1] = std::max(two[1], radius);
  };
  for (int i = 0; i < engine.atom->nlocal; ++i) take(mine, engine.atom->radius[i]);
  std::vector<double> all(2 * static_cast<std::size_t>(engine.comm->nprocs));
  MPI_Allgather(mine.data(), 2, MPI_DOUBLE, all.data(), 2, MPI_DOUBLE, engine.world);
  std::array<double, 2> two{};
  for (const double radius : all) take(two, radius);
  return two;
}

/// The contact of a disc with its own image would be missing from contact rows and hence from the stress. Two
/// discs in contact through two images have two springs, but the engines store springs by the partner's id:
/// the next neighbour list would give both contacts the same spring.
void check_box_width(LAMMPS& engine, const std::string& style, bool with_springs) {
  const Domain& domain = *engine.domain;
  const auto [largest, second] = largest_radii(engine);
  const bool periodic[] = {domain.xperiodic != 0, domain.yperiodic != 0};
  for (int axis = 0; axis < 2; ++axis) {
    if (!periodic[axis]) continue;
    const std::string along = axis == 0 ? " along x" : " along y";
    if (domain.prd[axis] < 2 * largest)
      stop(engine, style,
           "expected a periodic box that is wider than a disc" + along + ", got " +
               text_of(domain.prd[axis]) + " m and a disc of " + text_of(2 * largest) +
               " m: it would touch its own image");
    if (with_springs && domain.prd[axis] < 2 * (largest + second))
      stop(
          engine, style,
          "expected a periodic box that is wider than " + text_of(2 * (largest + second)) + " m" + along +
              ", twice the distance of the two largest discs, got " + text_of(domain.prd[axis]) +
              " m: where two discs touch through two images, the engine keeps one spring (tangential off and "
              "disc/viscous need none)");
  }
}

/// A disc with two integrators would be moved twice per step.
void check_integrators(LAMMPS& engine, const std::string& style) {
  const Modify& modify = *engine.modify;
  for (const Fix* integrator : fixes(modify)) {
    const Fix& own = *integrator;
    if (!dynamic_cast<const DiscIntegrator*>(integrator)) continue;
    for (const Fix* second : fixes(modify)) {
      const Fix& other = *second;
      if (second == integrator || !other.time_integrate) continue;
      const int* mask = engine.atom->mask;
      const int disc = first_disc(
          engine, [&](int i) { return (mask[i] & own.groupbit) != 0 && (mask[i] & other.groupbit) != 0; });
      if (disc == none) continue;
      stop(engine, style,
           "disc " + std::to_string(disc) + " is integrated twice, by fix " + own.id + " (" + own.style +
               ") and by fix " + other.id + " (" + other.style +
               "); expected it in the group of one of them");
    }
  }
}

bool moves_without_turning(const Fix& fix) {
  constexpr std::array names = {"nve", "nve/limit", "nve/noforce", "nvt", "npt", "nph"};
  return std::any_of(names.begin(), names.end(),
                     [&](const char* name) { return std::strcmp(fix.style, name) == 0; });
}

void warn_of_integrators(LAMMPS& engine, const std::string& style) {
  const bool friction = active_disc_law(engine)->effects().tangential != physics::Tangential::none;
  const Modify& modify = *engine.modify;
  bool any = false;
  for (const Fix* integrator : fixes(modify)) {
    const Fix& fix = *integrator;
    any = any || fix.time_integrate;
    if (turns_spheres(fix))
      warn(engine, style + ": fix " + fix.id + " (" + fix.style +
                       ") rotates discs with the moment of inertia of spheres, 2/5 m a^2; expected 'fix " +
                       fix.id + " ... nve/sphere disc' or nve/disc");
  }
  for (const Fix* integrator : fixes(modify)) {
    const Fix& fix = *integrator;
    if (friction && moves_without_turning(fix))
      warn(engine, style + ": fix " + fix.id + " (" + fix.style +
                       ") does not rotate discs, although friction exerts torques on them; expected 'fix " +
                       fix.id + " ... nve/disc'");
  }
  for (const Compute* compute : computes(modify)) {
    if (std::strcmp(compute->style, "erotate/sphere") == 0)
      warn(engine, style + ": compute " + compute->id +
                       " (erotate/sphere) uses the moment of inertia of spheres; the rotational energy of "
                       "discs is 5/4 of what it gives");
  }
  if (!any && engine.update->nsteps > 0)
    warn(engine,
         style + ": no fix integrates the discs, which will not move; expected 'fix ID group nve/disc'");
}

/// Range of radius, m/r^2 and m/r^3 over the discs of one type.
struct Spread {
  std::array<double, 3> least, largest;
  double relative(int k) const { return 1 - least[k] / largest[k]; }
};

Spread spread_of(const LAMMPS& engine, int type) {
  const Atom& atom = *engine.atom;
  std::array<double, 6> ends;
  ends.fill(-std::numeric_limits<double>::infinity());
  for (int i = 0; i < atom.nlocal; ++i) {
    if (atom.type[i] != type) continue;
    const double r = atom.radius[i], m = atom.rmass[i];
    const std::array<double, 3> values = {r, m / (r * r), m / (r * r * r)};
    for (int k = 0; k < 3; ++k) {
      ends[k] = std::max(ends[k], -values[k]);
      ends[k + 3] = std::max(ends[k + 3], values[k]);
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, ends.data(), 6, MPI_DOUBLE, MPI_MAX, engine.world);
  return {{-ends[0], -ends[1], -ends[2]}, {ends[3], ends[4], ends[5]}};
}

/// Warns if masses scale with the cube of the radius; undecidable if all radii are equal.
void warn_of_spheres(LAMMPS& engine, const std::string& style) {
  constexpr double clear = 1e-3, rounding = 1e-6;
  for (int type = 1; type <= engine.atom->ntypes; ++type) {
    const Spread spread = spread_of(engine, type);
    if (!(spread.relative(0) > clear && spread.relative(1) > rounding && spread.relative(2) < rounding))
      continue;
    return warn(engine, style + ": the masses of type " + std::to_string(type) +
                            " scale with the cube of the radius, like those of spheres; expected m = rho h "
                            "pi a^2, with an areal density by '" +
                            set_density + "'");
  }
}

/// LAMMPS' fix pour gives spheres, whatever the dimension.
void warn_of_poured_spheres(LAMMPS& engine) {
  // Once, not in each piece of `run N every M`.
  if (engine.atom->natoms > 0 && engine.update->ntimestep > 0) return;
  for (const Fix* fix : fixes(*engine.modify))
    if (std::strcmp(fix->style, "pour") == 0)
      warn(engine, std::string("fix ") + fix->id +
                       " (pour) inserts discs with the masses of spheres; expected m = rho h pi a^2, by 'run "
                       "N every M \"" +
                       set_density + "\"', which sets the masses of discs inserted since");
}

/// Above that of metals for discs as high as 100 radii: a density of a volume in place of one of an area.
void warn_of_density(LAMMPS& engine, const std::string& style) {
  constexpr double metals = 20000, highest = 5;  // kg/m^3, diameters
  if (std::strcmp(engine.update->unit_style, "si") != 0) return;
  const Atom& atom = *engine.atom;
  const int disc = first_disc(engine, [&](int i) {
    const double radius = atom.radius[i], area = std::numbers::pi * radius * radius;
    return atom.rmass[i] > metals * area * 2 * radius * highest;
  });
  if (disc != none)
    warn(engine, style + ": disc " + std::to_string(disc) +
                     " is heavier than a metal disc five diameters thick (a long rod, or a density in "
                     "kg/m^3? discs have an areal density, rho h in kg/m^2)");
}

}  // namespace

void check_discs(LAMMPS& engine, const std::string& style, bool with_springs) {
  check_positive(engine, style, "radius", engine.atom->radius);
  check_positive(engine, style, "mass", engine.atom->rmass);
  check_box_width(engine, style, with_springs);
  check_integrators(engine, style);
  warn_of_integrators(engine, style);
  warn_of_spheres(engine, style);
  warn_of_poured_spheres(engine);
  warn_of_density(engine, style);
}

}  // namespace mikromakro::styles
