// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/run_constants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "io/snapshot/snapshot_parameters.h"
#include "io/snapshot/snapshot_summary.h"
#include "model/error.h"

namespace mikromakro {
namespace {

// A constant as stored in a file.
struct Held {
  std::string file;
  double value = 0;
};

std::vector<std::pair<std::string, RunConstants>> constants_of(const FrameSource& source) {
  std::vector<std::pair<std::string, RunConstants>> all;
  for (const Run& run : source.runs()) {
    for (const std::string& file : run.snapshot_files) {
      all.emplace_back(file, read_constants(Hdf5File::open(file), file));
      const std::string& units = all.back().second.units;
      if (!units.empty() && units != "si")
        throw bad_input({file}, "the run uses other units", "units si", in_quotes(units));
    }
  }
  return all;
}

// Equal to single precision: options repeat the numbers of scripts, files what engines made of them.
bool same(double a, double b) {
  constexpr double digits = 1e-6;
  return std::abs(a - b) <= digits * std::abs(a);
}

// The value that all files agree on; a given option takes precedence.
void settle(const std::vector<Held>& held, std::string_view option, std::string_view unit, double& value,
            Notes& notes) {
  const bool given = value > 0;
  for (const Held& one : held) {
    if (value == 0) value = one.value;
    if (same(one.value, value)) continue;
    if (!given)
      throw bad_input({one.file}, fmt::format("the files disagree on {}", option),
                      fmt::format("{} {} as in {}, or the option", value, unit, held.front().file),
                      fmt::format("{}", one.value));
    notes.add(
        fmt::format("{} {} {} is used, but {} says {} {}", option, value, unit, one.file, one.value, unit));
  }
}

// k_n of all pairs that involve an averaged disc.
std::set<double> stiffnesses(const RunConstants& constants, const std::vector<int>& bulk_types) {
  const auto types = static_cast<std::size_t>(
      std::lround(std::sqrt(static_cast<double>(constants.normal_stiffness.size()))));
  std::set<double> values;
  for (std::size_t i = 0; i < types; ++i) {
    const bool averaged = bulk_types.empty() || std::find(bulk_types.begin(), bulk_types.end(),
                                                          static_cast<int>(i) + 1) != bulk_types.end();
    for (std::size_t j = 0; averaged && j < types; ++j)
      values.insert(constants.normal_stiffness[i * types + j]);
  }
  return values;
}

// From the first to the last frame; nan if there is one frame.
double time_step_of(const SnapshotSummary& summary) {
  return (summary.times.back() - summary.times.front()) /
         static_cast<double>(summary.steps.back() - summary.steps.front());
}

bool takes_stiffness(const FieldChoice& fields) {
  const std::vector<std::string>& names = fields.names;
  return names.empty() || std::any_of(names.begin(), names.end(), [](const std::string& name) {
           return name == "all" || name == "stiffness";
         });
}

}  // namespace

void take_height(const FrameSource& source, double& height) {
  std::vector<Held> held;
  for (const auto& [file, constants] : constants_of(source))
    if (constants.height > 0) held.push_back({file, constants.height});
  settle(held, "--height", "m", height, *source.notes);
}

void take_stiffness(const FrameSource& source, const std::vector<int>& bulk_types, FieldChoice& fields) {
  std::vector<Held> held;
  for (const auto& [file, constants] : constants_of(source)) {
    const std::set<double> values = stiffnesses(constants, bulk_types);
    if (values.size() == 1) held.push_back({file, *values.begin()});
    if (constants.nonlinear && fields.numbers.normal_stiffness > 0)
      source.notes->add(
          fmt::format("--kn {} N/m is used, but {} is of a law that is not linear, whose kn is in {}",
                      fields.numbers.normal_stiffness, file, constants.unit_of_stiffness));
    if (values.size() > 1 && fields.numbers.normal_stiffness == 0 && takes_stiffness(fields))
      source.notes->add(
          fmt::format("{}: k_n is {} to {} N/m, by the types that touch: E and G are not in units of k_n/h",
                      file, *values.begin(), *values.rbegin()));
  }
  double stiffness = fields.numbers.normal_stiffness;
  settle(held, "--kn", "N/m", stiffness, *source.notes);
  fields.stiffness_of_run = stiffness;
}

void take_friction(const FrameSource& source, FieldChoice& fields) {
  double& mu = fields.numbers.friction_coefficient;
  const bool wanted =
      std::find(fields.names.begin(), fields.names.end(), "sliding_fraction") != fields.names.end();
  for (const auto& [file, constants] : constants_of(source)) {
    const auto& all = constants.friction;
    const bool one = std::all_of(all.begin(), all.end(), [&](double value) { return same(value, all[0]); });
    if (mu == 0 && wanted && one && !all.empty()) mu = all[0];
    const auto is_mu = [mu](double value) { return same(value, mu); };
    const auto other = std::find_if_not(all.begin(), all.end(), is_mu);
    if (mu == 0 || other == all.end()) continue;
    if (std::any_of(all.begin(), all.end(), is_mu))
      source.notes->add(fmt::format("--mu {} is used for all contacts, but in {} other types have mu = {}",
                                    mu, file, *other));
    else
      source.notes->add(fmt::format("--mu {} is used, but {} says {}", mu, file, *other));
  }
}

void note_other_runs(const FrameSource& source) {
  const auto all = constants_of(source);
  if (all.size() < 2) return;
  const RunConstants& there = all.front().second;
  // Converted files do not hold the constants of their run.
  const auto differ = [](const std::vector<double>& a, const std::vector<double>& b) {
    return !a.empty() && !b.empty() && !std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
  };
  for (const auto& one : all) {
    const RunConstants& constants = one.second;
    const auto note = [&](const std::string& what) {
      source.notes->add(
          fmt::format("{} is from a different run than {}: {}", one.first, all.front().first, what));
    };
    if (!constants.law.empty() && !there.law.empty() && constants.law != there.law)
      note(fmt::format("{}, there {}", constants.law, there.law));
    if (differ(constants.normal_stiffness, there.normal_stiffness)) note("other k_n");
    if (differ(constants.friction, there.friction)) note("other mu");
  }
  for (const Run& run : source.runs()) {
    double last = not_given, step_before = not_given;
    for (const std::string& file : run.snapshot_files) {
      const SnapshotSummary summary = summarise_snapshots(Hdf5File::open(file), file);
      const std::vector<double>& times = summary.times;
      if (times.empty()) continue;
      // Engines count time anew after a restart, with the same time step.
      const double time_step = time_step_of(summary);
      const bool other_step = !same(time_step, step_before);
      step_before = time_step;
      if (times.front() < last && other_step)
        source.notes->add(
            fmt::format("{}: times go back to {} s from {} s, though steps increase (another run, or another "
                        "time step? runs are --snapshots each)",
                        file, times.front(), last));
      last = times.back();
    }
  }
}

void note_unrecorded_walls(const FrameSource& source) {
  for (const auto& [file, constants] : constants_of(source))
    if (!constants.unrecorded_walls.empty())
      source.notes->add(
          fmt::format("{}: contacts with {} are not in the rows, and stresses near these lack them", file,
                      constants.unrecorded_walls));
}

void note_time(const Frame& frame, double& last, Notes& notes) {
  if (frame.time < last) notes.add("times go back, though steps increase (time reset?)", frame.step);
  last = frame.time;
}

void check_time(const Frame& frame, const std::string& file, double time_step) {
  constexpr double digits = 1e-5;
  const double wanted = time_step * static_cast<double>(frame.step);
  if (time_step == 0 || std::isnan(frame.time) || std::abs(frame.time - wanted) <= digits * std::abs(wanted))
    return;
  throw bad_input({"--timestep"}, "the file has times of its own, which differ",
                  fmt::format("{} s in step {} of {}, or no --timestep", frame.time, frame.step, file),
                  fmt::format("{} s", wanted));
}

}  // namespace mikromakro
