// SPDX-License-Identifier: GPL-2.0-or-later
#include "walls/walls_of_restart.h"

#include <utility>

#include "engine/first_rank.h"
#include "lammps.h"
#include "modify.h"

namespace mikromakro::styles {

using LAMMPS_NS::Modify;

namespace {

// Access to private members: see engine_access.cpp.
template <class Tag, typename Tag::Type Member>
struct Grant {
  friend typename Tag::Type member(Tag /*tag*/) { return Member; }
};
struct SavedIds {
  using Type = char** Modify::*;
  friend Type member(SavedIds);
};
struct SavedStyles {
  using Type = char** Modify::*;
  friend Type member(SavedStyles);
};
template struct Grant<SavedIds, &Modify::id_restart_global>;
template struct Grant<SavedStyles, &Modify::style_restart_global>;

}  // namespace

WallsOfRestart::WallsOfRestart(const LAMMPS_NS::LAMMPS& engine, std::string style)
    : style_(std::move(style)) {
  const Modify& modify = *engine.modify;
  for (int k = 0; k < modify.nfix_restart_global; ++k)
    if (style_ == (modify.*member(SavedStyles{}))[k]) names_.emplace_back((modify.*member(SavedIds{}))[k]);
}

void WallsOfRestart::warn_of_unclaimed(LAMMPS_NS::LAMMPS& engine) {
  for (const std::string& name : names_)
    if (engine.modify->find_fix(name.c_str()) < 0)
      print_line(engine,
                 "WARNING: " + style_ + ": the restart file holds the walls of fix " + name +
                     ", which the script does not define: where they stood, and their springs, are left out");
  names_.clear();
}

}  // namespace mikromakro::styles
