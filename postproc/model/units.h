// SPDX-License-Identifier: GPL-2.0-or-later
// Units that a dump names (`dump_modify units yes`): numbers of a frame into SI.
#pragma once

#include <string>
#include <string_view>

#include "model/error.h"
#include "model/frame.h"

namespace mikromakro {

struct RawFrame;

/// What one unit of the file is in SI. Units of everything else follow from these three.
struct Units {
  double length = 1;  ///< m
  double mass = 1;    ///< kg
  double time = 1;    ///< s

  bool are_si() const { return length == 1 && mass == 1 && time == 1; }
};

/// The systems of LAMMPS and LIGGGHTS: si, cgs, micro, nano; lj, which has no SI values, stays as it is.
/// Throws on those whose force is not mass x length/time^2 (real, metal, electron) and on unknown ones.
Units units_of(std::string_view name, const Place& place);
/// What the reader of the numbers must know of them; empty for si.
std::string units_note(std::string_view name);

/// Bounds of a box into SI.
void convert(const Units& units, Box& box);

/// All lengths, velocities, masses, forces of a frame whose contacts are joined, and of the rows they were
/// made of, into SI: not before, since how exact numbers are is seen from the digits of the file.
void convert(const Units& units, RawFrame& raw, Frame& frame);

}  // namespace mikromakro
