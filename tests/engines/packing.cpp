// SPDX-License-Identifier: GPL-2.0-or-later
#include "packing.h"

#include <cmath>
#include <random>

#include "engine.h"

namespace mikromakro::test {

std::string packing(int side, double speed) {
  std::mt19937 generator(2001);
  // The raw numbers of the generator are the same with every standard library; its distributions are not.
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * generator() / 4294967296.0;
  };
  const double pitch = 2 * packing_box / side;
  const int rows = 2 * static_cast<int>(std::round(side / std::sqrt(3.0)));  // even, so that it is periodic
  const double row_height = 2 * packing_box / rows;
  std::string lines;
  int id = 0;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < side; ++column) {
      const double x = -packing_box + pitch * (column + 0.25 + 0.5 * (row % 2) + uniform(-0.05, 0.05));
      const double y = -packing_box + row_height * (row + 0.5 + uniform(-0.05, 0.05));
      const int type = 1 + (generator() % 4 == 0);
      const double radius = pitch * (type == 1 ? 0.5 : 0.54);
      lines += disc(++id, x, y, radius, 6.36, type);
      const double spin = speed / radius;
      lines += motion(id, uniform(-speed, speed), uniform(-speed, speed), uniform(-spin, spin));
    }
  }
  return lines;
}

}  // namespace mikromakro::test
