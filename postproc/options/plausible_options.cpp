// SPDX-License-Identifier: GPL-2.0-or-later
#include "options/plausible_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <optional>
#include <vector>

#include "model/error.h"

namespace mikromakro {
namespace {

// Fewer discs may have been placed by hand and need not resemble a packing.
constexpr std::size_t enough_for_a_packing = 20;

// Stride of a sample that represents each frame.
std::size_t stride_of(std::size_t count, std::size_t enough = 128) {
  return 1 + (count - 1) / enough;
}

double mean_radius(const Frame& frame) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < frame.particles.size(); i += stride_of(frame.particles.size()), ++count)
    sum += frame.particles[i].radius;
  return sum / static_cast<double>(count);
}

void note_kernel(const Frame& frame, const VolumeOptions& volumes, Notes& notes) {
  if (kernel_width(volumes) > frame.box.length().maxCoeff())
    notes.add(fmt::format("--weight {}: the kernel is wider than the box (W is in m)", volumes.weight),
              frame.step);
}

// Bounding box of all volumes; none if no option defines them.
std::optional<Box> bounds_of(const VolumeOptions& volumes) {
  if (!volumes.grid.empty())
    return Box{{volumes.grid[0], volumes.grid[3]}, {volumes.grid[1], volumes.grid[4]}};
  if (!volumes.box.empty()) return Box{{volumes.box[0], volumes.box[2]}, {volumes.box[1], volumes.box[3]}};
  if (volumes.rings.empty() && volumes.edges.empty()) return {};
  const double outermost = volumes.rings.empty() ? volumes.edges.back() : volumes.rings[1];
  const Eigen::Vector2d centre = ring_centre(volumes), corner(outermost, outermost);
  return Box{centre - corner, centre + corner};
}

// Values in mm, say, or of another system: averages over nearly empty volumes look normal. Volumes within the
// box of the dump are the user's business.
void note_extent(const Frame& frame, const VolumeOptions& volumes, Notes& notes) {
  constexpr double most = 5;     // times the extent of the discs, and of the box
  constexpr double least = 0.1;  // of a radius: cells of a fine grid may be smaller than discs
  const std::optional<Box> bounds = bounds_of(volumes);
  if (!bounds || frame.particles.size() < enough_for_a_packing) return;
  Eigen::AlignedBox2d discs(frame.box.low, frame.box.high);
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < frame.particles.size(); i += stride_of(frame.particles.size())) {
    const Particle& disc = frame.particles[i];
    const Eigen::Vector2d corner(disc.radius, disc.radius);
    discs.extend(disc.position - corner).extend(disc.position + corner);
    smallest = std::min(smallest, disc.radius);
  }
  const Eigen::Vector2d length = bounds->length();
  if (length.maxCoeff() < least * smallest)
    notes.add(fmt::format("{}: the volumes, {:.6g} m by {:.6g} m in all, are smaller than a disc (numbers in "
                          "another unit?)",
                          volume_option(volumes), length.x(), length.y()),
              frame.step);
  if ((length.array() <= most * discs.sizes().array()).all()) return;
  notes.add(fmt::format(
                "{}: the volumes, {:.6g} m by {:.6g} m, are more than {} times as long as the region of the "
                "discs and their box (numbers in m?)",
                volume_option(volumes), length.x(), length.y(), most),
            frame.step);
}

}  // namespace

void note_height(const Frame& frame, double height, Notes& notes) {
  constexpr double unit_depth = 1;
  if (!(height > 0) || height == unit_depth || frame.particles.empty()) return;
  const double radius = mean_radius(frame);
  if (!is_plausible_height(height, radius))
    notes.add(fmt::format("--height {} is {:.1g} times the mean radius of the discs (it is in m)", height,
                          height / radius),
              frame.step);
}

void note_density(const Frame& frame, double density, double height, Notes& notes) {
  if (frame.particles.empty()) return;
  constexpr double metals = 20000, highest = 5;  // kg/m^3, diameters
  const double most = metals * (height > 0 ? height : highest * 2 * mean_radius(frame));
  if (density > most)
    notes.add(
        fmt::format("--density {}: heavier than metal discs {} high, {:.3g} kg/m^2 (it is the areal density, "
                    "rho h, in kg/m^2)",
                    density, height > 0 ? fmt::format("{} m", height) : "five diameters", most));
}

void note_volumes(const Frame& frame, const VolumeOptions& volumes, Notes& notes) {
  note_height(frame, volumes.height, notes);
  note_kernel(frame, volumes, notes);
  note_extent(frame, volumes, notes);
}

void note_branch(const Frame& frame, const VolumeOptions& volumes, Notes& notes) {
  if (branch_name(volumes) != "radius" || frame.contacts.size() < enough_for_a_packing) return;
  constexpr double most = 0.02;
  double overlaps = 0, radii = 0;
  for (std::size_t i = 0; i < frame.contacts.size(); i += stride_of(frame.contacts.size())) {
    const Contact& contact = frame.contacts[i];
    if (contact.with_wall()) continue;
    overlaps += contact.overlap;
    radii += frame.particles[static_cast<std::size_t>(contact.index1)].radius +
             frame.particles[static_cast<std::size_t>(contact.index2)].radius;
  }
  if (overlaps > most * radii)
    notes.add(
        fmt::format("--branch radius: contacts overlap by more than {:.0f} % of the diameters on average, "
                    "which makes stresses too large by as much (--branch contact uses the contact points)",
                    100 * most),
        frame.step);
}

void note_friction(const Frame& frame, double mu, Notes& notes) {
  if (mu == 0 || frame.contacts.size() < enough_for_a_packing) return;
  // A few per cent of the contacts of a packing at rest slide.
  constexpr std::size_t enough = 1024;
  constexpr double rounding = 1e-4;
  std::vector<double> ratios;
  const std::size_t stride = stride_of(frame.contacts.size(), enough);
  for (std::size_t i = 0; i < frame.contacts.size(); i += stride) {
    const Contact& contact = frame.contacts[i];
    const Eigen::Vector2d tangent(-contact.normal.y(), contact.normal.x());
    ratios.push_back(std::abs(contact.force.dot(tangent) / contact.force.dot(contact.normal)));
  }
  const auto number_above = [&](double ratio) {
    return std::count_if(ratios.begin(), ratios.end(), [&](double one) { return one > ratio; });
  };
  // Frames without sliding contacts show nothing of mu.
  constexpr std::ptrdiff_t some = 3, several = 5;
  const std::ptrdiff_t at_limit = number_above((1 - rounding) * mu);
  if (at_limit >= some)
    notes.judge(fmt::format("--mu {}: contacts carry larger tangential forces than mu allows (from another "
                            "run? or a law that adds "
                            "a dashpot to the limited spring, as of stock LIGGGHTS)",
                            mu),
                2 * number_above((1 + rounding) * mu) > at_limit, frame.step);
  // Contacts that slide all have the same ratio.
  const double largest = *std::max_element(ratios.begin(), ratios.end());
  if (largest > rounding * mu && number_above((1 - rounding) * largest) >= several)
    notes.judge(fmt::format("--mu {}: the largest ratios of tangential and normal forces are alike and below "
                            "mu, as if contacts slid there (from another run?)",
                            mu),
                largest < (1 - 100 * rounding) * mu, frame.step);
}

void note_stiffness(const Frame& frame, double normal_stiffness, bool given, Notes& notes) {
  if (!(normal_stiffness > 0) || frame.contacts.empty()) return;
  const std::size_t stride = stride_of(frame.contacts.size());
  std::vector<double> slopes;
  for (std::size_t i = 0; i < frame.contacts.size(); i += stride) {
    const Contact& contact = frame.contacts[i];
    const double slope = -contact.force.dot(contact.normal) / contact.overlap;
    if (contact.overlap > 0 && slope > 0) slopes.push_back(slope);
  }
  constexpr std::size_t few = 5;
  if (slopes.size() < few) return;
  std::sort(slopes.begin(), slopes.end());
  const std::size_t tenth = slopes.size() / 10;
  const double low = slopes[tenth], middle = slopes[slopes.size() / 2],
               high = slopes[slopes.size() - 1 - tenth];
  // Where dashpots matter the slopes scatter.
  constexpr double alike = 1.5, tolerance = 1.1, anyway = 10;
  const bool are_alike = given && high < alike * low;
  const double least = are_alike ? low / tolerance : middle / anyway,
               most = are_alike ? tolerance * high : anyway * middle;
  notes.judge(fmt::format("k_n = {} N/m is not that of the contacts (another unit, or from another run? "
                          "`mikromakro audit` prints forces over overlaps)",
                          normal_stiffness),
              normal_stiffness > most || normal_stiffness < least, frame.step);
}

}  // namespace mikromakro
