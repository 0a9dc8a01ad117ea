// SPDX-License-Identifier: GPL-2.0-or-later
#include "walls/couette/create_ring.h"

#include <cmath>
#include <numbers>

#include "atom.h"
#include "engine/arguments.h"
#include "engine/first_rank.h"
#include "physics/motion/ring_motion.h"
#include "physics/placement/disc_region.h"
#include "physics/walls/ring_load.h"
#include "placement/disc_insertion.h"

namespace mikromakro::styles {
namespace {

const std::string style = "create_ring";
constexpr long most_discs = 100000000;

struct RingRequest {
  physics::PlaneVector centre;
  double ring_radius = 0.0;
  double pitch = 0.0;
  long number = 0;
  int type = 0;
  double disc_radius = 0.0;
  double areal_density = 0.0;
  double phase = 0.0;
};

RingRequest parse(Arguments& arguments, int number_of_types) {
  RingRequest ring;
  ring.centre.x = arguments.number("X");
  ring.centre.y = arguments.number("Y");
  ring.ring_radius = arguments.positive("R");
  while (arguments.more()) {
    if (arguments.take_once("pitch"))
      ring.pitch = arguments.positive("pitch");
    else if (arguments.take_once("number"))
      ring.number = arguments.integer("number", 1, most_discs);
    else if (arguments.take_once("type"))
      ring.type = static_cast<int>(arguments.integer("type", 1, number_of_types));
    else if (arguments.take_once("radius"))
      ring.disc_radius = arguments.positive("radius");
    else if (arguments.take_once("density"))
      ring.areal_density = arguments.positive("density");
    else if (arguments.take_once("phase"))
      ring.phase = arguments.number("phase");
    else
      arguments.unexpected("pitch, number, type, radius, density or phase");
  }
  if ((ring.pitch > 0.0) == (ring.number > 0)) arguments.fail("expected either 'pitch P' or 'number N'");
  if (ring.type == 0) arguments.fail("expected 'type T'");
  if (ring.disc_radius == 0.0) arguments.fail("expected 'radius A'");
  if (ring.areal_density == 0.0) arguments.fail("expected 'density RHO'");
  if (ring.pitch > 0.0) {
    ring.number = physics::ring_count(ring.ring_radius, ring.pitch);
    if (ring.number < 1 || ring.number > most_discs)
      arguments.fail("pitch: expected a length that fits the circumference, got " + text_of(ring.pitch));
  }
  return ring;
}

std::vector<NewDisc> discs_of(const RingRequest& ring) {
  std::vector<NewDisc> discs;
  for (long k = 0; k < ring.number; ++k) {
    const double angle = ring.phase + 2.0 * std::numbers::pi * static_cast<double>(k) / ring.number;
    const physics::PlacedDisc place{ring.centre.x + ring.ring_radius * std::cos(angle),
                                    ring.centre.y + ring.ring_radius * std::sin(angle), ring.disc_radius};
    discs.push_back({place, ring.type, {}});
  }
  return discs;
}

/// Warns if existing discs overlap the ring; checks each against the nearest wall disc.
void warn_of_overlaps(LAMMPS_NS::LAMMPS& engine, const RingRequest& ring) {
  const double step = 2.0 * std::numbers::pi / ring.number;
  long overlapping = 0;
  for (const physics::PlacedDisc& disc : existing_discs(engine)) {
    const double x = disc.x - ring.centre.x, y = disc.y - ring.centre.y;
    const double nearest = ring.phase + step * std::round((std::atan2(y, x) - ring.phase) / step);
    const double distance =
        std::hypot(x - ring.ring_radius * std::cos(nearest), y - ring.ring_radius * std::sin(nearest));
    if (distance < (1 - 1e-9) * (disc.radius + ring.disc_radius)) ++overlapping;
  }
  if (overlapping > 0)
    warn(engine, style + ": " + std::to_string(overlapping) +
                     " existing discs overlap discs of the ring; expected the ring first, then create_discs, "
                     "which keeps clear of it");
}

}  // namespace

void CreateRing::command(int narg, char** arg) {
  check_ready_for_discs(*lmp, style);
  Arguments arguments(*lmp, style, narg, arg);
  const RingRequest ring = parse(arguments, atom->ntypes);
  const physics::Annulus outline{ring.centre.x, ring.centre.y, 0.0, ring.ring_radius + ring.disc_radius};
  check_inside_box(*lmp, style, "the ring", outline.bounds());
  warn_of_overlaps(*lmp, ring);
  insert_discs(*lmp, style, discs_of(ring), ring.areal_density);
  const double pitch = 2.0 * std::numbers::pi * ring.ring_radius / ring.number;
  say(*lmp, "create_ring: " + std::to_string(ring.number) + " discs of radius " + text_of(ring.disc_radius) +
                " on a circle of radius " + text_of(ring.ring_radius) + ", pitch " + text_of(pitch));
}

}  // namespace mikromakro::styles
