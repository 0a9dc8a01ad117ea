// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/contact_angles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace mikromakro {
namespace {

constexpr double pi = std::numbers::pi;

double angle_of(const DiscContact& contact) {
  return std::atan2(contact.normal[1], contact.normal[0]);
}

}  // namespace

std::vector<Column> ContactAngles::columns(const Axes& axes) const {
  const std::string from = ", counter-clockwise from e_" + axes[0];
  return {{"contact_angle_h2_amplitude", "1", "Latzel2001 Bild 6", "a_2 of the density of contact directions",
           0, true},
          {"contact_angle_h2_angle", "degree", "Latzel2001 Bild 6", "its direction" + from + ", in (-90, 90]",
           180},
          {"contact_angle_h4_amplitude", "1", "Latzel2001 Bild 6", "a_4 of the density of contact directions",
           0, true},
          {"contact_angle_h4_angle", "degree", "Latzel2001 Bild 6", "its direction" + from + ", in (-45, 45]",
           90}};
}

void ContactAngles::add_contacts(const Disc& disc, std::span<const DiscContact> contacts,
                                 std::span<double> quantity) const {
  for (const DiscContact& contact : contacts) {
    // Powers of exp(i theta) = n_r + i n_phi.
    const double c2 = contact.normal[0] * contact.normal[0] - contact.normal[1] * contact.normal[1];
    const double s2 = 2 * contact.normal[0] * contact.normal[1];
    quantity[0] += disc.volume;
    quantity[1] += disc.volume * c2;
    quantity[2] += disc.volume * s2;
    quantity[3] += disc.volume * (c2 * c2 - s2 * s2);
    quantity[4] += disc.volume * 2 * c2 * s2;
  }
}

void ContactAngles::solve(const VolumeData& /*volumes*/, const ConstRowsRef& numbers, RowsRef columns) const {
  for (Eigen::Index row = 0; row < numbers.rows(); ++row) {
    for (Eigen::Index k = 0; k < 2; ++k) {
      const double c = numbers(row, 1 + 2 * k);
      const double s = numbers(row, 2 + 2 * k);
      const double size = std::hypot(c, s);
      const double turns = 2 * static_cast<double>(k + 1);
      columns(row, 2 * k) = 2 * size / numbers(row, 0);
      columns(row, 2 * k + 1) =
          size > 0 ? 180 / pi * std::atan2(s, c) / turns : std::numeric_limits<double>::quiet_NaN();
    }
  }
}

std::vector<Column> ContactAngleHistogram::columns(const Axes& axes) const {
  std::vector<Column> columns;
  for (int i = 0; i < bins_; ++i) {
    const double width = 360.0 / bins_;
    columns.push_back(
        {fmt::format("contact_angle_bin_{}", i + 1), "1", "Latzel2001 Bild 6",
         fmt::format("fraction of the contacts with directions from {:g} to {:g} degrees from e_{}",
                     -180 + i * width, -180 + (i + 1) * width, axes[0])});
  }
  return columns;
}

void ContactAngleHistogram::add_contacts(const Disc& disc, std::span<const DiscContact> contacts,
                                         std::span<double> quantity) const {
  for (const DiscContact& contact : contacts) {
    const double place = (angle_of(contact) + pi) / (2 * pi) * bins_;
    const auto add = [&](double bin, double part) {
      // +180 degrees is the same as -180 degrees.
      const int at = (static_cast<int>(bin) + bins_) % bins_;
      quantity[1 + static_cast<std::size_t>(at)] += part * disc.volume;
    };
    quantity[0] += disc.volume;
    // Normals of flat walls fall on bin edges, where rounding would decide.
    constexpr double rounding = 1e-5;
    const double edge = std::round(place);
    if (std::abs(place - edge) < rounding) {
      add(edge - 1, 0.5);
      add(edge, 0.5);
    } else {
      add(std::floor(place), 1);
    }
  }
}

void ContactAngleHistogram::solve(const VolumeData& /*volumes*/, const ConstRowsRef& numbers,
                                  RowsRef columns) const {
  columns = numbers.rightCols(bins_).colwise() / numbers.col(0);
}

}  // namespace mikromakro
