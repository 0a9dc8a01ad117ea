// SPDX-License-Identifier: GPL-2.0-or-later
// Where our HDF5 snapshots hold what: H5MD 1.1 (https://nongnu.org/h5md/h5md.html) for the particles,
// contacts beside it.
#pragma once

#include <string>
#include <string_view>

#include "model/columns.h"

namespace mikromakro::snapshot {

/// /particles/discs/<name>/{step, time, value}; H5MD wants one number N of particles for all frames, and lets
/// places stay empty where it changes: the id there is no_id.
inline const std::string discs = "/particles/discs/";
inline constexpr std::int64_t no_id = -1;

/// Beside H5MD's words in the attribute `boundary`: 1 or 0 per axis. HDF5 puts words of any length where no
/// sum protects them, and may go round for ever where that is damaged; so no average needs them.
inline const std::string box = "/particles/discs/box";
inline std::string corner_path(const std::string& name) {
  return box + "/" + name + "/value";
}  // low, edges
inline const std::string periodic = "periodic";

/// One of the quantities of a disc and the columns that it holds, one or two numbers per disc.
struct Element {
  std::string_view name;
  std::string_view unit;
  ParticleColumn first;
  int width;

  ColumnSet columns() const {
    const ColumnSet bit = column_bit(first);
    return width == 2 ? bit | bit << 1U : bit;
  }
  bool whole() const { return first == ParticleColumn::id || first == ParticleColumn::type; }
};
inline constexpr Element elements[] = {{"id", "", ParticleColumn::id, 1},
                                       {"species", "", ParticleColumn::type, 1},
                                       {"position", "m", ParticleColumn::x, 2},
                                       {"radius", "m", ParticleColumn::radius, 1},
                                       {"velocity", "m s-1", ParticleColumn::vx, 2},
                                       {"spin", "rad s-1", ParticleColumn::omegaz, 1},
                                       {"mass", "kg", ParticleColumn::mass, 1}};

inline std::string value_path(const Element& element) {
  return discs + std::string(element.name) + "/value";
}

/// /contacts/<column>: rows of all frames one after the other, by the names of `compute contact/disc`; those
/// of frame i are offset[i] to offset[i + 1]; /contacts/step.
inline const std::string contacts = "/contacts/";
inline constexpr std::string_view contact_units[] = {"",  "",  "m", "m", "m",     "m",     "", "",  "m", "N",
                                                     "N", "N", "N", "m", "m s-1", "m s-1", "", "m", "m", "m"};
inline bool whole(ContactColumn column) {
  return column == ContactColumn::id1 || column == ContactColumn::id2 || column == ContactColumn::periodic;
}

inline std::string contact_path(std::size_t slot) {
  return contacts + std::string(contact_column_names[slot]);
}

/// Of runs only. /walls/<name>/{step, time, value}: numbers of a fix, frame by frame; attribute `style` of
/// /walls/<name> tells which, attribute `names` of /walls lists the walls.
inline const std::string walls = "/walls/";

/// Of runs only. What does not change: words as attributes, numbers as datasets.
inline const std::string parameters = "/parameters";

/// A frame that was being written when its run was killed may have left rows behind: those frames are there
/// that have a step, and a row that has got no number yet has the step no_id.

}  // namespace mikromakro::snapshot
