// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/window_averages.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/warnings.h"

namespace mikromakro {

WindowAverages::WindowAverages(const AverageOptions& options, const WindowOptions& windows,
                               const Averager& averager, const FrameSource& source)
    : options_(options),
      rule_(windows),
      averager_(averager),
      rows_(averager, {options.error_blocks != 0, !source.further_runs.empty(), source.walls}),
      outputs_(OutputFiles(options.out, source.files()), rows_.columns(), ring_centre(options.volumes)),
      windows_(rule_of(windows), error_blocks(options, averager),
               [this](const Window& window) { take(window); }) {
  for (const ColumnsOfField& field : averager.columns_of_fields()) with_errors_[field.name] = 0;
}

void WindowAverages::take(const Window& window) {
  const WindowRows::Of rows = rows_.of(window);
  for (const FieldErrors& made : rows.errors.fields)
    if (made.decision.given) ++with_errors_[made.field.name];
  outputs_.add(rows.numbers, rows.values);
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

void WindowAverages::write(const Averaged& averaged, Preamble lines) {
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
}

}  // namespace mikromakro
