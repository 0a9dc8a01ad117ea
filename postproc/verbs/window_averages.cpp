// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/window_averages.h"

#include <fmt/format.h>

#include <algorithm>

#include "verbs/warnings.h"

namespace mikromakro {
namespace {

OutputFiles output_files(const std::vector<std::string>& names, const std::vector<std::string>& inputs,
                         bool to_stdout) {
  OutputFiles files(names, inputs);
  if (names.empty()) files.to_stdout = to_stdout;
  return files;
}

}  // namespace

WindowAverages::WindowAverages(const AverageOptions& options, const WindowOptions& windows,
                               const Averager& averager, const FrameSource& source, bool keeps_table)
    : options_(options),
      rule_(windows),
      averager_(averager),
      rows_(averager, {options.error_blocks != 0, !source.further_runs.empty(), source.walls}),
      outputs_(output_files(options.out, source.files(), !keeps_table), rows_.columns(),
               ring_centre(options.volumes)),
      windows_(rule_of(windows), error_blocks(options, averager),
               [this](const Window& window) { take(window); }) {
  for (const ColumnsOfField& field : averager.columns_of_fields()) with_errors_[field.name] = 0;
  if (keeps_table) table_.emplace(rows_.columns());
}

void WindowAverages::take(const Window& window) {
  const WindowRows::Of rows = rows_.of(window);
  for (const FieldErrors& made : rows.errors.fields)
    if (made.decision.given) ++with_errors_[made.field.name];
  outputs_.add(rows.numbers, rows.values);
  if (table_) table_->add(rows.numbers, rows.values);
}

void WindowAverages::describe_errors(Preamble& lines) const {
  if (options_.error_blocks == 0) return;
  const bool any = std::any_of(with_errors_.begin(), with_errors_.end(),
                               [](const auto& field) { return field.second > 0; });
  lines.emplace_back("errors", any ? "standard errors of each window, by the jackknife of its frames"
                                   : "nan: the frames of no window are enough for standard errors");
  if (!any) return;
  for (const ColumnsOfField& field : averager_.columns_of_fields())
    lines.emplace_back("errors of", fmt::format("{}: in {} of {} windows", field.name,
                                                with_errors_.at(field.name), windows_.windows()));
}

AveragedTable WindowAverages::write(const Averaged& averaged, Preamble lines) {
  windows_.finish();
  Notes notes;
  check_windows(rule_, windows_, notes);
  tell(notes);
  describe_notes(notes, lines);
  const Rows mean = averaged.sums.mean();
  describe_fields(options_.fields, lines);
  describe_frames(averaged, lines);
  describe_windows(rule_, windows_.windows(), lines);
  describe_volumes(options_.volumes, lines, true, averager_.uses_height());
  describe_numbers(options_.fields, lines);
  for (const std::string& note : averager_.notes(mean)) lines.emplace_back("note", note);
  describe_errors(lines);
  outputs_.commit(lines);
  return {std::move(lines), table_ ? table_->table() : Table(), {}};
}

}  // namespace mikromakro
