// SPDX-License-Identifier: GPL-2.0-or-later
// Column names of the contact dumps that stock engines write, identified by the number of columns.
#pragma once

#include <string>
#include <vector>

#include "io/text/dump_reader.h"

namespace mikromakro {

/// The column names given by --contact-columns (or, for walls, --wall-contact-columns) for this dump: `list`
/// itself, or all column names if it is the name of a preset.
///
/// liggghts: compute pair/gran/local with its keywords in the order of the compute's output, 25 columns
/// without keywords (22 if the law has no spring), 12 for `pos id force`, 15 with `history`, 16 with `history
/// delta`, 13 with `delta`, 6 for `id force`; for walls, compute wall/gran/local with the same keywords.
/// lammps: compute property/local patom1 patom2, then compute pair/local dist fx fy, or dist force fx fy fz
/// and p1 p2 ... (p1 p2 p3 of the granular styles is the tangential force, which fx fy fz omits).
/// Throws if no preset has this number of columns.
std::vector<std::string> expand_preset(const std::vector<std::string>& list, const DumpHeader& header,
                                       bool walls, const Place& place);

/// Whether `list` is the name of that preset and the dump lacks the tangential forces, which must be
/// reported.
bool is_without_tangential_forces(const std::vector<std::string>& list, const DumpHeader& header);

}  // namespace mikromakro
