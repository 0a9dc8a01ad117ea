#include "io/snapshot_parameters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <numeric>

#include "io/error.h"
#include "io/snapshot_layout.h"

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
  throw bad_input({file}, fmt::format("is of another system, {} differs", name), there, wanted);
}

// None where there are none, or in another unit (empty: without one).
std::vector<double> numbers_in(const Hdf5File& file, const std::string& name, const std::string& unit) {
  const std::string path = snapshot::parameters + "/" + name;
  if (!file.has(path) || file.has_attribute(path, "unit") == unit.empty()) return {};
  if (!unit.empty() && file.text_attribute(path, "unit") != std::vector<std::string>{unit}) return {};
  const Hdf5Dataset dataset = file.dataset(path);
  const Hdf5Shape shape = dataset.shape();
  std::vector<double> numbers(
      std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>()));
  dataset.read<double>({Hdf5Shape(shape.size(), 0), shape}, numbers);
  return numbers;
}

}  // namespace

RunConstants read_constants(const Hdf5File& file) {
  RunConstants constants;
  if (!file.has(snapshot::parameters)) return constants;
  if (file.has_attribute(snapshot::parameters, "units"))
    constants.units = file.text_attribute(snapshot::parameters, "units").front();
  if (const auto heights = numbers_in(file, "height", "m"); heights.size() == 1)
    constants.height = heights[0];
  constants.normal_stiffness = numbers_in(file, "kn", "N/m");
  constants.friction = numbers_in(file, "coefficientFriction", "");
  return constants;
}

void write_parameters(Hdf5File& file, const SnapshotParameters& parameters) {
  file.add_group(snapshot::parameters);
  if (!parameters.engine.empty()) file.attribute("/h5md/creator", "engine", parameters.engine);
  for (const auto& [name, words] : parameters.words)
    words.size() == 1 ? file.attribute(snapshot::parameters, name, words.front())
                      : file.attribute(snapshot::parameters, name, words);
  for (const auto& numbers : parameters.numbers) {
    file.add<double>(path_of(numbers), numbers.values, numbers.shape);
    if (!numbers.unit.empty()) file.attribute(path_of(numbers), "unit", numbers.unit);
  }
}

void check_parameters(const Hdf5File& file, const std::string& name, const SnapshotParameters& parameters) {
  for (const auto& [word, words] : parameters.words) {
    const bool given = file.has(snapshot::parameters) && file.has_attribute(snapshot::parameters, word);
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
