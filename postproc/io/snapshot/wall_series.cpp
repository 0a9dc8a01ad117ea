// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/snapshot/wall_series.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/snapshot/snapshot_layout.h"

namespace mikromakro {
namespace {

const std::string group = "/walls";
constexpr std::uint64_t frames_per_chunk = 256;

std::string value_path(const std::string& name) {
  return snapshot::walls + name + "/value";
}

}  // namespace

void WallSeries::begin(Hdf5File& file, const std::vector<WallState>& walls, const std::string& step_path,
                       const std::string& time_path) {
  if (walls.empty()) return;
  std::vector<std::string> names;
  for (const WallState& wall : walls) {
    names.push_back(wall.name);
    values_[wall.name] = file.add_growing(value_path(wall.name), Hdf5Type::real,
                                          {frames_per_chunk, wall.numbers.size()}, 0, false);
    values_[wall.name].grow({0, wall.numbers.size()});
    file.attribute(snapshot::walls + wall.name, "style", wall.style);
    file.link(step_path, snapshot::walls + wall.name + "/step");
    if (!time_path.empty()) file.link(time_path, snapshot::walls + wall.name + "/time");
  }
  file.attribute(group, "names", names);
}

void WallSeries::resume(const Hdf5File& file) {
  if (!file.has(group)) return;
  for (const std::string& name : file.text_attribute(group, "names"))
    values_[name] = file.dataset(value_path(name));
}

void WallSeries::check(const std::vector<WallState>& walls, const Place& place) const {
  for (const WallState& wall : walls) {
    const auto series = values_.find(wall.name);
    if (series == values_.end() || series->second.shape().back() != wall.numbers.size())
      throw bad_input(place, "the walls change", "walls that the first frame had, or none",
                      fmt::format("{} numbers of '{}'", wall.numbers.size(), wall.name));
  }
}

void WallSeries::add(const std::vector<WallState>& walls, std::uint64_t frame, const Place& place) {
  check(walls, place);
  for (auto& [name, series] : values_) {
    const std::uint64_t width = series.shape().back();
    const auto wall = std::find_if(walls.begin(), walls.end(),
                                   [&name = name](const WallState& w) { return w.name == name; });
    const std::vector<double> numbers =
        wall == walls.end() ? std::vector<double>(width, not_given) : wall->numbers;
    series.reach({frame + 1, width});
    series.write<double>({{frame, 0}, {1, width}}, numbers);
  }
}

}  // namespace mikromakro
