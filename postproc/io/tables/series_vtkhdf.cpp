// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/tables/series_vtkhdf.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace mikromakro {
namespace {

const std::string root = "/VTKHDF/";
const std::string steps = "/VTKHDF/Steps";
constexpr std::uint64_t numbers_per_chunk = 4096;

bool ascend(const std::vector<double>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); }) &&
         std::is_sorted(numbers.begin(), numbers.end(), std::less_equal<>());
}

// Appends a vector or tensor of each outline.
void append(const CartesianPart& part, const Rows& values, const std::vector<Outline>& outlines,
            std::uint64_t window, Hdf5Dataset& data) {
  std::vector<double> numbers;
  for (const Outline& outline : outlines) {
    const std::vector<double> one = part.at(values, outline.row, outline.direction);
    numbers.insert(numbers.end(), one.begin(), one.end());
  }
  const std::uint64_t cells = outlines.size(), width = part.components();
  data.reach({(window + 1) * cells, width});
  data.write<double>({{window * cells, 0}, {cells, width}}, numbers);
}

// Appends `numbers` in the order of the outlines.
void append(const std::vector<double>& numbers, std::uint64_t window, Hdf5Dataset& data) {
  const std::uint64_t cells = numbers.size();
  data.reach({(window + 1) * cells});
  data.write<double>({{window * cells}, {cells}}, numbers);
}

}  // namespace

SeriesVtkhdf::SeriesVtkhdf(const std::string& file, SeriesColumns columns, std::vector<Outline> outlines)
    : out_(begin_vtkhdf(file, 2)),
      columns_(std::move(columns)),
      outlines_(std::move(outlines)),
      parts_(cartesian_parts(columns_.values)) {
  add_outlines(out_, outlines_);
  const auto data_of = [&](const Column& column) {
    const std::uint64_t chunk = std::max<std::uint64_t>(outlines_.size(), numbers_per_chunk);
    // A ring is many polygons of the same value.
    return out_.add_growing(root + "CellData/" + column.name, Hdf5Type::real, {chunk}, 0, true, true);
  };
  for (const Column& column : columns_.of_window) window_data_.push_back(data_of(column));
  for (std::size_t i = 0; i < columns_.of_volume.size(); ++i) {
    std::vector<double> numbers;
    for (const Outline& outline : outlines_)
      numbers.push_back(columns_.volumes(outline.row, static_cast<Eigen::Index>(i)));
    volume_data_.push_back(data_of(columns_.of_volume[i]));
    append(numbers, 0, volume_data_.back());
  }
  for (const Column& column : columns_.values) value_data_.push_back(data_of(column));
  for (const CartesianPart& part : parts_)
    part_data_.push_back(
        out_.add_growing(root + "CellData/" + part.name, Hdf5Type::real,
                         {std::max<std::uint64_t>(outlines_.size(), numbers_per_chunk), part.components()}));
}

void SeriesVtkhdf::add(const Eigen::ArrayXd& window, const Rows& values) {
  const std::uint64_t number = times_.size();
  for (std::size_t i = 0; i < window_data_.size(); ++i) {
    const double value = window[static_cast<Eigen::Index>(i)];
    append(std::vector<double>(outlines_.size(), value), number, window_data_[i]);
    if (columns_.of_window[i].name == "time") times_.push_back(value);
    if (columns_.of_window[i].name == "step") steps_.push_back(value);
  }
  std::vector<double> numbers(outlines_.size());
  for (std::size_t i = 0; i < value_data_.size(); ++i) {
    std::transform(outlines_.begin(), outlines_.end(), numbers.begin(),
                   [&](const Outline& outline) { return values(outline.row, static_cast<Eigen::Index>(i)); });
    append(numbers, number, value_data_[i]);
  }
  for (std::size_t i = 0; i < parts_.size(); ++i) append(parts_[i], values, outlines_, number, part_data_[i]);
}

void SeriesVtkhdf::write_steps() {
  std::vector<double> shown = ascend(times_) ? times_ : steps_;
  if (!ascend(shown)) std::iota(shown.begin(), shown.end(), 0);
  const auto add_list = [&](const std::string& name, const std::vector<std::int64_t>& numbers) {
    out_.add<std::int64_t>(steps + "/" + name, numbers, {numbers.size()});
  };
  const std::vector<std::int64_t> none(shown.size(), 0), ones(shown.size(), 1);
  out_.add_group(steps);
  out_.attribute(steps, "NSteps", std::ssize(shown));
  out_.add<double>(steps + "/Values", shown, {shown.size()});
  add_list("NumberOfParts", ones);
  for (const char* name : {"PartOffsets", "PointOffsets", "CellOffsets", "ConnectivityIdOffsets"})
    add_list(name, none);
  std::vector<std::int64_t> offsets(shown.size());
  for (std::size_t i = 0; i < offsets.size(); ++i)
    offsets[i] = static_cast<std::int64_t>(i * outlines_.size());
  const auto add_offsets = [&](const std::vector<Column>& columns, const std::vector<std::int64_t>& where) {
    for (const Column& column : columns) add_list("CellDataOffsets/" + column.name, where);
  };
  add_offsets(columns_.of_window, offsets);
  add_offsets(columns_.of_volume, none);
  add_offsets(columns_.values, offsets);
  for (const CartesianPart& part : parts_) add_list("CellDataOffsets/" + part.name, offsets);
}

void SeriesVtkhdf::finish(const Preamble& /*preamble*/) {
  write_steps();
  window_data_.clear();
  volume_data_.clear();
  value_data_.clear();
  part_data_.clear();
  out_.close();
}

}  // namespace mikromakro
