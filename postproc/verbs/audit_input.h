// SPDX-License-Identifier: GPL-2.0-or-later
// Input of the audits, and their common options.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "options/volume_options.h"
#include "options/window_options.h"
#include "verbs/audit_report.h"
#include "verbs/input_options.h"

namespace mikromakro {

struct AuditOptions {
  InputOptions input;
  VolumeOptions volumes;
  std::vector<int> wheel_types;
  double margin = 0;
  double kn = std::numeric_limits<double>::quiet_NaN();
  bool kn_given = false;  ///< by the user, not by the files
  double bound = std::numeric_limits<double>::quiet_NaN();
  AuditUnits units;
  WindowOptions windows;
  bool json = false;
  bool quiet = false;
};

void add_audit_options(CLI::App& app, AuditOptions& options);

/// Adds a frame; whether any averaged disc lies in the volumes.
using TakeFrame = std::function<bool(const Frame&)>;

/// Passes the frames to `take` one by one and returns their number. Throws on read errors, and if no frame
/// was selected; notes runs and frames without discs in the volumes, and a k_n of another order than the
/// forces.
std::int64_t read_frames(const FrameSource& source, const AuditOptions& options, const TakeFrame& take);

}  // namespace mikromakro
