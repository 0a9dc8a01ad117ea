// SPDX-License-Identifier: GPL-2.0-or-later
#include "walls/couette/couette_settings.h"

#include "atom.h"
#include "group.h"
#include "lammps.h"

namespace mikromakro::styles {
namespace {

// A radius of zero, which no keyword accepts, means not given.
struct Given {
  bool centre = false;
  bool rotation = false;
  double outer_end = 0.0;
  double compaction_time = 0.0;
};

void parse_ring(LAMMPS_NS::LAMMPS& engine, Arguments& arguments, const std::string& side, Ring& ring) {
  if (arguments.take("smooth")) {
    ring.type = static_cast<int>(arguments.integer(side + " smooth TYPE", 1, engine.atom->ntypes));
    ring.motion.course.start = arguments.positive(side + " smooth radius");
    return;
  }
  if (!arguments.take("rough")) arguments.unexpected("'rough' or 'smooth' after '" + side + "'");
  ring.group = arguments.word(side + " rough GROUP");
  const int group = engine.group->find(ring.group.c_str());
  if (group < 0) arguments.fail(side + " rough: expected the name of a group, got '" + ring.group + "'");
  ring.group_bit = engine.group->bitmask[group];
  ring.motion.course.start = arguments.positive(side + " rough radius");
}

void parse_keyword(LAMMPS_NS::LAMMPS& engine, Arguments& arguments, CouetteSettings& settings, Given& given) {
  auto& [inner, outer] = settings.rings;
  if (arguments.take_once("center")) {
    settings.centre.x = arguments.number("center X");
    settings.centre.y = arguments.number("center Y");
    given.centre = true;
  } else if (arguments.take_once("inner")) {
    parse_ring(engine, arguments, "inner", inner);
  } else if (arguments.take_once("outer")) {
    parse_ring(engine, arguments, "outer", outer);
  } else if (arguments.take_once("omega_inner")) {
    inner.motion.rotation_rate = arguments.number("omega_inner");
    given.rotation = true;
  } else if (arguments.take_once("omega_outer")) {
    outer.motion.rotation_rate = arguments.number("omega_outer");
  } else if (arguments.take_once("compact")) {
    given.outer_end = arguments.positive("compact R_END");
    given.compaction_time = arguments.positive("compact TIME");
  } else if (arguments.take_once("height")) {
    settings.height = arguments.positive("height");
  } else {
    arguments.unexpected("center, inner, outer, omega_inner, omega_outer, compact or height");
  }
}

void check(const Arguments& arguments, const CouetteSettings& settings, const Given& given) {
  const auto& [inner, outer] = settings.rings;
  if (!given.centre) arguments.fail("expected 'center X Y'");
  if (inner.group.empty() && !inner.smooth())
    arguments.fail("expected 'inner rough GROUP R_I' or 'inner smooth TYPE R_I'");
  if (outer.group.empty() && !outer.smooth())
    arguments.fail("expected 'outer rough GROUP R_O' or 'outer smooth TYPE R_O'");
  if (!given.rotation) arguments.fail("expected 'omega_inner W'");
  const double inner_radius = inner.motion.course.start;
  const physics::RadiusCourse& course = outer.motion.course;
  if (inner_radius >= course.start)
    arguments.fail((outer.smooth() ? "outer smooth" : "outer rough") +
                   std::string(": expected a radius above the inner ring's ") + text_of(inner_radius) +
                   ", got " + text_of(course.start));
  if (inner_radius >= course.end)
    arguments.fail("compact: expected R_END above the inner ring's radius " + text_of(inner_radius) +
                   ", got " + text_of(course.end));
}

}  // namespace

CouetteSettings parse_couette(LAMMPS_NS::LAMMPS& engine, Arguments& arguments) {
  CouetteSettings settings;
  Given given;
  while (arguments.more()) parse_keyword(engine, arguments, settings, given);
  auto& inner = settings.rings[0].motion.course;
  auto& outer = settings.rings[1].motion.course;
  inner.end = inner.start;
  outer.end = given.compaction_time > 0.0 ? given.outer_end : outer.start;
  outer.duration = given.compaction_time;
  check(arguments, settings, given);
  return settings;
}

}  // namespace mikromakro::styles
