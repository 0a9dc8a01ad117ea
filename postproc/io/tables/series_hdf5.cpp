// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/tables/series_hdf5.h"

#include <algorithm>

#include "io/tables/table_hdf5.h"

namespace mikromakro {
namespace {

constexpr std::uint64_t numbers_per_chunk = 4096;

std::string path_of(const Column& column) {
  return "/table/" + column.name;
}

}  // namespace

SeriesHdf5::SeriesHdf5(const std::string& file, SeriesColumns columns)
    : out_(Hdf5File::create(file)), columns_(std::move(columns)) {
  const auto volumes = static_cast<std::uint64_t>(columns_.volumes.rows());
  out_.add_group("/table");
  for (const Column& column : columns_.of_window) {
    of_window_.push_back(out_.add_growing(path_of(column), Hdf5Type::real, {numbers_per_chunk}));
    describe(column, {"time"});
  }
  for (std::size_t i = 0; i < columns_.of_volume.size(); ++i) {
    const Eigen::ArrayXd numbers = columns_.volumes.col(static_cast<Eigen::Index>(i));
    out_.add<double>(path_of(columns_.of_volume[i]), {numbers.data(), volumes}, {volumes});
    describe(columns_.of_volume[i], {"volume"});
  }
  const std::uint64_t windows = std::max<std::uint64_t>(numbers_per_chunk / volumes, 1);
  for (const Column& column : columns_.values) {
    values_.push_back(out_.add_growing(path_of(column), Hdf5Type::real, {windows, volumes}));
    describe(column, {"time", "volume"});
  }
}

void SeriesHdf5::describe(const Column& column, const std::vector<std::string>& axes) {
  describe_column(out_, column);
  out_.attribute(path_of(column), "axes", axes);
}

void SeriesHdf5::add(const Eigen::ArrayXd& window, const Rows& values) {
  for (std::size_t i = 0; i < of_window_.size(); ++i) {
    of_window_[i].reach({windows_ + 1});
    of_window_[i].write<double>({{windows_}, {1}}, {&window[static_cast<Eigen::Index>(i)], 1});
  }
  const auto volumes = static_cast<std::uint64_t>(values.rows());
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const Eigen::ArrayXd numbers = values.col(static_cast<Eigen::Index>(i));
    values_[i].reach({windows_ + 1, volumes});
    values_[i].write<double>({{windows_, 0}, {1, volumes}}, {numbers.data(), volumes});
  }
  ++windows_;
}

void SeriesHdf5::finish(const Preamble& preamble) {
  describe_table(out_, preamble, columns_.all());
  of_window_.clear();
  values_.clear();
  out_.close();
}

}  // namespace mikromakro
