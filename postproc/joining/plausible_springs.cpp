// SPDX-License-Identifier: GPL-2.0-or-later
#include "joining/plausible_springs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Core>
#include <utility>

namespace mikromakro {
namespace {

using enum ContactColumn;
using Eigen::Vector2d;

/// Tangential forces below this part of the normal ones are rounding.
constexpr double rounding = 1e-5;

double tangential_force(const Contact& contact) {
  return contact.force.dot(Vector2d(-contact.normal.y(), contact.normal.x()));
}

double normal_force(const Contact& contact) {
  return -contact.force.dot(contact.normal);
}

/// |f_t|/|f_n| that a tenth of the contacts reach: the friction coefficient, where discs slide.
double large_ratio(const std::vector<Contact>& contacts) {
  std::vector<double> ratios;
  ratios.reserve(contacts.size());
  for (const Contact& contact : contacts) {
    const double normal = normal_force(contact);
    ratios.push_back(normal == 0 ? 0 : std::abs(tangential_force(contact) / normal));
  }
  const auto tenth = ratios.end() - 1 - std::ssize(ratios) / 10;
  std::nth_element(ratios.begin(), tenth, ratios.end());
  return *tenth;
}

/// Ranks of the numbers, from 0 on; those that are equal to a 1e-5 of the largest have their mean rank.
Eigen::ArrayXd ranks_of(const std::vector<double>& numbers) {
  constexpr double alike = 1e-5;
  double largest = 0;
  std::vector<std::pair<double, Eigen::Index>> sorted;
  sorted.reserve(numbers.size());
  for (const double one : numbers) {
    largest = std::max(largest, std::abs(one));
    sorted.emplace_back(one, std::ssize(sorted));
  }
  std::sort(sorted.begin(), sorted.end());
  Eigen::ArrayXd ranks(std::ssize(numbers));
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto next = std::find_if(
        first, sorted.end(), [&](const auto& one) { return one.first > first->first + alike * largest; });
    const auto rank = static_cast<double>((first - sorted.begin()) + (next - sorted.begin()) - 1) / 2;
    for (; first != next; ++first) ranks[first->second] = rank;
  }
  return ranks;
}

/// Spearman's rank correlation, of two series of the same length n: 0 +- 1/sqrt(n) by chance; nan if one of
/// them is the same number in most places.
double rank_correlation(const std::vector<double>& one, const std::vector<double>& other) {
  Eigen::ArrayXd a = ranks_of(one), b = ranks_of(other);
  a -= a.mean();
  b -= b.mean();
  const auto n = static_cast<double>(a.size());
  const double varied = n * n / 24;  // half of the variance of ranks that all differ
  const double of_a = a.square().mean(), of_b = b.square().mean();
  return of_a < varied || of_b < varied ? not_given : (a * b).mean() / std::sqrt(of_a * of_b);
}

}  // namespace

void check_springs_pull_back(const ContactRows& rows, const std::vector<Contact>& contacts, bool closely) {
  constexpr std::size_t enough = 20;
  constexpr ColumnSet shear = column_set(shearx, sheary);
  const bool by_xi = (rows.given & column_set(xi)) != 0;
  const bool given = by_xi ? closely : (rows.given & shear) == shear;
  if (!given || contacts.size() < enough) return;
  double along = 0, all = 0;
  std::ptrdiff_t count_along = 0, count = 0;
  const double limit = large_ratio(contacts);
  for (const Contact& contact : contacts) {
    const double tangential = tangential_force(contact);
    const double work = tangential * contact.spring;
    // Where discs slide, a dashpot beside the spring carries the whole limit, and the spring what is beyond.
    constexpr double sticks = 0.9;
    const double normal = std::abs(normal_force(contact));
    if (std::isnan(work) || std::abs(tangential) > sticks * limit * normal ||
        std::abs(tangential) < rounding * normal)
      continue;
    along += work;
    all += std::abs(work);
    count_along += work > 0 ? 1 : 0;
    count += work != 0 ? 1 : 0;
  }
  // In fast motion dashpots turn f_t round in half of the contacts, and in those of the largest forces.
  constexpr double most = 0.75;
  if (count >= std::ssize(contacts) / 4 && count >= static_cast<std::ptrdiff_t>(enough) &&
      along > 0.5 * all && static_cast<double>(count_along) > most * static_cast<double>(count))
    throw bad_input(rows.place(0),
                    by_xi ? "xi mostly has the sign of the tangential forces: no springs (forces in this "
                            "column, slip of disc 2 against disc 1? or forces on disc 2?)"
                          : "shearx sheary point along the tangential forces: no springs",
                    fmt::format("springs, which pull back (f_t = -k_t {})", by_xi ? "xi" : "shear"),
                    "another quantity");
}

void note_size_of_springs(const std::vector<Contact>& contacts, const ContactRules& rules) {
  constexpr std::size_t enough = 20, sample = 40;
  // Springs are soft by design more often than stiff, but never so soft as those of a millimetre for a metre.
  constexpr double stiffest = 100, softest = 1.0 / 300, never_stiffer = 300, never_softer = 1.0 / 700;
  double tangential = 0, springs = 0, normal = 0, overlaps = 0;
  std::size_t count = 0;
  const std::size_t stride = rules.closely || contacts.empty() ? 1 : 1 + (contacts.size() - 1) / sample;
  for (std::size_t i = 0; i < contacts.size(); i += stride) {
    const Contact& contact = contacts[i];
    if (!(std::abs(contact.spring) > 0)) continue;
    ++count;
    tangential += std::abs(tangential_force(contact));
    springs += std::abs(contact.spring);
    normal += std::abs(normal_force(contact));
    overlaps += std::abs(contact.overlap);
  }
  if (count < enough || !(tangential > rounding * normal && normal > 0)) return;
  const double ratio = tangential / springs * overlaps / normal;
  constexpr const char* text =
      "f_t over the tangential springs is more than a hundred times, or less than a 300th of, f_n over the "
      "overlaps (springs in another unit, or another quantity in their column?)";
  // A metre taken for a millimetre is no matter of fast motion: one frame tells.
  if (ratio > never_stiffer || ratio < never_softer)
    rules.notes->add(text, rules.step);
  else if (rules.closely)
    rules.notes->judge(text, ratio > stiffest || ratio < softest, rules.step);
}

void note_springs_without_force(const std::vector<Contact>& contacts, const ContactRules& rules) {
  constexpr std::size_t enough = 100, sample = 2000;
  if (!rules.closely || contacts.empty()) return;
  std::vector<double> springs, forces;
  const std::size_t stride = 1 + (contacts.size() - 1) / sample;
  for (std::size_t i = 0; i < contacts.size(); i += stride) {
    const Contact& contact = contacts[i];
    const double force = tangential_force(contact);
    if (!(std::abs(contact.spring) > 0 && std::abs(force) > rounding * std::abs(normal_force(contact))))
      continue;
    springs.push_back(contact.spring);
    forces.push_back(force);
  }
  if (springs.size() < enough) return;
  const double by_chance = 1 / std::sqrt(static_cast<double>(springs.size()));
  rules.notes->judge(
      "tangential springs and tangential forces are uncorrelated (another quantity in the "
      "column, or rows of another frame? or dashpots much stronger than the springs)",
      rank_correlation(springs, forces) > -4 * by_chance, rules.step);
}

}  // namespace mikromakro
