// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/snapshot/wall_series.h"

#include <fmt/format.h>

#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "io/snapshot/snapshot_layout.h"

namespace mikromakro {
namespace {

const std::string group = "/walls";
constexpr std::uint64_t frames_per_chunk = 256;

std::string value_path(const std::string& name) {
  return snapshot::walls + name + "/value";
}

// Strings that averages rely on.
void name_numbers(Hdf5File& file, const WallState& wall) {
  const std::string path = snapshot::walls + wall.name;
  file.guarded_attribute(path, "style", wall.style);
  const auto quantities = wall_quantities(wall.style);
  if (quantities.size() != wall.numbers.size()) return;
  std::vector<std::string_view> names, units;
  for (const WallQuantity& one : quantities) {
    names.push_back(one.name);
    units.push_back(one.unit == "Pa" && !wall.height_known ? "N/m" : one.unit);
  }
  file.guarded_attribute(path, "quantities", fmt::format("{}", fmt::join(names, ",")));
  file.guarded_attribute(path, "units", fmt::format("{}", fmt::join(units, ",")));
}

// The parts of a list between commas.
std::vector<std::string> parts_of(const std::string& list) {
  std::vector<std::string> parts;
  std::istringstream stream(list);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

std::vector<std::string> walls_of(const Hdf5File& file) {
  if (!file.has(group)) return {};
  if (!file.has_attribute(group, "fixes")) return file.text_attribute(group, "names");
  return parts_of(file.text_attribute(group, "fixes").front());
}

// The first of the words of an attribute, empty if there is none.
std::string word_of(const Hdf5File& file, const std::string& path, const std::string& name) {
  if (!file.has_attribute(path, name)) return {};
  const std::vector<std::string> words = file.text_attribute(path, name);
  return words.empty() ? "" : words.front();
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
    name_numbers(file, wall);
    file.link(step_path, snapshot::walls + wall.name + "/step");
    if (!time_path.empty()) file.link(time_path, snapshot::walls + wall.name + "/time");
  }
  file.attribute(group, "names", names);
  file.guarded_attribute(group, "fixes", fmt::format("{}", fmt::join(names, ",")));
}

void WallSeries::resume(const Hdf5File& file) {
  for (const std::string& name : walls_of(file)) values_[name] = file.dataset(value_path(name));
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

std::vector<WallNumbers> wall_numbers(const Hdf5File& file) {
  std::vector<WallNumbers> walls;
  for (const std::string& name : walls_of(file)) {
    const std::string path = snapshot::walls + name, style = word_of(file, path, "style");
    const Hdf5Shape shape = file.dataset(value_path(name)).shape();
    if (shape.size() != 2)
      throw bad_input({file.dataset(value_path(name)).place()}, "has another shape", "frames x numbers",
                      fmt::format("{}", fmt::join(shape, " x ")));
    const std::vector<std::string> names = parts_of(word_of(file, path, "quantities")),
                                   units = parts_of(word_of(file, path, "units"));
    const auto known = wall_quantities(style);
    WallNumbers wall{name, {}};
    for (std::size_t i = 0; i < shape[1]; ++i) {
      const bool described = known.size() == shape[1];
      Column column{fmt::format("{}_{}", name, i + 1), "-", "-",
                    fmt::format("number {} of fix {}", i + 1, name)};
      if (described) {
        column.name = fmt::format("{}_{}", name, known[i].name);
        column.unit = known[i].unit == "Pa" ? "Pa, or N/m without height" : known[i].unit;
        column.text = known[i].text;
      }
      if (names.size() == shape[1]) column.name = fmt::format("{}_{}", name, names[i]);
      if (units.size() == shape[1]) column.unit = units[i];
      wall.columns.push_back(std::move(column));
    }
    walls.push_back(std::move(wall));
  }
  return walls;
}

namespace {

void check_units(const WallNumbers& one, const WallNumbers& other, const std::string& file) {
  const std::size_t both = std::min(one.columns.size(), other.columns.size());
  for (std::size_t i = 0; i < both; ++i) {
    const Column &wanted = one.columns[i], &found = other.columns[i];
    if (wanted.unit != found.unit)
      throw bad_input({file},
                      fmt::format("/walls/{}: the files disagree on the unit of {}", one.wall, found.name),
                      wanted.unit + " (windows of runs with and without a height: each alone)", found.unit);
  }
}

}  // namespace

std::vector<WallNumbers> wall_numbers(const std::vector<std::string>& files) {
  std::vector<WallNumbers> all;
  for (const std::string& file : files)
    for (WallNumbers& wall : wall_numbers(Hdf5File::open(file))) {
      const auto known =
          std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.wall == wall.wall; });
      if (known == all.end())
        all.push_back(std::move(wall));
      else
        check_units(*known, wall, file);
    }
  return all;
}

WallReader::WallReader(const Hdf5File& file, const std::vector<WallNumbers>& wanted) {
  for (const WallNumbers& wall : wanted) {
    Series series{wall.wall, wall.columns.size(), {}};
    const std::string path = value_path(wall.wall);
    if (file.has(path)) {
      Hdf5Dataset values = file.dataset(path);
      const Hdf5Shape shape = values.shape();
      if (shape.size() == 2 && shape[1] == series.count) series.values = std::move(values);
    }
    series_.push_back(std::move(series));
  }
}

std::vector<WallState> WallReader::read(std::uint64_t frame) const {
  std::vector<WallState> walls;
  for (const Series& series : series_) {
    WallState wall{series.wall, "", std::vector<double>(series.count, not_given)};
    if (series.values.id() >= 0 && frame < series.values.shape()[0])
      series.values.read<double>({{frame, 0}, {1, series.count}}, std::span(wall.numbers));
    walls.push_back(std::move(wall));
  }
  return walls;
}

}  // namespace mikromakro
