// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <ostream>

#include "app/commands.h"
#include "app/comparison_report.h"
#include "averaging/window_rows.h"
#include "io/files/output_file.h"
#include "io/files/spool.h"
#include "model/error.h"
#include "options/field_options.h"
#include "options/plausible_options.h"
#include "options/volume_options.h"
#include "options/window_options.h"
#include "verbs/averaging_run.h"
#include "verbs/memory_need.h"
#include "verbs/run_constants.h"
#include "verbs/warnings.h"

namespace mikromakro {
namespace {

struct CompareOptions {
  InputOptions input;
  VolumeOptions volumes;
  FieldChoice fields;
  std::vector<std::string> weights = {"sliced", "centre"};
  std::vector<int> resolutions;
  std::string out;
  RunOptions run;
  WindowOptions windows;
};

void add_options(CLI::App& app, CompareOptions& options) {
  add_input_options(app, options.input);
  add_volume_options(app, options.volumes);
  add_field_options(app, options.fields);
  app.add_option("--weights", options.weights,
                 "W1,W2,...: weights as for --weight of average; the others are compared with the first one; "
                 "default sliced,centre")
      ->delimiter(',');
  app.add_option(
         "--resolutions", options.resolutions,
         "N1,N2,...: numbers of rings, or of columns of the grid (its rows in proportion); default that of "
         "--rings or --grid")
      ->delimiter(',');
  app.add_option("--out", options.out,
                 "FILE.csv: all averages, with weight and resolution as the first columns");
  add_window_options(app, options.windows);
  add_run_options(app, options.run);
}

// The averages computed in one pass.
struct Task {
  VolumeOptions volumes;  // options completed with the constants from the files; likewise the fields
  FieldChoice fields;
  std::vector<int> resolutions;
  std::vector<std::unique_ptr<const Averager>> averagers;  // all weights for each resolution
  FrameSource source;
  std::unique_ptr<OutputFile> out;  // on rank 0, if any
};

// A repeated entry would be compared with itself.
template <typename Value>
void check_list(const std::vector<Value>& values, std::string_view option) {
  for (auto value = values.begin(); value != values.end(); ++value) {
    if (std::find(values.begin(), value, *value) != value)
      throw bad_input({option}, "given twice", "each once", fmt::format("{}", *value));
  }
}

void add_averager(const CompareOptions& options, const VolumeOptions& volumes, Task& task) {
  task.averagers.push_back(make_averager(volumes, fields_of(task.fields, volumes)));
  const Averager& averager = *task.averagers.back();
  FrameSource source = source_of(options.input, averager);
  source.particles_needed |= task.source.particles_needed;
  source.contacts_needed |= task.source.contacts_needed;
  task.source = std::move(source);
}

void take_what_files_say(const CompareOptions& options, const FrameSource& files, Task& task) {
  task.volumes = options.volumes;
  task.fields = options.fields;
  take_height(files, task.volumes.height);
  take_stiffness(files, task.volumes.bulk_types, task.fields);
  take_friction(files, task.fields);
  note_other_runs(files);
}

MemoryNeed memory_need(const CompareOptions& options, const Task& task, const Ranks& ranks) {
  const bool moving = options.windows.moving > 0;
  MemoryNeed need{0, threads_of(options.run, ranks),
                  moving ? static_cast<double>(options.windows.moving) : 0.0};
  for (const auto& averager : task.averagers)
    need.numbers += static_cast<double>(averager->volume_count() * averager->sum_count());
  return need;
}

Task task_of(const CompareOptions& options, const Ranks& ranks) {
  check_windows(options.windows);
  check_list(options.weights, "--weights");
  check_list(options.resolutions, "--resolutions");
  if (options.weights.size() < 2 && options.resolutions.size() < 2)
    throw bad_input({"--weights"}, "there is nothing to compare", "two or more of --weights or --resolutions",
                    "one of each");
  Task task;
  const FrameSource files = frame_source(options.input);
  take_what_files_say(options, files, task);
  task.resolutions = options.resolutions;
  std::vector<VolumeOptions> volumes;
  for (const int resolution : options.resolutions) volumes.push_back(at_resolution(task.volumes, resolution));
  if (volumes.empty()) {
    volumes.push_back(task.volumes);
    task.resolutions.push_back(resolution_of(task.volumes));
  }
  for (VolumeOptions& each : volumes) {
    for (const std::string& weight : options.weights) {
      each.weight = weight;
      add_averager(options, each, task);
    }
  }
  check_use(options.volumes, *task.averagers.front());
  task.source.notes = files.notes;
  check_memory(memory_need(options, task, ranks), volume_option(task.volumes));
  if (!options.out.empty() && !options.out.ends_with(".csv"))
    throw bad_input({"--out"}, "unknown kind of output file", "a name ending in .csv",
                    in_quotes(options.out));
  if (!options.out.empty()) check_outputs({options.out}, files.files());
  if (ranks.first() && !options.out.empty()) task.out = std::make_unique<OutputFile>(options.out);
  return task;
}

// The sums of all averagers concatenated in one row.
Rows all_sums(const Task& task, const Frame& frame) {
  std::vector<double> numbers;
  for (const auto& averager : task.averagers) {
    const Rows sums = averager->frame_sums(frame);
    numbers.insert(numbers.end(), sums.data(), sums.data() + sums.size());
  }
  return Eigen::Map<const Rows>(numbers.data(), 1, static_cast<Eigen::Index>(numbers.size()));
}

// Splits such a row and computes the tables.
Comparison compare(const CompareOptions& options, const Task& task, const Rows& mean) {
  Comparison comparison{options.weights,
                        task.resolutions,
                        {},
                        task.averagers.front()->columns(),
                        task.averagers.front()->volume_sums()};
  Eigen::Index begin = 0;
  for (std::size_t i = 0; i < task.averagers.size(); ++i) {
    const Averager& averager = *task.averagers[i];
    const Eigen::Index size = averager.volume_count() * averager.sum_count();
    const Rows sums =
        Eigen::Map<const Rows>(mean.data() + begin, averager.volume_count(), averager.sum_count());
    begin += size;
    comparison.profiles.push_back({options.weights[i % options.weights.size()],
                                   task.resolutions[i / options.weights.size()], averager.solve(sums)});
  }
  return comparison;
}

Preamble preamble_of(const CompareOptions& options, const Task& task, const Averaged& averaged) {
  Preamble lines = {{"program", "mikromakro " MIKROMAKRO_VERSION " compare"}};
  describe_input(options.input, task.source, averaged.runs.size(), lines);
  describe_fields(task.fields, lines);
  describe_frames(averaged, lines);
  describe_volumes(task.volumes, lines, false, task.averagers.front()->uses_height());
  lines.emplace_back("branch", options.volumes.branch.empty() ? "by the weight" : options.volumes.branch);
  describe_numbers(task.fields, lines);
  return lines;
}

std::string differences(const Comparison& comparison) {
  const std::string resolutions = differences_of_resolutions(comparison);
  return differences_of_weights(comparison) + (resolutions.empty() ? "" : "\n" + resolutions) + "\n" +
         summary_of(comparison);
}

void report(const CompareOptions& options, const Task& task, const Averaged& averaged) {
  const Comparison comparison = compare(options, task, averaged.sums.mean());
  if (task.out) task.out->commit(long_csv(preamble_of(options, task, averaged), comparison));
  fmt::print("{}", differences(comparison));
}

// Compares in each window, on rank 0; prints at the end.
class WindowComparisons {
 public:
  WindowComparisons(const CompareOptions& options, const Task& task)
      : options_(options),
        task_(task),
        windows_(rule_of(options.windows), 0, [this](const Window& window) { take(window); }) {
    if (task.out) rows_.emplace();
  }

  void add(const FrameSums& frame) { windows_.add(frame); }

  void finish(const Averaged& averaged) {
    windows_.finish();
    Notes notes;
    check_windows(options_.windows, windows_, notes);
    tell(notes);
    differences_.copy_to(std::cout);
    std::cout.flush();
    if (!task_.out) return;
    Preamble lines = preamble_of(options_, task_, averaged);
    describe_windows(options_.windows, windows_.windows(), lines);
    describe_notes(notes, lines);
    const std::string head =
        long_head(lines, compare(options_, task_, averaged.sums.mean()), window_columns(several_runs()));
    task_.out->commit([&](std::ostream& stream) {
      stream << head;
      rows_->copy_to(stream);
    });
  }

 private:
  bool several_runs() const { return !task_.source.further_runs.empty(); }

  void take(const Window& window) {
    const Comparison comparison = compare(options_, task_, window.sums.mean());
    const std::string of_run = several_runs() ? fmt::format(" of run {}", window.run + 1) : "";
    differences_.add(fmt::format("steps {} to {}{}\n{}\n", window.first_step, window.last_step, of_run,
                                 differences(comparison)));
    if (rows_) rows_->add(long_rows(comparison, window_numbers(window, several_runs())));
  }

  const CompareOptions& options_;
  const Task& task_;
  Spool differences_;
  std::optional<Spool> rows_;  // of the output file
  Windows windows_;
};

void compare(const CompareOptions& options, const Ranks& ranks) {
  Task task;
  ranks.agree([&] { task = task_of(options, ranks); });
  std::vector<VolumeOptions> weighted(options.weights.size(), task.volumes);
  for (std::size_t i = 0; i < weighted.size(); ++i) weighted[i].weight = options.weights[i];
  const SumFrame sum = [&](const Frame& frame) {
    check_time(frame, task.source.files().front(), options.windows.time_step);
    for (const VolumeOptions& volumes : weighted) note_volumes(frame, volumes, *task.source.notes);
    return all_sums(task, frame);
  };
  std::optional<WindowComparisons> windows;
  TakeSums also;
  if (options.windows.any() && ranks.first()) {
    windows.emplace(options, task);
    also = [&](const FrameSums& frame) { windows->add(frame); };
  }
  const Averaged averaged =
      average_frames(task.source, task.volumes, sum, TimeAverage(0), options.run, ranks, also);
  ranks.agree([&] {
    if (ranks.first()) windows ? windows->finish(averaged) : report(options, task, averaged);
  });
}

}  // namespace

void add_compare_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "compare", "differences between weights and resolutions, field by field, from one pass over the input");
  auto options = std::make_shared<CompareOptions>();
  add_options(*app, *options);
  app->callback([options] {
    const Ranks ranks;
    reading_again(options->input, [&] { compare(*options, ranks); });
  });
}

}  // namespace mikromakro
