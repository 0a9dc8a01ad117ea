// SPDX-License-Identifier: GPL-2.0-or-later
// Input of the audits, and their common options.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "app/audit_report.h"
#include "app/input_options.h"
#include "options/volume_options.h"

namespace mikromakro {

struct AuditOptions {
  InputOptions input;
  VolumeOptions volumes;
  std::vector<int> wheel_types;
  double margin = 0;
  double kn = std::numeric_limits<double>::quiet_NaN();
  double bound = std::numeric_limits<double>::quiet_NaN();
  AuditUnits units;
  bool json = false;
  bool quiet = false;
};

void add_audit_options(CLI::App& app, AuditOptions& options);

/// Passes the frames to `take` one by one and returns their number. Throws on read errors, and if no frame
/// was selected.
std::int64_t read_frames(const FrameSource& source, bool quiet,
                         const std::function<void(const Frame&)>& take);

}  // namespace mikromakro
