// SPDX-License-Identifier: GPL-2.0-or-later
#include "walls/biaxial/biaxial_settings.h"

#include <utility>

#include "atom.h"
#include "lammps.h"

namespace mikromakro::styles {
namespace {

using Kind = WallControl::Kind;

int take_side(Arguments& arguments) {
  for (int k = 0; k < 4; ++k) {
    if (arguments.take(biaxial_sides[k])) return k;
  }
  return -1;
}

WallControl parse_strain(Arguments& arguments, const std::string& side) {
  WallControl control;
  if (arguments.take("cosine")) {
    control.kind = Kind::cosine;
    control.target = arguments.number(side + " strain cosine X_END");
    control.duration = arguments.positive(side + " strain cosine TIME");
  } else if (arguments.take("rate")) {
    control.kind = Kind::rate;
    control.target = arguments.number(side + " strain rate V");
  } else {
    arguments.unexpected("'cosine' or 'rate' after '" + side + " ... strain'");
  }
  return control;
}

WallControl parse_stress(Arguments& arguments, const std::string& side) {
  WallControl control;
  control.kind = Kind::stress;
  control.target = arguments.not_negative(side + " stress P");
  if (!arguments.take("mass")) arguments.unexpected("'mass' after '" + side + " ... stress P'");
  control.mass = arguments.positive(side + " mass");
  if (!arguments.take("damping")) arguments.unexpected("'damping' after '" + side + " ... mass M'");
  control.damping = arguments.not_negative(side + " damping");
  return control;
}

WallControl parse_control(Arguments& arguments, const std::string& side) {
  if (arguments.take("fixed")) return {};
  if (arguments.take("strain")) return parse_strain(arguments, side);
  if (arguments.take("stress")) return parse_stress(arguments, side);
  arguments.unexpected("'fixed', 'strain' or 'stress' for the " + side + " wall");
}

void check(const Arguments& arguments, const BiaxialSettings& settings) {
  for (const int low : {0, 2}) {
    const double position = settings.walls[low].position, other = settings.walls[low + 1].position;
    if (!(position < other))
      arguments.fail(biaxial_sides[low + 1] + ": expected a position above the " + biaxial_sides[low] +
                     " wall's " + text_of(position) + ", got " + text_of(other));
  }
  for (int k = 0; k < 4; ++k) {
    if (settings.walls[k].type == 0)
      arguments.fail("expected 'type T' for all walls, got none for the " + biaxial_sides[k] + " wall");
  }
}

}  // namespace

BiaxialSettings parse_biaxial(LAMMPS_NS::LAMMPS& engine, Arguments& arguments) {
  BiaxialSettings settings;
  std::array<bool, 4> given{};
  std::array<bool, 5> typed{};  // type given: for all walls, for each wall
  int side = -1;                // the last wall named
  while (arguments.more()) {
    if (const int named = take_side(arguments); named >= 0) {
      side = named;
      if (given[side]) arguments.fail(biaxial_sides[side] + ": expected each wall once, got it twice");
      given[side] = true;
      settings.walls[side].position = arguments.number(biaxial_sides[side] + " position");
      settings.walls[side].control = parse_control(arguments, biaxial_sides[side]);
    } else if (arguments.take("type")) {
      const int type = static_cast<int>(arguments.integer("type", 1, engine.atom->ntypes));
      if (std::exchange(typed[side + 1], true)) arguments.fail("type: expected it once, got it twice");
      for (int k = 0; k < 4; ++k) {
        if (side < 0 || k == side) settings.walls[k].type = type;
      }
    } else if (arguments.take_once("height")) {
      settings.height = arguments.positive("height");
    } else {
      arguments.unexpected("left, right, bottom, top, type or height");
    }
  }
  for (int k = 0; k < 4; ++k) {
    if (!given[k]) arguments.fail("expected '" + biaxial_sides[k] + " POSITION CONTROL'");
  }
  check(arguments, settings);
  return settings;
}

BiaxialChange parse_biaxial_change(Arguments& arguments) {
  BiaxialChange change;
  while (arguments.more()) {
    if (const int side = take_side(arguments); side >= 0) {
      if (change.controls[side])
        arguments.fail(biaxial_sides[side] + ": expected each wall once, got it twice");
      change.controls[side] = parse_control(arguments, biaxial_sides[side]);
    } else if (arguments.take_once("reset")) {
      change.reset = true;
    } else {
      arguments.unexpected("left, right, bottom, top or reset");
    }
  }
  return change;
}

}  // namespace mikromakro::styles
