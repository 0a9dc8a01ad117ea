// SPDX-License-Identifier: GPL-2.0-or-later
#include "walls/wall_disc_settings.h"

#include <cmath>

#include "atom.h"
#include "lammps.h"

namespace mikromakro::styles {
namespace {

using physics::SmoothWall;
using physics::WallShape;

void parse_plane(Arguments& arguments, SmoothWall& wall) {
  const double x = arguments.number("plane NX"), y = arguments.number("plane NY");
  const double offset = arguments.number("plane OFFSET"), length = std::hypot(x, y);
  if (length == 0) arguments.fail("plane: expected a normal NX NY that is not 0 0");
  wall.shape = WallShape::flat;
  wall.point = {offset * x / length, offset * y / length};
  wall.outward = {-x / length, -y / length};
}

void parse_circle(Arguments& arguments, SmoothWall& wall) {
  wall.point.x = arguments.number("circle X");
  wall.point.y = arguments.number("circle Y");
  wall.radius = arguments.positive("circle R");
  if (arguments.take("inside")) {
    wall.shape = WallShape::circle_around;
  } else if (arguments.take("outside")) {
    wall.shape = WallShape::circle_within;
  } else {
    arguments.unexpected("inside or outside after 'circle X Y R', where the discs are");
  }
}

void parse_velocity(Arguments& arguments, SmoothWall& wall) {
  bool any = false;
  while (arguments.more()) {
    if (arguments.take_once("vx")) {
      wall.velocity.x = arguments.number("move vx");
    } else if (arguments.take_once("vy")) {
      wall.velocity.y = arguments.number("move vy");
    } else {
      break;
    }
    any = true;
  }
  if (!any) arguments.unexpected("vx or vy after 'move'");
}

}  // namespace

WallDiscSettings parse_wall_disc(LAMMPS_NS::LAMMPS& engine, Arguments& arguments) {
  WallDiscSettings settings;
  SmoothWall& wall = settings.wall;
  bool plane = false, circle = false, rotates = false;
  while (arguments.more()) {
    if (arguments.take_once("type")) {
      settings.type = static_cast<int>(arguments.integer("type", 1, engine.atom->ntypes));
    } else if (arguments.take_once("plane")) {
      plane = true;
      parse_plane(arguments, wall);
    } else if (arguments.take_once("circle")) {
      circle = true;
      parse_circle(arguments, wall);
    } else if (arguments.take_once("move")) {
      parse_velocity(arguments, wall);
    } else if (arguments.take_once("rotate")) {
      rotates = true;
      wall.rotation_rate = arguments.number("rotate");
    } else {
      arguments.unexpected("type, plane, circle, move or rotate");
    }
  }
  if (settings.type == 0) arguments.fail("expected 'type T'");
  if (plane == circle)
    arguments.fail("expected either 'plane NX NY OFFSET' or 'circle X Y R inside/outside'");
  if (plane && rotates)
    arguments.fail("rotate: expected a circle, got a plane, whose surface moves along itself with 'move'");
  return settings;
}

bool same_place(SmoothWall a, const SmoothWall& b) {
  a.velocity = b.velocity;
  a.rotation_rate = b.rotation_rate;
  return a == b;
}

}  // namespace mikromakro::styles
