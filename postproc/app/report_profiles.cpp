// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/report_profiles.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace mikromakro {
namespace {

Json numbers_json(const Rows& rows) {
  Json columns = Json::array();
  for (Eigen::Index column = 0; column < rows.cols(); ++column) {
    Json numbers = Json::array();
    for (Eigen::Index row = 0; row < rows.rows(); ++row) numbers.push_back(six_digits(rows(row, column)));
    columns.push_back(std::move(numbers));
  }
  return columns;
}

}  // namespace

double six_digits(double value) {
  return std::isfinite(value) ? std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr) : value;
}

Json place_json(const Frame& frame, double time_step) {
  const bool given = !std::isnan(frame.time) || time_step == 0;
  return {{"index", frame.index},
          {"step", frame.step},
          {"time", given ? frame.time : time_step * static_cast<double>(frame.step)}};
}

Json columns_json(const Averager& averager) {
  Json list = Json::array();
  for (const Column& column : averager.columns())
    list.push_back({{"name", column.name},
                    {"unit", column.unit == "1" ? "" : column.unit},
                    {"equation", column.equation},
                    {"text", column.text}});
  return list;
}

BlockErrors errors_of(const Averager& averager, const TimeAverage& sums) {
  return block_errors(
      sums, [&](const Rows& mean) { return averager.values(mean); }, averager.columns_of_fields());
}

Json averages_json(const Averager& averager, const TimeAverage& sums, const BlockErrors& errors) {
  return {{"frames", sums.frames()},
          {"values", numbers_json(averager.values(sums.mean()))},
          {"errors", numbers_json(errors.error)}};
}

PageWindows::PageWindows(const Averager& averager, const WindowRule& rule, std::size_t error_blocks)
    : averager_(averager),
      rule_(rule),
      open_(rule, error_blocks, [this](const Window& window) { take(window); }) {}

void PageWindows::add(const Frame& frame) {
  // The last frames of a run may fill no window.
  if (frame.run != run_) windows_of_frames_.insert(windows_of_frames_.end(), places_.size(), Json());
  if (frame.run != run_) places_.clear();
  run_ = frame.run;
  places_.push_back(place_json(frame, rule_.time_step));
  FrameSums sums;
  sums.index = frame.index;
  sums.step = frame.step;
  sums.run = frame.run;
  sums.time = frame.time;
  sums.sums = averager_.frame_sums(frame);
  open_.add(sums);
}

void PageWindows::take(const Window& window) {
  windows_of_frames_.insert(windows_of_frames_.end(), places_.size(), windows_.size());
  Json json = averages_json(averager_, window.sums, errors_of(averager_, window.sums));
  json["first"] = places_.front();
  json["last"] = places_.back();
  json["step"] = window.step;
  json["time"] = window.time;
  windows_.push_back(std::move(json));
  places_.clear();
}

Json PageWindows::windows_of_frames() {
  Json all = windows_of_frames_;
  all.insert(all.end(), places_.size(), Json());
  return all;
}

}  // namespace mikromakro
