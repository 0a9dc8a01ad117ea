// SPDX-License-Identifier: GPL-2.0-or-later
// Tables from mean sums, and the columns needed to compute them.
#include <algorithm>

#include "averaging/averager.h"
#include "model/error.h"

namespace mikromakro {
namespace {

// The unit of numbers that were not divided by a thickness.
std::string unit_without_height(const std::string& unit) {
  if (unit == "Pa") return "N/m";
  if (unit == "N/m") return "N";  // couple stress
  if (unit == "N/m^3") return "N/m^2";
  if (unit == "k_n/h") return "k_n";
  return unit;
}

}  // namespace

std::vector<Column> Averager::columns() const {
  std::vector<Column> columns;
  for (const ListedField& listed : fields_) {
    if (!listed.shown) continue;
    for (Column& column : listed.field->columns(volumes_->axes())) {
      if (!options_.height_known) column.unit = unit_without_height(column.unit);
      columns.push_back(std::move(column));
    }
  }
  return columns;
}

std::vector<ColumnsOfField> Averager::columns_of_fields() const {
  std::vector<ColumnsOfField> fields;
  for (const ListedField& listed : fields_) {
    if (!listed.shown) continue;
    ColumnsOfField field{std::string(listed.field->name())};
    field.columns = listed.field->columns(volumes_->axes());
    field.count = std::ssize(field.columns);
    fields.push_back(std::move(field));
  }
  return fields;
}

std::vector<bool> Averager::volume_sums() const {
  std::vector<bool> sums;
  for (const ListedField& listed : fields_) {
    if (listed.shown)
      sums.insert(sums.end(), listed.field->columns(volumes_->axes()).size(), listed.field->is_volume_sum());
  }
  return sums;
}

// Input of a field: its sums, then the columns of its sources.
Rows Averager::numbers(std::size_t field, const Rows& mean_sums, const std::vector<Rows>& solved) const {
  Eigen::Index filled = fields_[field].field->sums();
  Eigen::Index width = filled;
  for (const std::size_t source : sources_[field]) width += solved[source].cols();
  Rows numbers(mean_sums.rows(), width);
  numbers.leftCols(filled) = mean_sums.middleCols(static_cast<Eigen::Index>(offsets_[field]), filled);
  for (const std::size_t source : sources_[field]) {
    numbers.middleCols(filled, solved[source].cols()) = solved[source];
    filled += solved[source].cols();
  }
  return numbers;
}

Rows Averager::values(const Rows& mean_sums) const {
  const VolumeData data{volumes_->measure(), volumes_->height(), volumes_->radii()};
  std::vector<Rows> solved;
  Eigen::Index width = 0;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const auto columns = static_cast<Eigen::Index>(fields_[i].field->columns(volumes_->axes()).size());
    Rows rows(volumes_->count(), columns);
    fields_[i].field->solve(data, numbers(i, mean_sums, solved), rows);
    solved.push_back(std::move(rows));
    if (fields_[i].shown) width += columns;
  }
  Rows values(volumes_->count(), width);
  Eigen::Index begin = 0;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    if (!fields_[i].shown) continue;
    values.middleCols(begin, solved[i].cols()) = solved[i];
    begin += solved[i].cols();
  }
  return values;
}

Table Averager::volumes() const {
  return {volumes_->columns(), volumes_->coordinates()};
}

Table Averager::solve(const Rows& mean_sums) const {
  Table table;
  table.columns = volumes_->columns();
  const Rows coordinates = volumes_->coordinates();
  const Rows solved = values(mean_sums);
  if (solved.isInf().any())
    throw run_failed("an average overflows", "values below 1e308 (a height or another constant far off?)",
                     "inf");
  for (Column& column : columns()) table.columns.push_back(std::move(column));
  table.rows.resize(volumes_->count(), coordinates.cols() + solved.cols());
  table.rows << coordinates, solved;
  return table;
}

std::vector<std::string> Averager::notes(const Rows& mean_sums) const {
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const Field& field = *fields_[i].field;
    const auto sums = mean_sums.middleCols(static_cast<Eigen::Index>(offsets_[i]), field.sums());
    const std::string note = field.note(sums);
    if (!note.empty()) notes.push_back(note);
  }
  return notes;
}

ColumnSet Averager::particles_needed() const {
  ColumnSet needed = options_.bulk_types.empty() ? 0 : column_set(ParticleColumn::type);
  for (const ListedField& listed : fields_) needed |= listed.field->particles_needed();
  return needed;
}

ColumnSet Averager::contacts_needed() const {
  ColumnSet needed = branch_ == Branch::contact ? column_set(ContactColumn::overlap) : 0;
  for (const ListedField& listed : fields_) needed |= listed.field->contacts_needed();
  return needed;
}

bool Averager::needs_contacts() const {
  return std::any_of(fields_.begin(), fields_.end(),
                     [](const ListedField& listed) { return listed.field->needs_contacts(); });
}

bool Averager::uses_branches() const {
  return std::any_of(fields_.begin(), fields_.end(), [](const ListedField& listed) {
    return listed.field->contact_place() != ContactPlace::disc;
  });
}

bool Averager::uses_height() const {
  const auto by_height = [](const Column& column) { return unit_without_height(column.unit) != column.unit; };
  return std::any_of(fields_.begin(), fields_.end(), [&](const ListedField& listed) {
    const std::vector<Column> columns = listed.field->columns(volumes_->axes());
    return listed.shown && std::any_of(columns.begin(), columns.end(), by_height);
  });
}

}  // namespace mikromakro
