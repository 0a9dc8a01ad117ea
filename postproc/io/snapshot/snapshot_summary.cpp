// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/snapshot/snapshot_summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "io/snapshot/snapshot_layout.h"
#include "model/error.h"
#include "model/whole_number.h"

namespace mikromakro {
namespace {

constexpr std::uint64_t most_rows = 0x7fffffff;
const std::string steps_path = "/particles/discs/position/step";
const std::string times_path = "/particles/discs/position/time";

std::vector<std::int64_t> all_of(const Hdf5File& file, const std::string& path) {
  const Hdf5Dataset dataset = file.dataset(path);
  const Hdf5Shape shape = dataset.shape();
  if (shape.size() != 1)
    throw bad_input({dataset.place()}, "has the wrong shape", "a number for each frame",
                    shape.empty() ? "one number" : fmt::format("{}", fmt::join(shape, " x ")));
  std::vector<std::int64_t> numbers(shape[0]);
  if (dataset.is_whole()) {
    dataset.read<std::int64_t>({{0}, {numbers.size()}}, numbers);
    return numbers;
  }
  std::vector<double> as_they_are(numbers.size());
  dataset.read<double>({{0}, {numbers.size()}}, as_they_are);
  std::transform(as_they_are.begin(), as_they_are.end(), numbers.begin(),
                 [&](double number) { return as_integer(number, "the number", {dataset.place()}); });
  return numbers;
}

// Files of other programs may use other units; our files name theirs. No unit: SI.
void check_unit(const Hdf5Dataset& dataset, const std::string& path, std::string_view unit,
                const std::string& name) {
  if (unit.empty()) return;
  const auto there = dataset.text_attribute("unit");
  if (there && (there->size() != 1 || there->front() != unit))
    throw bad_input({name}, fmt::format("{} has the wrong unit", path), in_quotes(unit),
                    in_quotes(fmt::format("{}", fmt::join(*there, " "))));
}

// One or two numbers per place and frame; other programs write three coordinates.
void check_shape(const Hdf5Shape& shape, const snapshot::Element& element, const std::string& name) {
  const auto width = static_cast<std::uint64_t>(element.width);
  const bool fits = width == 1 ? shape.size() == 2 : shape.size() == 3 && shape[2] == width;
  if (!fits)
    throw bad_input({name}, fmt::format("{} has the wrong shape", snapshot::value_path(element)),
                    width == 1 ? "frames x discs" : fmt::format("frames x discs x {}", width),
                    fmt::format("{}", fmt::join(shape, " x ")));
}

// In our files this is the same object as the steps of the positions; parts of another run may have been
// added.
void check_steps(const Hdf5File& file, const std::string& path, const std::vector<std::int64_t>& steps,
                 std::string_view what, const std::string& name) {
  if (path == steps_path || !file.has(path) || file.are_one(path, steps_path)) return;
  const std::vector<std::int64_t> others = all_of(file, path);
  const auto [step, other] = std::mismatch(steps.begin(), steps.end(), others.begin(), others.end());
  if (step == steps.end()) return;
  throw bad_input({name}, fmt::format("{} not at the steps of the discs", what),
                  fmt::format("step {}", *step), other == others.end() ? "none" : fmt::format("{}", *other));
}

// The time of each step, s; empty if the file has none.
std::vector<double> times_of(const Hdf5File& file, std::size_t frames, const std::string& name) {
  if (!file.has(times_path)) return {};
  const Hdf5Dataset dataset = file.dataset(times_path);
  check_unit(dataset, times_path, "s", name);
  const Hdf5Shape shape = dataset.shape();
  if (shape.size() != 1 || shape[0] < frames)
    throw bad_input({name}, fmt::format("{} has the wrong shape", times_path),
                    fmt::format("{} times", frames), fmt::format("{}", fmt::join(shape, " x ")));
  std::vector<double> times(frames);
  dataset.read<double>({{0}, {frames}}, times);
  for (const double time : times)
    if (!std::isfinite(time))
      throw bad_input({dataset.place()}, "not a finite number", "a time", fmt::format("{}", time));
  return times;
}

void add_discs(const Hdf5File& file, const std::string& name, SnapshotSummary& summary) {
  for (const auto& element : snapshot::elements) {
    const std::string path = snapshot::value_path(element);
    Hdf5Dataset& dataset = summary.elements.emplace_back();
    if (!file.has(path)) continue;
    dataset = file.dataset(path);
    check_shape(dataset.shape(), element, name);
    check_unit(dataset, path, element.unit, name);
    check_steps(file, snapshot::discs + std::string(element.name) + "/step", summary.steps,
                fmt::format("{} is", element.name), name);
    summary.particles_given |= element.columns();
  }
  const Hdf5Shape shape = summary.elements.front().shape();  // of the ids
  if (shape.size() != 2 || shape[0] < summary.steps.size())
    throw bad_input({name}, "the numbers of frames differ",
                    fmt::format("{} frames of ids", summary.steps.size()),
                    fmt::format("{}", shape.empty() ? 0 : shape[0]));
  if (shape[1] > most_rows)
    throw bad_input({name}, "the number of particles is not valid", "less than 2^31",
                    fmt::format("{}", shape[1]));
  summary.most_particles = shape[1];
}

void check_box(const Hdf5File& file, const std::string& name, const std::vector<std::int64_t>& steps) {
  for (const std::string corner : {"low", "edges"}) {
    check_unit(file.dataset(snapshot::corner_path(corner)), snapshot::corner_path(corner), "m", name);
    check_steps(file, snapshot::box + "/" + corner + "/step", steps, "the box is", name);
  }
}

void add_contact_columns(const Hdf5File& file, const std::string& name, SnapshotSummary& summary) {
  for (std::size_t slot = 0; slot < std::size(contact_column_names); ++slot) {
    const std::string path = snapshot::contact_path(slot);
    Hdf5Dataset& dataset = summary.columns.emplace_back();
    if (!file.has(path)) continue;
    dataset = file.dataset(path);
    check_unit(dataset, path, snapshot::contact_units[slot], name);
    if (dataset.shape().size() != 1)
      throw bad_input({dataset.place()}, "has the wrong shape", "a number for each contact",
                      fmt::format("{} dimensions", dataset.shape().size()));
    summary.contacts_given |= ColumnSet{1} << slot;
  }
}

// Offsets of the contacts of each frame, and the number of all at the end.
void add_contact_offsets(const Hdf5File& file, const std::string& name, SnapshotSummary& summary) {
  check_steps(file, snapshot::contacts + "step", summary.steps, "contacts are", name);
  summary.contact_offsets = all_of(file, snapshot::contacts + "offset");
  auto& offsets = summary.contact_offsets;
  offsets.resize(std::min(offsets.size(), summary.steps.size() + 1));
  if (offsets.size() != summary.steps.size() + 1 || offsets.front() != 0 ||
      !std::is_sorted(offsets.begin(), offsets.end()))
    throw bad_input({name}, "contacts do not fit the frames", "increasing offsets, one more than frames",
                    "others");
  for (std::size_t frame = 1; frame < offsets.size(); ++frame)
    if (static_cast<std::uint64_t>(offsets[frame] - offsets[frame - 1]) > most_rows)
      throw bad_input({name}, "the number of contacts in a frame is not valid", "less than 2^31",
                      fmt::format("{} in frame {}", offsets[frame] - offsets[frame - 1], frame));
  const std::uint64_t rows = (summary.contacts_given & 1U) != 0 ? summary.columns.front().shape().front() : 0;
  if (static_cast<std::uint64_t>(offsets.back()) > rows)
    throw bad_input({name}, "contacts are missing", fmt::format("{} rows", offsets.back()),
                    fmt::format("{}", rows));
}

}  // namespace

SnapshotSummary summarise_snapshots(const Hdf5File& file, const std::string& name) {
  if (!file.has("/h5md") || !file.has(steps_path) || !file.has("/particles/discs/id/value"))
    throw bad_input({name}, "no snapshots in the file",
                    "/h5md and /particles/discs as mikromakro writes them", "neither");
  SnapshotSummary summary;
  summary.steps = all_of(file, steps_path);
  while (!summary.steps.empty() && summary.steps.back() == snapshot::no_id) summary.steps.pop_back();
  summary.times = times_of(file, summary.steps.size(), name);
  add_discs(file, name, summary);
  check_box(file, name, summary.steps);
  if (!file.has(snapshot::contacts + "offset")) return summary;
  add_contact_columns(file, name, summary);
  add_contact_offsets(file, name, summary);
  return summary;
}

}  // namespace mikromakro
