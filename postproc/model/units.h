// SPDX-License-Identifier: GPL-2.0-or-later
// Units named in a dump (`dump_modify units yes`): conversion of a frame to SI.
#pragma once

#include <string>
#include <string_view>

#include "model/error.h"
#include "model/frame.h"

namespace mikromakro {

struct RawFrame;

/// Value of one file unit in SI. All other units follow from these three.
struct Units {
  double length = 1;  ///< m
  double mass = 1;    ///< kg
  double time = 1;    ///< s

  bool are_si() const { return length == 1 && mass == 1 && time == 1; }
};

/// The unit systems of LAMMPS and LIGGGHTS: si, cgs, micro, nano; lj has no SI values and is left unchanged.
/// Throws on systems whose force is not mass x length/time^2 (real, metal, electron) and on unknown ones.
Units units_of(std::string_view name, const Place& place);
/// A remark for users of the numbers; empty for si.
std::string units_note(std::string_view name);

/// Converts the bounds of a box to SI.
void convert(const Units& units, Box& box);

/// Converts all lengths, velocities, masses and forces of a frame, and of the rows it was made from, to SI.
/// Only after the contacts are joined, since the precision of numbers is estimated from their digits in the
/// file.
void convert(const Units& units, RawFrame& raw, Frame& frame);

}  // namespace mikromakro
