// SPDX-License-Identifier: GPL-2.0-or-later
#include "joining/overlapping_discs.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <span>
#include <utility>

#include "joining/contact_tolerance.h"
#include "model/branch_images.h"

namespace mikromakro {
namespace {

using Eigen::Vector2d;

double largest_radius(const std::vector<Particle>& discs) {
  double largest = 0;
  for (const Particle& disc : discs) largest = std::max(largest, disc.radius);
  return largest;
}

// The grid cells that a disc may overlap along one axis.
struct Cells {
  std::int64_t begin = 0, count = 1;
};

// A disc in one cell of the grid, with what decides on an overlap, so that neighbours are read in one place.
struct Entry {
  Vector2d position;
  double radius;
  int index;   // of the disc
  int before;  // previous entry of the same bucket, -1 if none
};

// An unbounded grid in which each disc is listed in all cells that its bounding square overlaps; along a
// periodic axis the cells are those of the box. Distant cells may share a hash bucket, which costs only time.
class Grid {
 public:
  Grid(const std::vector<Particle>& discs, const Box& box) : low_(box.low) {
    double sum = 0;
    for (const Particle& disc : discs) sum += disc.radius;
    // Limits the cells of a large disc among much smaller ones, which would otherwise be thousands.
    constexpr double most_cells_across = 16;
    const double mean = sum / static_cast<double>(std::max<std::size_t>(1, discs.size()));
    const double wanted = std::max(4 * mean, 2 * largest_radius(discs) / most_cells_across);
    const Vector2d length = box.length();
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      cell_[axis] = wanted;
      if (!box.periodic[static_cast<std::size_t>(axis)] || !(length[axis] > 0)) continue;
      around_[axis] = std::max<std::int64_t>(1, static_cast<std::int64_t>(length[axis] / wanted));
      cell_[axis] = length[axis] / static_cast<double>(around_[axis]);
    }
    last_.assign(std::bit_ceil(2 * discs.size() + 1), -1);
    entries_.reserve(4 * discs.size());
  }

  /// Inserts a disc into its cells and visits the discs already there, once per cell.
  template <typename Visit>
  void add(int index, const Particle& disc, Visit visit) {
    const Cells along_x = cells_of(disc, 0), along_y = cells_of(disc, 1);
    for (std::int64_t i = 0; i < along_x.count; ++i)
      for (std::int64_t j = 0; j < along_y.count; ++j) {
        int& last = last_[bucket_of(wrapped(along_x.begin + i, 0), wrapped(along_y.begin + j, 1))];
        for (int entry = last; entry >= 0; entry = entries_[static_cast<std::size_t>(entry)].before)
          visit(entries_[static_cast<std::size_t>(entry)]);
        entries_.push_back({disc.position, disc.radius, index, last});
        last = static_cast<int>(entries_.size()) - 1;
      }
  }

 private:
  Cells cells_of(const Particle& disc, Eigen::Index axis) const {
    const double from = (disc.position[axis] - disc.radius - low_[axis]) / cell_[axis];
    const double to = (disc.position[axis] + disc.radius - low_[axis]) / cell_[axis];
    // Lost discs may be anywhere.
    constexpr double farthest = 1e15;
    Cells cells{static_cast<std::int64_t>(std::floor(std::clamp(from, -farthest, farthest)))};
    cells.count =
        static_cast<std::int64_t>(std::floor(std::clamp(to, -farthest, farthest))) - cells.begin + 1;
    if (around_[axis] > 0) cells.count = std::min(cells.count, around_[axis]);
    return cells;
  }

  std::int64_t wrapped(std::int64_t cell, Eigen::Index axis) const {
    const std::int64_t around = around_[axis];
    if (around == 0 || (cell >= 0 && cell < around)) return cell;
    return ((cell % around) + around) % around;
  }

  std::size_t bucket_of(std::int64_t x, std::int64_t y) const {
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15U, other = 0xc2b2ae3d27d4eb4fU;
    std::uint64_t hash = static_cast<std::uint64_t>(x) * odd + static_cast<std::uint64_t>(y) * other;
    hash ^= hash >> 32U;
    return hash & (last_.size() - 1);
  }

  Vector2d low_;
  Vector2d cell_ = Vector2d::Zero();
  Eigen::Matrix<std::int64_t, 2, 1> around_ = {0, 0};  // number of cells in the box
  std::vector<int> last_;                              // last entry of each bucket, -1 if none
  std::vector<Entry> entries_;
};

// Visits each pair of overlapping discs, once for each image that overlaps.
template <typename Visit>
void visit_overlaps(const std::vector<Particle>& discs, const Box& box, Visit visit) {
  Grid grid(discs, box);
  const BranchImages images(box);
  const bool several = images.several_within(2 * largest_radius(discs));
  std::vector<int> seen_by(discs.size(), -1);  // two discs may share several cells
  for (int i = 0; i < std::ssize(discs); ++i) {
    const Particle& two = discs[static_cast<std::size_t>(i)];
    grid.add(i, two, [&](const Entry& one) {
      const int j = one.index;
      const double reach = one.radius + two.radius;
      const Vector2d nearest = images.nearest(two.position - one.position);
      // The distance comes first: few pairs in a cell overlap, and those that do share several cells.
      if (!(nearest.squaredNorm() < reach * reach) || j == i) return;
      if (std::exchange(seen_by[static_cast<std::size_t>(j)], i) == i) return;
      const auto take = [&](const Vector2d& branch) { visit(DiscPair{j, i, reach - branch.norm(), branch}); };
      if (several) {
        images.visit_within(reach, nearest, take);
      } else {
        take(nearest);
      }
    });
    if (several)
      images.visit_within(2 * two.radius, Vector2d::Zero(), [&](const Vector2d& branch) {
        // A disc touches its own images in opposite pairs, each of which is one contact.
        const bool first_half = branch.x() > 0 || (branch.x() == 0 && branch.y() > 0);
        if (first_half) visit(DiscPair{i, i, 2 * two.radius - branch.norm(), branch});
      });
  }
}

// The contacts of each pair of discs, listed under the smaller index of the two.
class Listed {
 public:
  Listed(const std::vector<Contact>& contacts, std::size_t discs)
      : contacts_(contacts), begin_(discs + 1, 0) {
    const auto pairs = [&](auto take) {
      for (std::size_t i = 0; i < contacts.size(); ++i)
        if (const Contact& contact = contacts[i]; !contact.with_wall())
          take(static_cast<std::size_t>(std::min(contact.index1, contact.index2)), i);
    };
    pairs([&](std::size_t first, std::size_t) { ++begin_[first + 1]; });
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    of_disc_.resize(begin_.back());
    std::vector<std::size_t> next = begin_;
    pairs([&](std::size_t first, std::size_t contact) { of_disc_[next[first]++] = contact; });
  }

  /// Whether a contact names both discs and points to this image of the second.
  bool has(const DiscPair& pair) const {
    const auto first = static_cast<std::size_t>(pair.first);
    const auto of_disc = std::span(of_disc_).subspan(begin_[first], begin_[first + 1] - begin_[first]);
    return std::any_of(of_disc.begin(), of_disc.end(), [&](std::size_t i) {
      const Contact& contact = contacts_[i];
      if (std::max(contact.index1, contact.index2) != pair.second) return false;
      const double along = contact.normal.dot(pair.branch);
      return (pair.first == pair.second      ? std::abs(along)
              : contact.index1 == pair.first ? along
                                             : -along) >= 0.9 * pair.branch.norm();
    });
  }

 private:
  const std::vector<Contact>& contacts_;
  std::vector<std::size_t> begin_;
  std::vector<std::size_t> of_disc_;
};

bool is_averaged(const Particle& disc, const std::vector<int>& types) {
  return types.empty() || std::find(types.begin(), types.end(), disc.type) != types.end();
}

}  // namespace

std::vector<DiscPair> overlapping_discs(const std::vector<Particle>& discs, const Box& box) {
  std::vector<DiscPair> pairs;
  visit_overlaps(discs, box, [&](const DiscPair& pair) { pairs.push_back(pair); });
  std::sort(pairs.begin(), pairs.end(), [](const DiscPair& a, const DiscPair& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  });
  return pairs;
}

void note_overlaps(const RawFrame& raw, const std::vector<Contact>& contacts, const ContactRules& rules) {
  const std::vector<Particle>& discs = raw.particles;
  const Listed listed(contacts, discs.size());
  const ContactTolerance tolerance(raw.contacts, discs, raw.box, raw.place_error);
  std::int64_t unlisted = 0, on_one_another = 0;
  visit_overlaps(discs, raw.box, [&](const DiscPair& pair) {
    const Particle& one = discs[static_cast<std::size_t>(pair.first)];
    const Particle& two = discs[static_cast<std::size_t>(pair.second)];
    if (!is_averaged(one, rules.averaged_types) && !is_averaged(two, rules.averaged_types)) return;
    const double smaller = std::min(one.radius, two.radius);
    if (pair.overlap > 0.5 * smaller) ++on_one_another;
    if (!raw.with_contacts || listed.has(pair)) return;
    if (pair.overlap > tolerance.of_geometry(smaller, one.radius + two.radius, not_given, false)) ++unlisted;
  });
  if (on_one_another > 0)
    rules.notes->add(
        "discs overlap by more than half a radius (radii in another unit, or diameters? a periodic box that "
        "is too short? a packing that was read twice?); checked only in some frames",
        raw.step, on_one_another);
  if (unlisted > 0)
    rules.notes->add(
        "discs overlap but have no contact row: such contacts are missing from stress, fabric and "
        "coordination (rows of a group only, or from another run?); checked only in some frames",
        raw.step, unlisted);
}

}  // namespace mikromakro
