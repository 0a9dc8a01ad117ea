#include "registration.h"

#include <dlfcn.h>
#include <mpi.h>

#include "compute_contact_disc.h"
#include "create_discs.h"
#include "create_ring.h"
#include "fix_ave_micromacro.h"
#include "fix_biaxial_2d.h"
#include "fix_bottom_friction.h"
#include "fix_couette_2d.h"
#include "fix_energy_disc.h"
#include "fix_nve_disc.h"
#include "fix_snapshot_disc.h"
#include "lammps.h"
#include "mikromakro_version.h"
#include "pair_gran_disc.h"
#include "style_maps.h"

namespace mikromakro::liggghts {
namespace {

template <class T>
LAMMPS_NS::Fix* make_fix(LAMMPS_NS::LAMMPS* engine, int narg, char** arg) {
  return new T(engine, narg, arg);
}

template <class T>
LAMMPS_NS::Compute* make_compute(LAMMPS_NS::LAMMPS* engine, int iarg, int narg, char** arg) {
  return new T(engine, iarg, narg, arg);
}

template <class T>
void run_command(LAMMPS_NS::LAMMPS* engine, int narg, char** arg) {
  T(engine).command(narg, arg);
}

const std::map<std::string, FixCreator> fixes = {
    {"ave/micromacro", make_fix<FixAveMicromacro>},   {"biaxial/2d", make_fix<FixBiaxial2d>},
    {"bottom/friction", make_fix<FixBottomFriction>}, {"couette/2d", make_fix<FixCouette2d>},
    {"energy/disc", make_fix<FixEnergyDisc>},         {"nve/disc", make_fix<FixNveDisc>},
    {"snapshot/disc", make_fix<FixSnapshotDisc>}};
const std::map<std::string, ComputeCreator> computes = {{"contact/disc", make_compute<ComputeContactDisc>}};
const std::map<std::string, CommandCreator> commands = {{"create_discs", run_command<CreateDiscs>},
                                                        {"create_ring", run_command<CreateRing>}};

template <class Creator>
void append_names(std::string& text, const char* kind, const std::map<std::string, Creator>& styles) {
  text += std::string("* ") + kind + ":";
  for (const auto& [name, creator] : styles) text += " " + name;
  text += "\n";
}

}  // namespace

void register_styles(LAMMPS_NS::LAMMPS& engine) {
  register_disc_laws();
  for (const auto& [name, creator] : fixes) fix_styles(*engine.modify)[name] = creator;
  for (const auto& [name, creator] : computes) compute_styles(*engine.modify)[name] = creator;
  for (const auto& [name, creator] : commands) command_styles(*engine.input)[name] = creator;
}

const char* version_line() {
  return "mikromakro " MIKROMAKRO_VERSION ": disc styles for LIGGGHTS";
}

std::string style_list() {
  std::string text = "\nStyles of mikromakro\n\n";
  text +=
      "* Pair style gran: model disc/linear disc/hertz, tangential off disc/viscous disc/cundall_strack\n";
  append_names(text, "Fix styles", fixes);
  append_names(text, "Compute styles", computes);
  append_names(text, "Commands", commands);
  return text;
}

}  // namespace mikromakro::liggghts

// The engine calls post_create() at the end of its construction and of every `clear`, through the dynamic
// symbol table: this definition comes first, calls the engine's own and then registers, so that our styles
// survive `clear`.
void LAMMPS_NS::LAMMPS::post_create() {
  using PostCreate = void (*)(LAMMPS_NS::LAMMPS*);
  static const auto engines_own =
      reinterpret_cast<PostCreate>(dlsym(RTLD_NEXT, "_ZN9LAMMPS_NS6LAMMPS11post_createEv"));
  if (engines_own) engines_own(this);
  mikromakro::liggghts::register_styles(*this);
}
