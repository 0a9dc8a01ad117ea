// SPDX-License-Identifier: GPL-2.0-or-later
#include "placement/create_discs.h"

#include <limits>
#include <numbers>

#include "atom.h"
#include "engine/arguments.h"
#include "physics/placement/random_placement.h"
#include "placement/disc_insertion.h"

namespace mikromakro::styles {
namespace {

const std::string style = "create_discs";
constexpr long most_discs = 100000000;

struct Filling {
  long number = 0;
  int type = 1;
  double smallest = 0.0;  // radius (m)
  double largest = 0.0;
};

struct FillRequest {
  physics::DiscRegion region;
  std::vector<Filling> fillings;
  long seed = 0;
  double areal_density = 0.0;
  double largest_velocity = 0.0;
  double gap = 0.0;
};

physics::DiscRegion parse_region(Arguments& arguments) {
  if (arguments.take("ring")) {
    physics::Annulus ring;
    ring.x = arguments.number("X");
    ring.y = arguments.number("Y");
    ring.r_inner = arguments.not_negative("R1");
    ring.r_outer = arguments.positive("R2");
    if (ring.r_inner >= ring.r_outer) arguments.fail("ring: expected R1 < R2");
    return ring;
  }
  if (arguments.take("box")) {
    physics::Rectangle box;
    box.x_min = arguments.number("XLO");
    box.x_max = arguments.number("XHI");
    box.y_min = arguments.number("YLO");
    box.y_max = arguments.number("YHI");
    if (box.x_min >= box.x_max || box.y_min >= box.y_max)
      arguments.fail("box: expected XLO < XHI and YLO < YHI");
    return box;
  }
  arguments.unexpected("ring or box");
}

Filling parse_filling(Arguments& arguments, bool uniform, int number_of_types) {
  Filling filling;
  filling.number = arguments.integer("number of discs", 1, most_discs);
  filling.type = static_cast<int>(arguments.integer("type", 1, number_of_types));
  filling.smallest = arguments.positive(uniform ? "RMIN" : "RADIUS");
  filling.largest = uniform ? arguments.positive("RMAX") : filling.smallest;
  if (filling.smallest > filling.largest) arguments.fail("uniform: expected RMIN <= RMAX");
  return filling;
}

FillRequest parse(Arguments& arguments, int number_of_types) {
  FillRequest request;
  request.region = parse_region(arguments);
  bool seeded = false;
  while (arguments.more()) {
    if (arguments.take_once("seed")) {
      request.seed = arguments.integer("seed", 0, std::numeric_limits<long>::max());
      seeded = true;
    } else if (arguments.take_once("density")) {
      request.areal_density = arguments.positive("density");
    } else if (arguments.take("discs")) {
      request.fillings.push_back(parse_filling(arguments, false, number_of_types));
    } else if (arguments.take("uniform")) {
      request.fillings.push_back(parse_filling(arguments, true, number_of_types));
    } else if (arguments.take_once("velocity")) {
      request.largest_velocity = arguments.not_negative("velocity");
    } else if (arguments.take_once("gap")) {
      request.gap = arguments.not_negative("gap");
    } else {
      arguments.unexpected("seed, density, discs, uniform, velocity or gap");
    }
  }
  if (!seeded) arguments.fail("expected 'seed S'");
  if (request.areal_density == 0.0) arguments.fail("expected 'density RHO'");
  if (request.fillings.empty())
    arguments.fail("expected 'discs N TYPE RADIUS' or 'uniform N TYPE RMIN RMAX'");
  return request;
}

std::vector<double> draw_radii(const FillRequest& request, physics::UniformNumbers& uniform) {
  std::vector<double> radii;
  for (const Filling& filling : request.fillings) {
    for (long k = 0; k < filling.number; ++k) {
      const bool one_radius = filling.smallest == filling.largest;
      radii.push_back(one_radius ? filling.smallest : uniform(filling.smallest, filling.largest));
    }
  }
  return radii;
}

double solid_fraction(const FillRequest& request, const std::vector<double>& radii) {
  double area = 0.0;
  for (const double radius : radii) area += std::numbers::pi * radius * radius;
  return area / physics::area_of(request.region);
}

void check_can_be_placed(const Arguments& arguments, const FillRequest& request,
                         const std::vector<double>& radii) {
  const double fraction = solid_fraction(request, radii);
  if (fraction > physics::placement_limit)
    arguments.fail("expected a solid fraction up to " + text_of(physics::placement_limit) +
                   ", above which random placement fails, got " + text_of(fraction) +
                   "; start in a larger region and compress");
  for (const Filling& filling : request.fillings) {
    if (!physics::can_hold_disc(request.region, filling.largest + request.gap))
      arguments.fail("expected discs that fit into the region, got radius " + text_of(filling.largest));
  }
}

std::vector<physics::PlacedDisc> place(LAMMPS_NS::LAMMPS& engine, const Arguments& arguments,
                                       const FillRequest& request, const std::vector<double>& radii,
                                       physics::UniformNumbers& uniform) {
  // Determined identically on every rank, so that all stop together.
  std::string fault;
  try {
    return physics::place_discs(request.region, radii, request.gap, existing_discs(engine), uniform);
  } catch (const std::runtime_error& error) {
    fault = error.what();
  }
  arguments.fail(fault + " at a solid fraction of " + text_of(solid_fraction(request, radii)) +
                 "; use a larger region and compress");
}

}  // namespace
void CreateDiscs::command(int narg, char** arg) {
  check_ready_for_discs(*lmp, style);
  Arguments arguments(*lmp, style, narg, arg);
  const FillRequest request = parse(arguments, atom->ntypes);
  check_inside_box(*lmp, style, "the region", physics::bounds_of(request.region));

  physics::UniformNumbers uniform(static_cast<std::uint64_t>(request.seed));
  const std::vector<double> radii = draw_radii(request, uniform);
  check_can_be_placed(arguments, request, radii);
  const std::vector<physics::PlacedDisc> places = place(*lmp, arguments, request, radii, uniform);

  std::vector<NewDisc> discs;
  for (const Filling& filling : request.fillings) {
    for (long k = 0; k < filling.number; ++k)
      discs.push_back(
          {places[discs.size()], filling.type, physics::random_velocity(request.largest_velocity, uniform)});
  }
  insert_discs(*lmp, style, discs, request.areal_density);
  say(*lmp, "create_discs: " + std::to_string(discs.size()) + " discs, solid fraction " +
                text_of(solid_fraction(request, radii)));
}

}  // namespace mikromakro::styles
