// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/registration.h"

#include <dlfcn.h>

#include "engine/engine_access.h"
#include "lammps.h"
#include "law/law_names.h"
#include "mikromakro_version.h"
#include "motion/fix_bottom_friction.h"
#include "motion/fix_nve_disc.h"
#include "output/compute_contact_disc.h"
#include "output/fix_ave_micromacro.h"
#include "output/fix_energy_disc.h"
#include "output/fix_snapshot_disc.h"
#include "placement/create_discs.h"
#include "walls/biaxial/fix_biaxial_2d.h"
#include "walls/couette/create_ring.h"
#include "walls/couette/fix_couette_2d.h"
#include "walls/fix_wall_disc.h"

namespace mikromakro::styles {
const std::map<std::string, FixCreator> disc_fixes = {
    {"ave/micromacro", make_fix<FixAveMicromacro>},   {"biaxial/2d", make_fix<FixBiaxial2d>},
    {"bottom/friction", make_fix<FixBottomFriction>}, {"couette/2d", make_fix<FixCouette2d>},
    {"energy/disc", make_fix<FixEnergyDisc>},         {"nve/disc", make_fix<FixNveDisc>},
    {"snapshot/disc", make_fix<FixSnapshotDisc>},     {"wall/disc", make_fix<FixWallDisc>}};
const std::map<std::string, ComputeCreator> disc_computes = {
    {"contact/disc", make_compute<ComputeContactDisc>}};
const std::map<std::string, CommandCreator> disc_commands = {{"create_discs", run_command<CreateDiscs>},
                                                             {"create_ring", run_command<CreateRing>}};

namespace {

template <class Creator>
void append_names(std::string& text, const char* kind, const std::map<std::string, Creator>& styles) {
  text += std::string("* ") + kind + ":";
  for (const auto& [name, creator] : styles) text += " " + name;
  text += "\n";
}

}  // namespace

void register_styles(LAMMPS_NS::LAMMPS& engine) {
  register_disc_laws(engine);
  for (const auto& [name, creator] : disc_fixes) fix_styles(*engine.modify)[name] = creator;
  for (const auto& [name, creator] : disc_computes) compute_styles(*engine.modify)[name] = creator;
  for (const auto& [name, creator] : disc_commands) command_styles(*engine.input)[name] = creator;
}

std::string version_line() {
  return std::string("mikromakro " MIKROMAKRO_VERSION ": disc styles for ") + engine_family;
}

std::string style_list() {
  std::string text = "\nStyles of mikromakro\n\n";
  const auto listed = [](const std::vector<std::string>& names) {
    std::string all;
    for (const auto& name : names) all += " " + name;
    return all;
  };
  text += std::string("* ") + law_styles[0] + listed(normal_names()) + ", " + law_styles[1] +
          listed(tangential_names()) + "\n";
  append_names(text, "Fix styles", disc_fixes);
  append_names(text, "Compute styles", disc_computes);
  append_names(text, "Commands", disc_commands);
  return text;
}

}  // namespace mikromakro::styles

// The engine calls post_create() at the end of its construction and of every `clear`, through the dynamic
// symbol table: this definition comes first, calls the engine's own and then registers, so that our styles
// survive `clear`.
void LAMMPS_NS::LAMMPS::post_create() {
  using PostCreate = void (*)(LAMMPS_NS::LAMMPS*);
  static const auto engines_own =
      reinterpret_cast<PostCreate>(dlsym(RTLD_NEXT, "_ZN9LAMMPS_NS6LAMMPS11post_createEv"));
  if (engines_own) engines_own(this);
  mikromakro::styles::register_styles(*this);
}
