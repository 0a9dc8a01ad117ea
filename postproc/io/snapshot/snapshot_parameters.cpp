// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/snapshot/snapshot_parameters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "io/snapshot/snapshot_layout.h"
#include "model/error.h"

namespace mikromakro {
namespace {

std::string path_of(const SnapshotParameters::Numbers& numbers) {
  return snapshot::parameters + "/" + numbers.name;
}

std::string text_of(const std::vector<std::string>& words) {
  return fmt::format("'{}'", fmt::join(words, ", "));
}

std::string text_of(const std::vector<double>& values) {
  return fmt::format("{}", fmt::join(values, " "));
}

void check(const std::string& file, const std::string& name, const std::string& there,
           const std::string& wanted) {
  if (there == wanted) return;
  throw bad_input({file}, fmt::format("belongs to another system, {} differs", name), there, wanted);
}

// Empty if there is no such dataset, or if it has no unit.
std::string unit_of(const Hdf5File& file, const std::string& name) {
  const std::string path = snapshot::parameters + "/" + name;
  if (!file.has(path) || !file.has_attribute(path, "unit")) return "";
  return fmt::format("{}", fmt::join(file.text_attribute(path, "unit"), " "));
}

// Empty if there is no such dataset.
std::vector<double> numbers_in(const Hdf5File& file, const std::string& name) {
  const std::string path = snapshot::parameters + "/" + name;
  if (!file.has(path)) return {};
  const Hdf5Dataset dataset = file.dataset(path);
  const Hdf5Shape shape = dataset.shape();
  std::vector<double> numbers(
      std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>()));
  dataset.read<double>({Hdf5Shape(shape.size(), 0), shape}, numbers);
  if (numbers.empty())
    throw bad_input({dataset.place()}, "no numbers in the dataset", "one or more, or no dataset", "0");
  return numbers;
}

Error wrong_constant(const std::string& file, const std::string& name, std::string_view expected,
                     const std::string& got) {
  return bad_input({file}, fmt::format("{}/{}", snapshot::parameters, name), expected, got);
}

void check_unit(const Hdf5File& file, const std::string& name, std::string_view expected,
                const std::string& place) {
  const std::string unit = unit_of(file, name);
  if (unit != expected) throw wrong_constant(place, name, fmt::format("in {}", expected), in_quotes(unit));
}

double height_in(const Hdf5File& file, const std::string& place) {
  const std::vector<double> heights = numbers_in(file, "height");
  if (heights.empty()) return 0;
  check_unit(file, "height", "m", place);
  if (heights.size() != 1 || !(heights[0] > 0) || !std::isfinite(heights[0]))
    throw wrong_constant(place, "height", "one length above 0", text_of(heights));
  return heights[0];
}

// One number per pair of types; empty if there is no such dataset.
std::vector<double> table_in(const Hdf5File& file, const std::string& name, const std::string& place) {
  std::vector<double> numbers = numbers_in(file, name);
  if (numbers.empty()) return numbers;
  const Hdf5Shape shape = file.dataset(snapshot::parameters + "/" + name).shape();
  if (shape.size() != 2 || shape[0] != shape[1])
    throw wrong_constant(place, name, "a table of types x types", fmt::format("{}", fmt::join(shape, " x ")));
  if (!std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x) && x >= 0; }))
    throw wrong_constant(place, name, "numbers of 0 or more", text_of(numbers));
  return numbers;
}

const std::string units = "units";

// By averages.
bool is_relied_on(const std::string& attribute) {
  return attribute == units || attribute == snapshot::law || attribute == snapshot::unrecorded_walls;
}

// Empty if there is no such attribute.
std::string word_in(const Hdf5File& file, const std::string& attribute, const std::string& place) {
  if (!file.has_attribute(snapshot::parameters, attribute)) return "";
  const auto words = file.text_attribute(snapshot::parameters, attribute);
  if (words.size() != 1)
    throw wrong_constant(place, attribute, "one string", fmt::format("{} strings", words.size()));
  return words.front();
}

}  // namespace

RunConstants read_constants(const Hdf5File& file, const std::string& name) {
  RunConstants constants;
  if (!file.has(snapshot::parameters)) return constants;
  constants.units = word_in(file, units, name);
  constants.law = word_in(file, snapshot::law, name);
  constants.unrecorded_walls = word_in(file, snapshot::unrecorded_walls, name);
  constants.height = height_in(file, name);
  constants.friction = table_in(file, "coefficientFriction", name);
  constants.normal_stiffness = table_in(file, "kn", name);
  if (constants.normal_stiffness.empty()) return constants;
  constants.unit_of_stiffness = unit_of(file, "kn");
  // Of f_n = k_n overlap^q: N/m^q.
  constants.nonlinear = constants.unit_of_stiffness.starts_with("N/m^");
  if (constants.nonlinear)
    constants.normal_stiffness.clear();
  else
    check_unit(file, "kn", "N/m", name);
  return constants;
}

void write_parameters(Hdf5File& file, const SnapshotParameters& parameters) {
  file.add_group(snapshot::parameters);
  if (!parameters.engine.empty()) file.attribute("/h5md/creator", "engine", parameters.engine);
  for (const auto& [name, words] : parameters.words) {
    if (words.size() == 1 && is_relied_on(name))
      file.guarded_attribute(snapshot::parameters, name, words.front());
    else if (words.size() == 1)
      file.attribute(snapshot::parameters, name, words.front());
    else
      file.attribute(snapshot::parameters, name, words);
  }
  for (const auto& numbers : parameters.numbers) {
    file.add<double>(path_of(numbers), numbers.values, numbers.shape);
    if (!numbers.unit.empty()) file.guarded_attribute(path_of(numbers), "unit", numbers.unit);
  }
}

void check_parameters(const Hdf5File& file, const std::string& name, const SnapshotParameters& parameters) {
  for (const auto& [word, words] : parameters.words) {
    const bool given = file.has(snapshot::parameters) && file.has_attribute(snapshot::parameters, word);
    if (!given && is_relied_on(word) && word != units) continue;  // a file of an older version
    check(name, word, given ? text_of(file.text_attribute(snapshot::parameters, word)) : "none",
          text_of(words));
  }
  for (const auto& numbers : parameters.numbers) {
    if (!file.has(path_of(numbers))) check(name, numbers.name, "none", text_of(numbers.values));
    const Hdf5Dataset dataset = file.dataset(path_of(numbers));
    if (dataset.shape() != numbers.shape)
      check(name, numbers.name, fmt::format("a table of {}", fmt::join(dataset.shape(), " x ")),
            fmt::format("a table of {}", fmt::join(numbers.shape, " x ")));
    std::vector<double> there(numbers.values.size());
    dataset.read<double>({Hdf5Shape(numbers.shape.size(), 0), numbers.shape}, there);
    check(name, numbers.name, text_of(there), text_of(numbers.values));
  }
}

}  // namespace mikromakro
