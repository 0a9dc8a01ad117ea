// SPDX-License-Identifier: GPL-2.0-or-later
#include "joining/contact_tolerance.h"

#include <algorithm>
#include <cmath>

#include "model/printed_digits.h"

namespace mikromakro {
namespace {

using enum ContactColumn;

// Relative error of sums and differences of coordinates and box lengths.
constexpr double arithmetic = 1e-14;
// Normals must have unit length to within this; radii are inputs, often with few digits.
constexpr double six_digits = 5e-6;

template <typename Rows, typename Add>
void sample(const Rows& rows, Add add) {
  const std::size_t stride = std::max<std::size_t>(1, rows.size() / PrintedDigits::enough);
  for (std::size_t i = 0; i < rows.size(); i += stride) add(rows[i]);
}

}  // namespace

ContactTolerance::ContactTolerance(const ContactRows& rows, const std::vector<Particle>& particles,
                                   const Box& box, double place_error) {
  PrintedDigits places, radii, row_places, normals, overlaps;
  sample(particles, [&](const Particle& disc) {
    places.add(disc.position.x());
    places.add(disc.position.y());
    radii.add(disc.radius);
  });
  sample(rows.rows, [&](const ContactRow& row) {
    for (const ContactColumn column : {x1, y1, x2, y2}) row_places.add(row[column]);
    for (const ContactColumn column : {nx, ny}) normals.add(row[column]);
    overlaps.add(row[overlap]);
    overlaps.add(row[dist]);
  });
  double radius = 0;
  Eigen::Vector2d farthest = Eigen::Vector2d::Zero();
  for (const Particle& disc : particles) {
    farthest = farthest.cwiseMax(disc.position.cwiseAbs());
    radius = std::max(radius, disc.radius);
  }
  const double size = farthest.maxCoeff() + radius;
  disc_place_ = std::isnan(place_error) ? places.rounding(size) : place_error;
  // Rows may give positions of images, up to a diameter outside a periodic box.
  const double of_box = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).maxCoeff() + 2 * radius;
  row_place_ = row_places.rounding(box.periodic[0] || box.periodic[1] ? std::max(size, of_box) : size);
  normal_ = std::min(normals.rounding(1), six_digits);
  overlap_ = overlaps.rounding(1);
  disc_place_ += arithmetic * size;
  distance_ = 3 * disc_place_ + 2 * std::min(radii.rounding(radius), six_digits * radius);
}

}  // namespace mikromakro
