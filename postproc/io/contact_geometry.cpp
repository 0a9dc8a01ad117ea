#include "io/contact_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace mikromakro {
namespace {

constexpr ColumnSet normal_columns = column_set(ContactColumn::nx, ContactColumn::ny);
constexpr ColumnSet position_columns =
    column_set(ContactColumn::x1, ContactColumn::y1, ContactColumn::x2, ContactColumn::y2);

// Two rows of a pair are different images when their normals differ by more than rounding and output formats
// do.
constexpr double same_normal = 1e-3;

class Joiner {
 public:
  Joiner(const ContactRows& rows, const std::vector<Particle>& particles, const IdMap& ids, const Box& box)
      : rows_(rows), particles_(particles), ids_(ids), box_(box) {}

  Contact join(std::size_t i) const {
    const ContactRow& row = rows_.rows[i];
    Contact contact;
    contact.id1 = static_cast<std::int64_t>(row[ContactColumn::id1]);
    contact.id2 = static_cast<std::int64_t>(row[ContactColumn::id2]);
    contact.index1 = find(contact.id1, i);
    contact.index2 = contact.with_wall() ? -1 : find(contact.id2, i);
    contact.force = {row[ContactColumn::fx], row[ContactColumn::fy]};
    contact.spring = row[ContactColumn::xi];
    contact.overlap = row[ContactColumn::overlap];
    contact.normal = {row[ContactColumn::nx], row[ContactColumn::ny]};
    if (!rows_.has(normal_columns) || !rows_.has(column_set(ContactColumn::overlap))) derive(contact, i);
    return contact;
  }

 private:
  int find(std::int64_t id, std::size_t i) const {
    const int index = ids_.find(id);
    if (index < 0)
      throw bad_input(rows_.place(i), "contact with an unknown id", "an id of the particle dump",
                      fmt::format("{}", id));
    return index;
  }

  void derive(Contact& contact, std::size_t i) const {
    const bool by_rows = rows_.has(position_columns);
    if (!by_rows && contact.with_wall()) {
      const bool overlap_needed = (rows_.needed & column_set(ContactColumn::overlap)) != 0;
      if (rows_.has(normal_columns) && !overlap_needed) return;
      throw bad_input(rows_.place(i), "wall contact without geometry", "columns nx ny overlap or x1 y1 x2 y2",
                      "neither");
    }
    const Eigen::Vector2d branch = by_rows ? row_branch(i) : particle_branch(contact);
    const double distance = branch.norm();
    if (!rows_.has(normal_columns)) {
      if (distance == 0)
        throw bad_input(rows_.place(i), "contact of coinciding centres", "a distance > 0", "0");
      contact.normal = branch / distance;
    }
    if (rows_.has(column_set(ContactColumn::overlap))) return;
    const double radius2 = contact.with_wall() ? 0.0 : particles_[contact.index2].radius;
    contact.overlap = particles_[contact.index1].radius + radius2 - distance;
  }

  Eigen::Vector2d row_branch(std::size_t i) const {
    const ContactRow& row = rows_.rows[i];
    const Eigen::Vector2d branch{row[ContactColumn::x2] - row[ContactColumn::x1],
                                 row[ContactColumn::y2] - row[ContactColumn::y1]};
    const bool told = rows_.has(column_set(ContactColumn::periodic));
    return told && row[ContactColumn::periodic] == 0 ? branch : nearest_image(branch);
  }

  Eigen::Vector2d particle_branch(const Contact& contact) const {
    return nearest_image(particles_[contact.index2].position - particles_[contact.index1].position);
  }

  Eigen::Vector2d nearest_image(Eigen::Vector2d branch) const {
    const Eigen::Vector2d length = box_.length();
    for (Eigen::Index axis = 0; axis < 2; ++axis)
      if (box_.periodic[static_cast<std::size_t>(axis)] && length[axis] > 0)
        branch[axis] -= length[axis] * std::round(branch[axis] / length[axis]);
    return branch;
  }

  const ContactRows& rows_;
  const std::vector<Particle>& particles_;
  const IdMap& ids_;
  const Box& box_;
};

// The normal of a pair as seen from its lower id, so that both orders of a pair compare.
std::pair<std::int64_t, std::int64_t> pair_of(const Contact& contact) {
  return std::minmax(contact.id1, contact.id2);
}
Eigen::Vector2d ordered_normal(const Contact& contact) {
  return contact.id1 < contact.id2 ? contact.normal : Eigen::Vector2d(-contact.normal);
}

// Whether a disc touches itself or a pair is there twice, in one pass over a table of hashes.
bool all_pairs_differ(const std::vector<Contact>& contacts) {
  const std::size_t places = std::bit_ceil(4 * contacts.size() + 1);
  std::vector<int> table(places, -1);
  for (int i = 0; i < static_cast<int>(contacts.size()); ++i) {
    const auto pair = pair_of(contacts[static_cast<std::size_t>(i)]);
    if (pair.first == pair.second) return false;
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15U;
    std::uint64_t hash =
        (static_cast<std::uint64_t>(pair.first) * odd + static_cast<std::uint64_t>(pair.second)) * odd;
    hash ^= hash >> 32U;
    std::size_t place = hash & (places - 1);
    for (; table[place] >= 0; place = (place + 1) & (places - 1))
      if (pair_of(contacts[static_cast<std::size_t>(table[place])]) == pair) return false;
    table[place] = i;
  }
  return true;
}

void check_pairs(const std::vector<Contact>& contacts, const ContactRows& rows, const Box& box) {
  if (all_pairs_differ(contacts)) return;
  const bool periodic = box.periodic[0] || box.periodic[1];
  std::vector<std::size_t> order(contacts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return pair_of(contacts[a]) < pair_of(contacts[b]); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Contact& contact = contacts[order[i]];
    if (contact.id1 == contact.id2 && !periodic)
      throw bad_input(rows.place(order[i]), "a disc in contact with itself", "two ids",
                      fmt::format("twice {}", contact.id1));
    for (std::size_t j = i; j-- > 0 && pair_of(contacts[order[j]]) == pair_of(contact);) {
      const bool other_image =
          periodic && (ordered_normal(contacts[order[j]]) - ordered_normal(contact)).norm() > same_normal;
      if (other_image) continue;
      throw bad_input(
          rows.place(order[i]), "contact listed twice", "each pair once per frame",
          fmt::format("{} {} as in line {}", contact.id1, contact.id2, rows.place(order[j]).line));
    }
  }
}

}  // namespace

std::vector<Contact> join_contacts(const ContactRows& rows, const std::vector<Particle>& particles,
                                   const IdMap& ids, const Box& box) {
  const Joiner joiner(rows, particles, ids, box);
  std::vector<Contact> contacts;
  contacts.reserve(rows.rows.size());
  for (std::size_t i = 0; i < rows.rows.size(); ++i) contacts.push_back(joiner.join(i));
  check_pairs(contacts, rows, box);
  return contacts;
}

}  // namespace mikromakro
