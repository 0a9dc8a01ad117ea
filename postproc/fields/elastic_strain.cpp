// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/elastic_strain.h"

#include "fields/branch_dyad.h"

namespace mikromakro {
namespace {

constexpr int displacement_sums = 4;

}  // namespace

std::vector<Column> ElasticStrain::columns(const Axes& axes) const {
  return tensor_columns(
      "eps", axes, {"", "1", "Latzel2001 Eq. 20", "elastic displacement gradient, compression negative"});
}

int ElasticStrain::sums() const {
  return displacement_sums + branch_dyad_sums;
}

void ElasticStrain::add_contacts(const Disc& /*disc*/, std::span<const DiscContact> contacts,
                                 std::span<double> quantity) const {
  for (const DiscContact& contact : contacts)
    add_dyad(-contact.overlap * contact.normal, contact.branch, quantity);
  add_branch_dyad(contacts, quantity.subspan(displacement_sums));
}

void ElasticStrain::solve(const VolumeData& /*volumes*/, const ConstRowsRef& numbers, RowsRef columns) const {
  for (Eigen::Index row = 0; row < numbers.rows(); ++row) {
    const auto sums = numbers_of(numbers, row, 0, displacement_sums);
    const Eigen::Matrix2d inverse =
        inverse_branch_dyad(numbers_of(numbers, row, displacement_sums, branch_dyad_sums));
    const Eigen::Matrix2d displacement = (Eigen::Matrix2d() << sums[0], sums[1], sums[2], sums[3]).finished();
    const Eigen::Matrix2d strain = displacement * inverse;
    columns.row(row) << strain(0, 0), strain(0, 1), strain(1, 0), strain(1, 1);
  }
}

}  // namespace mikromakro
