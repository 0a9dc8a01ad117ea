// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/unseen_forces.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <string_view>

#include "compute.h"
#include "engine/engine_lists.h"
#include "engine/first_rank.h"
#include "fix.h"
#include "force.h"
#include "lammps.h"
#include "law/contact_rows.h"
#include "law/contact_schedule.h"
#include "modify.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;

namespace {

/// Fixes that exert body forces, or no force.
constexpr std::array<std::string_view, 25> body_forces = {"accelerate/cos",
                                                          "addforce",
                                                          "aveforce",
                                                          "bottom/friction",
                                                          "buoyancy",
                                                          "drag",
                                                          "efield",
                                                          "enforce2d",
                                                          "freeze",
                                                          "gravity",
                                                          "group",
                                                          "heat/gran",
                                                          "langevin",
                                                          "lineforce",
                                                          "heat/gran/conduction",
                                                          "massflow/mesh",
                                                          "massflow/mesh/sieve",
                                                          "nve/disc",
                                                          "planeforce",
                                                          "setforce",
                                                          "spring",
                                                          "spring/chunk",
                                                          "spring/self",
                                                          "store/force",
                                                          "viscous"};

bool pushes_discs_unseen(const Fix& fix, int mask) {
  if ((mask & (FixConst::POST_FORCE | FixConst::POST_INTEGRATE)) == 0) return false;
  if (dynamic_cast<const WallContactSource*>(&fix)) return false;
  return std::find(body_forces.begin(), body_forces.end(), fix.style) == body_forces.end();
}

void append(std::string& list, const std::string& name) {
  list += (list.empty() ? "" : ", ") + name;
}

std::string unseen_forces(const LAMMPS& engine) {
  std::string names;
  const Modify& modify = *engine.modify;
  for (Fix* fix : fixes(modify))
    if (pushes_discs_unseen(*fix, mask_of(modify, fix)))
      append(names, std::string("fix ") + fix->id + " (" + fix->style + ")");
  if (engine.force->bond) append(names, std::string("bond_style ") + engine.force->bond_style);
  return names;
}

std::string outputs_of_contacts(const Modify& modify) {
  std::string names;
  for (const Compute* compute : computes(modify))
    if (std::strcmp(compute->style, "contact/disc") == 0)
      append(names, std::string("compute ") + compute->id + " (contact/disc)");
  for (const Fix* fix : fixes(modify))
    if (dynamic_cast<const ContactObserver*>(fix))
      append(names, std::string("fix ") + fix->id + " (" + fix->style + ")");
  return names;
}

}  // namespace

void warn_of_unseen_forces(LAMMPS& engine) {
  const std::string forces = unseen_forces(engine), outputs = outputs_of_contacts(*engine.modify);
  if (forces.empty() || outputs.empty()) return;
  warn(engine, forces + ": forces on discs that " + outputs +
                   " will not include: they are missing from contacts, stress and the energy balance; a "
                   "smooth wall that is included is 'fix ID group wall/disc'");
}

}  // namespace mikromakro::styles
