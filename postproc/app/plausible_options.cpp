#include "app/plausible_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace mikromakro {
namespace {

void note_height(const Frame& frame, double height, Notes& notes) {
  constexpr double most = 100;  // radii
  if (!(height > 0) || frame.particles.empty()) return;
  const double radius = frame.particles.front().radius;
  if (height > most * radius)
    notes.add(
        fmt::format("--height {} is {:.3g} times the radius of a disc (it is in m)", height, height / radius),
        frame.step);
}

void note_kernel(const Frame& frame, const VolumeOptions& volumes, Notes& notes) {
  if (kernel_width(volumes) > frame.box.length().maxCoeff())
    notes.add(fmt::format("--weight {}: the kernel is wider than the box (W is in m)", volumes.weight),
              frame.step);
}

}  // namespace

void note_volumes(const Frame& frame, const VolumeOptions& volumes, Notes& notes) {
  note_height(frame, volumes.height, notes);
  note_kernel(frame, volumes, notes);
}

void note_stiffness(const Frame& frame, double normal_stiffness, Notes& notes) {
  if (normal_stiffness == 0 || frame.contacts.empty()) return;
  constexpr std::size_t enough = 64;
  const std::size_t stride = 1 + (frame.contacts.size() - 1) / enough;
  std::vector<double> slopes;
  for (std::size_t i = 0; i < frame.contacts.size(); i += stride) {
    const Contact& contact = frame.contacts[i];
    const double slope = -contact.force.dot(contact.normal) / contact.overlap;
    if (contact.overlap > 0 && slope > 0) slopes.push_back(slope);
  }
  constexpr std::size_t few = 5;
  if (slopes.size() < few) return;
  const auto middle = slopes.begin() + std::ssize(slopes) / 2;
  std::nth_element(slopes.begin(), middle, slopes.end());
  constexpr double factor = 3;
  if (*middle > factor * normal_stiffness || *middle < normal_stiffness / factor)
    notes.add(
        fmt::format("k_n = {} N/m, but forces over overlaps are {:.3g} N/m in the middle (another unit, "
                    "or of another run?)",
                    normal_stiffness, *middle),
        frame.step);
}

}  // namespace mikromakro
