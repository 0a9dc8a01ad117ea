// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/audit_windows.h"

#include <fmt/format.h>

#include <cmath>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "averaging/window_rows.h"
#include "model/error.h"
#include "verbs/audits.h"
#include "verbs/run_constants.h"
#include "verbs/warnings.h"

namespace mikromakro {
namespace {

// Each window has an audit of its own, which is open from its first frame to its last.
class WindowAudits {
 public:
  WindowAudits(const AuditOptions& options, MakeAuditor make, bool several_runs)
      : options_(options),
        make_(make),
        several_runs_(several_runs),
        rule_(rule_of(options.windows)),
        windows_(rule_, 0, [this](const Window& window) { take(window); }) {}

  bool add(const Frame& frame, Notes& notes) {
    if (frame.run != run_) open_.clear();
    run_ = frame.run;
    if (rule_.moving || open_.empty()) open_.push_back(make_(options_));
    bool covered = false;
    for (const auto& audit : open_) covered = audit->add(frame, notes);
    FrameSums counted;  // the audits keep the sums
    counted.index = frame.index;
    counted.step = frame.step;
    counted.run = frame.run;
    counted.time = frame.time;
    windows_.add(counted);
    return covered;
  }

  const Windows& finish() {
    windows_.finish();
    return windows_;
  }

  const Table& table() const { return table_; }
  // Balances that are unknown in some windows, with the reason in the first of these.
  void describe_unknown(Preamble& lines) const {
    for (const Unknown& unknown : unknown_)
      if (unknown.windows > 0)
        lines.emplace_back("nan", fmt::format("{} in {} of {} windows: {}", unknown.name, unknown.windows,
                                              windows_.windows(), unknown.reason));
  }
  // The first of the balances that are off, with its window.
  const std::optional<Error>& off() const { return off_; }

 private:
  struct Unknown {
    std::string name;
    std::int64_t windows = 0;
    std::string reason;
  };

  void take(const Window& window) {
    const Balances balances = open_.front()->balances();
    open_.pop_front();
    const Eigen::ArrayXd numbers = window_numbers(window, several_runs_);
    if (table_.columns.empty()) begin(balances);
    table_.rows.conservativeResize(table_.rows.rows() + 1, std::ssize(table_.columns));
    auto row = table_.rows.row(table_.rows.rows() - 1);
    row.head(numbers.size()) = numbers.transpose();
    for (std::size_t i = 0; i < balances.size(); ++i) {
      row[numbers.size() + static_cast<Eigen::Index>(i)] = balances[i].value;
      if (std::isnan(balances[i].value) && unknown_[i].windows++ == 0) unknown_[i].reason = balances[i].text;
    }
    check(window, balances);
  }

  void begin(const Balances& balances) {
    table_.columns = window_columns(several_runs_);
    for (const Balance& balance : balances) {
      table_.columns.push_back({balance.name, "1", "-", "balance of the window, docs/manual/audit.md"});
      unknown_.push_back({balance.name, 0, ""});
    }
  }

  void check(const Window& window, const Balances& balances) {
    if (off_) return;
    try {
      check_bound(balances, options_.bound);
    } catch (const Error& error) {
      off_.emplace(error.kind(),
                   fmt::format("steps {} to {}: {}", window.first_step, window.last_step, error.what()));
    }
  }

  const AuditOptions& options_;
  MakeAuditor make_;
  bool several_runs_;
  WindowRule rule_;
  std::deque<std::unique_ptr<Auditor>> open_;
  Table table_;
  std::vector<Unknown> unknown_;  // in the order of the balances
  std::optional<Error> off_;
  std::int64_t run_ = -1;
  Windows windows_;
};

}  // namespace

AuditReport audit_windows(const AuditOptions& options, MakeAuditor make) {
  const FrameSource source = make(options)->source();
  WindowAudits audits(options, make, !source.further_runs.empty());
  read_frames(source, options, [&](const Frame& frame) {
    check_time(frame, source.files().front(), options.windows.time_step);
    return audits.add(frame, *source.notes);
  });
  Notes notes;
  const Windows& windows = audits.finish();
  check_windows(options.windows, windows, notes);
  tell(notes);
  Preamble lines = {{"program", "mikromakro " MIKROMAKRO_VERSION " audit"}};
  describe_input(options.input, source, source.runs().size(), lines);
  describe_notes(notes, lines);
  describe_windows(options.windows, windows.windows(), lines);
  if (of_rings(options.volumes) || !options.volumes.box.empty()) {
    VolumeOptions volumes = options.volumes;
    volumes.height = 0;  // of which ratios do not depend
    describe_volumes(volumes, lines, false, false);
  }
  audits.describe_unknown(lines);
  const Table& table = audits.table();
  return {{}, csv_text(lines, table), json_of(table), lines, table, audits.off()};
}

}  // namespace mikromakro
