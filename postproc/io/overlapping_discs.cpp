#include "io/overlapping_discs.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

#include "io/branch_images.h"
#include "io/contact_tolerance.h"

namespace mikromakro {
namespace {

using Eigen::Vector2d;

// The cells of a grid that a disc may reach, along one axis.
struct Cells {
  std::int64_t begin = 0, count = 1;
};

// A grid without end, in which each disc stands in all the cells that its bounding square reaches; along a
// periodic axis the cells are those of the box. Far cells may share a bucket, which costs time only.
class Grid {
 public:
  Grid(const std::vector<Particle>& discs, const Box& box) : low_(box.low) {
    double sum = 0, largest = 0;
    for (const Particle& disc : discs) {
      sum += disc.radius;
      largest = std::max(largest, disc.radius);
    }
    // A disc among much smaller ones would stand in thousands of cells.
    constexpr double most_cells_across = 16;
    const double mean = sum / static_cast<double>(std::max<std::size_t>(1, discs.size()));
    const double wanted = std::max(4 * mean, 2 * largest / most_cells_across);
    const Vector2d length = box.length();
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      cell_[axis] = wanted;
      if (!box.periodic[static_cast<std::size_t>(axis)] || !(length[axis] > 0)) continue;
      around_[axis] = std::max<std::int64_t>(1, static_cast<std::int64_t>(length[axis] / wanted));
      cell_[axis] = length[axis] / static_cast<double>(around_[axis]);
    }
    fill(discs);
  }

  /// Visits the discs that share a cell with `disc`, once for each cell.
  template <typename Visit>
  void visit_neighbours(const Particle& disc, Visit visit) const {
    visit_buckets(disc, [&](std::size_t bucket) {
      for (std::size_t entry = begin_[bucket]; entry < begin_[bucket + 1]; ++entry) visit(entries_[entry]);
    });
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

  template <typename Visit>
  void visit_buckets(const Particle& disc, Visit visit) const {
    const Cells along_x = cells_of(disc, 0), along_y = cells_of(disc, 1);
    for (std::int64_t i = 0; i < along_x.count; ++i)
      for (std::int64_t j = 0; j < along_y.count; ++j) {
        constexpr std::uint64_t odd = 0x9e3779b97f4a7c15U, other = 0xc2b2ae3d27d4eb4fU;
        std::uint64_t hash = static_cast<std::uint64_t>(wrapped(along_x.begin + i, 0)) * odd +
                             static_cast<std::uint64_t>(wrapped(along_y.begin + j, 1)) * other;
        hash ^= hash >> 32U;
        visit(hash & (begin_.size() - 2));
      }
  }

  // Counted first, then sorted into their places.
  void fill(const std::vector<Particle>& discs) {
    begin_.assign(std::bit_ceil(2 * discs.size() + 1) + 1, 0);
    for (const Particle& disc : discs) visit_buckets(disc, [&](std::size_t bucket) { ++begin_[bucket + 1]; });
    for (std::size_t bucket = 1; bucket < begin_.size(); ++bucket) begin_[bucket] += begin_[bucket - 1];
    entries_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), std::prev(begin_.end()));
    for (int i = 0; i < std::ssize(discs); ++i)
      visit_buckets(discs[static_cast<std::size_t>(i)],
                    [&](std::size_t bucket) { entries_[next[bucket]++] = i; });
  }

  Vector2d low_;
  Vector2d cell_ = Vector2d::Zero();
  Eigen::Matrix<std::int64_t, 2, 1> around_ = {0, 0};  // cells of the box
  std::vector<std::size_t> begin_;                     // of each bucket in entries_
  std::vector<int> entries_;                           // indices of discs
};

// Visits each pair of discs that overlap with its overlap.
template <typename Visit>
void visit_overlaps(const std::vector<Particle>& discs, const Box& box, Visit visit) {
  const Grid grid(discs, box);
  const BranchImages images(box);
  std::vector<int> seen_by(discs.size(), -1);  // as two discs may share several cells
  for (int i = 0; i < std::ssize(discs); ++i) {
    const Particle& one = discs[static_cast<std::size_t>(i)];
    grid.visit_neighbours(one, [&](int j) {
      if (j <= i || std::exchange(seen_by[static_cast<std::size_t>(j)], i) == i) return;
      const Particle& two = discs[static_cast<std::size_t>(j)];
      const double reach = one.radius + two.radius;
      const Vector2d branch = images.nearest(two.position - one.position);
      if (branch.squaredNorm() < reach * reach) visit(DiscPair{i, j, reach - branch.norm()});
    });
  }
}

// The partners of each disc that contacts name, under the smaller index of both.
class Listed {
 public:
  Listed(const std::vector<Contact>& contacts, std::size_t discs) : begin_(discs + 1, 0) {
    const auto pairs = [&](auto take) {
      for (const Contact& contact : contacts)
        if (!contact.with_wall())
          take(static_cast<std::size_t>(std::min(contact.index1, contact.index2)),
               std::max(contact.index1, contact.index2));
    };
    pairs([&](std::size_t first, int) { ++begin_[first + 1]; });
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    partners_.resize(begin_.back());
    std::vector<std::size_t> next = begin_;
    pairs([&](std::size_t first, int second) { partners_[next[first]++] = second; });
  }

  bool has(const DiscPair& pair) const {
    const auto first = static_cast<std::size_t>(pair.first);
    const auto partners = std::span(partners_).subspan(begin_[first], begin_[first + 1] - begin_[first]);
    return std::find(partners.begin(), partners.end(), pair.second) != partners.end();
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<int> partners_;
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
  const ContactTolerance tolerance(raw.contacts, discs, raw.place_error);
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
        "discs lie on one another, by more than half a radius (a periodic box that is too short, or a "
        "packing that is there twice?); looked for now and then",
        raw.step, on_one_another);
  if (unlisted > 0)
    rules.notes->add(
        "discs overlap but have no row of a contact, which stress, fabric and coordination lack (rows of a "
        "group only, or of another run?); looked for now and then",
        raw.step, unlisted);
}

}  // namespace mikromakro
