// SPDX-License-Identifier: GPL-2.0-or-later
// The columns of the dumps of contacts that engines write themselves, by how many there are.
#pragma once

#include <string>
#include <vector>

#include "io/text/dump_reader.h"

namespace mikromakro {

/// What --contact-columns (or, for walls, --wall-contact-columns) says about this dump: `list` itself, unless
/// it is the name of a preset, which becomes the names of all columns.
///
/// liggghts: compute pair/gran/local with its keywords in the order of the compute's output, 25 columns
/// without keywords (22 where the law keeps no spring), 12 for `pos id force`, 15 with `history`, 16 with
/// `history delta`, 13 with `delta`, 6 for `id force`; of walls, compute wall/gran/local with the same ones.
/// lammps: compute property/local patom1 patom2, then compute pair/local dist fx fy, or dist force fx fy fz
/// and p1 p2 ... (p1 p2 p3 of the granular styles is the tangential force, which fx fy fz leaves out).
/// Throws where no preset has as many columns.
std::vector<std::string> expand_preset(const std::vector<std::string>& list, const DumpHeader& header,
                                       bool walls, const Place& place);

/// Whether `list` is that preset's name and the dump lacks the tangential forces, which must be told.
bool is_without_tangential_forces(const std::vector<std::string>& list, const DumpHeader& header);

}  // namespace mikromakro
