// SPDX-License-Identifier: GPL-2.0-or-later
// How exactly a file tells its numbers: read off the numbers themselves, whatever kind of file they came
// from.
#pragma once

namespace mikromakro {

/// The digits that a column was printed with, seen in some of its numbers: the most that one of them has. Few
/// numbers may all end in zeros by chance, or be written by hand: then at least the six digits that the
/// engines' %g keeps. Numbers of 32 bits, in whatever they were stored since, have seven.
class PrintedDigits {
 public:
  /// How many numbers are enough.
  static constexpr int enough = 16;

  void add(double number);
  /// What a number of this size may have lost: half a unit of its last digit.
  double rounding(double size) const;

 private:
  static constexpr int least = 6;

  int count_ = 0;
  int digits_ = 1;
  bool floats_ = true;  ///< all of them have 32 bits
};

}  // namespace mikromakro
