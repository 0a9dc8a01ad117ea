// SPDX-License-Identifier: GPL-2.0-or-later
// Layout of our HDF5 snapshots: H5MD 1.1 (https://nongnu.org/h5md/h5md.html) for the particles, plus
// contacts.
#pragma once

#include <string>
#include <string_view>

#include "model/columns.h"

namespace mikromakro::snapshot {

/// /particles/discs/<name>/{step, time, value}. H5MD requires one particle number N for all frames; if the
/// number varies, unused places have the id no_id.
inline const std::string discs = "/particles/discs/";
inline constexpr std::int64_t no_id = -1;

/// Complements H5MD's strings in the attribute `boundary`: 1 or 0 per axis. HDF5 stores variable-length
/// strings without a checksum, and damage there can make it loop forever, so no average relies on them.
inline const std::string box = "/particles/discs/box";
inline std::string corner_path(const std::string& name) {
  return box + "/" + name + "/value";
}  // low, edges
inline const std::string periodic = "periodic";

/// A quantity of a disc and the columns that it holds, one or two numbers per disc.
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

/// /contacts/<column>: rows of all frames concatenated, named as in `compute contact/disc`; frame i has rows
/// offset[i] to offset[i + 1]; /contacts/step.
inline const std::string contacts = "/contacts/";
inline constexpr std::string_view contact_units[] = {"",  "",  "m", "m", "m",     "m",     "", "",  "m", "N",
                                                     "N", "N", "N", "m", "m s-1", "m s-1", "", "m", "m", "m"};
inline bool whole(ContactColumn column) {
  return column == ContactColumn::id1 || column == ContactColumn::id2 || column == ContactColumn::periodic;
}

inline std::string contact_path(std::size_t slot) {
  return contacts + std::string(contact_column_names[slot]);
}

/// For runs only. /walls/<name>/{step, time, value}: the numbers of a fix, frame by frame; the attribute
/// `style` of /walls/<name> defines them, the attribute `names` of /walls lists the walls.
inline const std::string walls = "/walls/";

/// For runs only. Constants: strings as attributes, numbers as datasets.
inline const std::string parameters = "/parameters";
/// Attributes of it that averages rely on: the effects of the law and of walls in words; the walls, if any,
/// whose contacts are not in the rows.
inline const std::string law = "law";
inline const std::string unrecorded_walls = "unrecorded_walls";

/// A run killed while writing a frame may leave rows behind: a frame exists only if it has a step, and rows
/// not yet written have the step no_id.

}  // namespace mikromakro::snapshot
