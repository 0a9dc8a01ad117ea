// SPDX-License-Identifier: GPL-2.0-or-later
// Precision of the numbers in a file, estimated from the numbers themselves, whatever the file format.
#pragma once

namespace mikromakro {

/// Number of significant digits that a column was printed with: the maximum over a sample of its numbers. A
/// few numbers may all end in zeros by chance, or be written by hand, so at least six digits are assumed, as
/// in the engines' %g. Numbers that are exact in single precision have seven digits, whatever format stored
/// them later.
class PrintedDigits {
 public:
  /// Sufficient sample size.
  static constexpr int enough = 16;

  void add(double number);
  /// Possible rounding error of a number of this size: half a unit in the last digit.
  double rounding(double size) const;

 private:
  static constexpr int least = 6;

  int count_ = 0;
  int digits_ = 1;
  bool floats_ = true;  ///< all numbers so far are exact in single precision
};

}  // namespace mikromakro
