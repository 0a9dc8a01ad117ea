// SPDX-License-Identifier: GPL-2.0-or-later
#include "walls/walls_of_restart.h"

#include <algorithm>
#include <utility>

#include "engine/engine_lists.h"
#include "engine/first_rank.h"
#include "engine/private_member.h"
#include "fix.h"
#include "lammps.h"
#include "modify.h"

namespace mikromakro::styles {

using LAMMPS_NS::Modify;

struct SavedIds {
  friend auto member(SavedIds);
};
struct SavedStyles {
  friend auto member(SavedStyles);
};

template struct PrivateMember<SavedIds, &Modify::id_restart_global>;
template struct PrivateMember<SavedStyles, &Modify::style_restart_global>;

WallsOfRestart::WallsOfRestart(const LAMMPS_NS::LAMMPS& engine, std::string style)
    : style_(std::move(style)) {
  const Modify& modify = *engine.modify;
  for (int k = 0; k < modify.nfix_restart_global; ++k)
    if (style_ == (modify.*member(SavedStyles{}))[k]) names_.emplace_back((modify.*member(SavedIds{}))[k]);
}

void WallsOfRestart::warn_of_unclaimed(LAMMPS_NS::LAMMPS& engine) {
  const auto defined = fixes(*engine.modify);
  for (const std::string& name : names_)
    if (std::none_of(defined.begin(), defined.end(), [&](const auto* fix) { return name == fix->id; }))
      print_line(engine, "WARNING: " + style_ + ": the restart file holds the walls of fix " + name +
                             ", which the script does not define: their positions and springs are discarded");
  names_.clear();
}

}  // namespace mikromakro::styles
