// SPDX-License-Identifier: GPL-2.0-or-later
#include "joining/contact_pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

#include "model/branch_images.h"

namespace mikromakro {
namespace {

// Two contacts with a mesh are on different faces if their normals differ by more than the rounding of output
// formats. Two contacts of a pair of discs are through different images, whose directions differ greatly, so
// the threshold can allow for normals derived from positions with few digits.
constexpr double same_side = 1e-3, same_image = 0.1;

double reach_of(const Contact& contact, const std::vector<Particle>& discs) {
  return discs[static_cast<std::size_t>(contact.index1)].radius +
         discs[static_cast<std::size_t>(contact.index2)].radius;
}

// Id pair in ascending order, and the normal seen from the lower id, so that both orders of a pair compare
// equal.
std::pair<std::int64_t, std::int64_t> pair_of(const Contact& contact) {
  return {std::min(contact.id1, contact.id2), std::max(contact.id1, contact.id2)};
}
Eigen::Vector2d ordered_normal(const Contact& contact) {
  // For a disc that touches its own image, both sides are one contact. Along y, nx is rounding and has any
  // sign.
  const bool along_y = std::abs(contact.normal.x()) < same_image;
  const bool upwards = along_y ? contact.normal.y() > 0 : contact.normal.x() > 0;
  const bool as_it_is = contact.id1 == contact.id2 ? upwards : contact.id1 < contact.id2;
  return as_it_is ? contact.normal : Eigen::Vector2d(-contact.normal);
}

// True only if certainly no disc touches itself (possibly through both of its images) and no pair is
// repeated; one pass over a hash table, small enough to stay in the cache. Pairs whose hashes look alike are
// rare, and cost only time.
bool all_pairs_differ(const std::vector<Contact>& contacts) {
  const std::size_t places = std::bit_ceil(2 * contacts.size() + 1);
  constexpr std::uint32_t nobody = 0;
  std::vector<std::uint32_t> table(places, nobody);
  for (const Contact& contact : contacts) {
    const auto pair = pair_of(contact);
    if (pair.first == pair.second) return false;
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15U;
    std::uint64_t hash =
        (static_cast<std::uint64_t>(pair.first) * odd + static_cast<std::uint64_t>(pair.second)) * odd;
    hash ^= hash >> 32U;
    const auto mark = static_cast<std::uint32_t>(hash >> 32U) | 1U;
    std::size_t place = hash & (places - 1);
    for (; table[place] != nobody; place = (place + 1) & (places - 1))
      if (table[place] == mark) return false;
    table[place] = mark;
  }
  return true;
}

// A contact dump may itself contain walls, possibly those of the separate file under other ids.
void check_walls_differ(const std::vector<Contact>& contacts, const RowOfContact& row_of,
                        const ContactRows& rows, const std::vector<Particle>& discs) {
  std::multimap<int, std::size_t> own;  // by disc
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (contacts[k].with_wall() && !rows.of_wall_file(row_of[k])) own.emplace(contacts[k].index1, k);
  for (std::size_t k = 0; k < contacts.size() && !own.empty(); ++k) {
    const Contact& contact = contacts[k];
    if (!rows.of_wall_file(row_of[k])) continue;
    const double radius = discs[static_cast<std::size_t>(contact.index1)].radius;
    for (auto [at, end] = own.equal_range(contact.index1); at != end; ++at) {
      const Contact& other = contacts[at->second];
      if ((contact.normal - other.normal).norm() > same_side ||
          std::abs(contact.overlap - other.overlap) > same_side * radius)
        continue;
      const Place place = rows.place(row_of[at->second]);
      throw bad_input(
          rows.place(row_of[k]),
          fmt::format("the contact of disc {} with a wall is in --contacts and in --wall-contacts",
                      contact.id1),
          "each contact once (leave the walls out of one of them)",
          fmt::format("wall {} as wall {} in {}:{}", contact.id2, other.id2, place.file, place.line));
    }
  }
}

}  // namespace

void check_pairs(const std::vector<Contact>& contacts, const RowOfContact& row_of, const ContactRows& rows,
                 const std::vector<Particle>& discs, const Box& box) {
  if (!rows.wall_file.empty()) check_walls_differ(contacts, row_of, rows, discs);
  if (all_pairs_differ(contacts)) return;
  const BranchImages images(box);
  std::vector<std::size_t> order(contacts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return pair_of(contacts[a]) < pair_of(contacts[b]); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Contact& contact = contacts[order[i]];
    for (std::size_t j = i; j-- > 0 && pair_of(contacts[order[j]]) == pair_of(contact);) {
      const double apart = (ordered_normal(contacts[order[j]]) - ordered_normal(contact)).norm();
      const bool other_image = contact.with_wall()
                                   ? contact.id2 <= static_cast<std::int64_t>(first_mesh) && apart > same_side
                                   : images.several_within(reach_of(contact, discs)) && apart > same_image;
      if (other_image) continue;
      throw bad_input(
          rows.place(row_of[order[i]]), "contact listed twice", "each pair once per frame",
          fmt::format("{} {} as in line {}", contact.id1, contact.id2, rows.place(row_of[order[j]]).line));
    }
  }
}

void note_walls_twice(const std::vector<Contact>& contacts, const std::vector<Particle>& discs, Notes& notes,
                      std::int64_t step) {
  std::vector<std::size_t> walls;
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (contacts[k].with_wall()) walls.push_back(k);
  std::stable_sort(walls.begin(), walls.end(),
                   [&](std::size_t a, std::size_t b) { return contacts[a].index1 < contacts[b].index1; });
  std::int64_t twice = 0;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const Contact& one = contacts[walls[i]];
    const double radius = discs[static_cast<std::size_t>(one.index1)].radius;
    for (std::size_t j = i + 1; j < walls.size() && contacts[walls[j]].index1 == one.index1; ++j) {
      const Contact& other = contacts[walls[j]];
      twice += one.id2 != other.id2 && (one.normal - other.normal).norm() <= same_side &&
                       std::abs(one.overlap - other.overlap) <= same_side * radius
                   ? 1
                   : 0;
    }
  }
  if (twice > 0)
    notes.add(
        "discs touch two walls on the same side with the same overlap (a wall defined or listed twice?)",
        step, twice);
}

}  // namespace mikromakro
