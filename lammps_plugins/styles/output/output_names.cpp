// SPDX-License-Identifier: GPL-2.0-or-later
#include "output/output_names.h"

#include <cstring>
#include <filesystem>
#include <system_error>

#include "dump.h"
#include "engine/arguments.h"
#include "engine/engine_lists.h"
#include "fix.h"
#include "lammps.h"
#include "modify.h"
#include "output.h"
#include "update.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;

namespace {

/// The file name of a dump is a protected member.
struct NameOfDump : Dump {
  static std::string of(const Dump& dump) { return dump.*(&NameOfDump::filename); }
};

/// Canonical path: the same for all names of an existing file and all paths to an existing directory.
std::filesystem::path place_of(const std::string& name) {
  std::error_code code;
  const std::filesystem::path place =
      std::filesystem::weakly_canonical(std::filesystem::absolute(name, code), code);
  return code ? std::filesystem::path(name) : place;
}

void check(LAMMPS& engine, const Fix& own, const std::string& other, const std::string& other_name) {
  for (const std::string& name : dynamic_cast<const FileWriter&>(own).output_names())
    if (place_of(name) == place_of(other_name))
      stop(engine, own.style, "file " + name + ": " + other + " writes it too; expected a file for each");
}

}  // namespace

void check_outputs(LAMMPS& engine, const Fix& own) {
  if (std::strcmp(engine.update->unit_style, "si") != 0)
    stop(engine, own.style,
         std::string("its numbers are in SI units; expected 'units si', got '") + engine.update->unit_style +
             "'");
  for (const Fix* fix : fixes(*engine.modify)) {
    const auto* writer = dynamic_cast<const FileWriter*>(fix);
    if (!writer || fix == &own) continue;
    for (const std::string& name : writer->output_names())
      check(engine, own, std::string("fix ") + fix->id + " (" + fix->style + ")", name);
  }
  const Output& output = *engine.output;
  for (int k = 0; k < output.ndump; ++k)
    check(engine, own, std::string("dump ") + output.dump[k]->id, NameOfDump::of(*output.dump[k]));
}

}  // namespace mikromakro::styles
