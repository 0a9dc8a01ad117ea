// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/audit_input.h"

#include <cmath>

#include "io/files/file_list.h"
#include "model/error.h"
#include "options/plausible_options.h"
#include "options/value_checks.h"
#include "verbs/coverage.h"
#include "verbs/progress.h"
#include "verbs/runs_used.h"
#include "verbs/warnings.h"

namespace mikromakro {
namespace {

// Without volumes the audit is of the region between the walls.
bool are_given(const VolumeOptions& volumes) {
  return !(volumes.rings.empty() && volumes.edges.empty() && volumes.box.empty() && volumes.grid.empty());
}

}  // namespace

void add_audit_options(CLI::App& app, AuditOptions& options) {
  add_input_options(app, options.input);
  add_volume_options(app, options.volumes);
  // The best default depends on the volumes.
  options.volumes.weight.clear();
  add_weight_option(app, options.volumes,
                    "sliced (default for rings), centre (default for --grid), or a kernel of width W in m: "
                    "gauss:W, lucy:W, wendland:W, tophat:W; one box: centre");
  app.add_option("--wheel-types", options.wheel_types,
                 "types of the discs that form the wheel; the inner wall is part of it, too (rings)")
      ->delimiter(',');
  app.add_option("--margin", options.margin,
                 "rings nearer than this to the first and last edge are shown but not judged (m), default 0")
      ->check(not_negative());
  app.add_option("--kn", options.kn,
                 "normal stiffness k_n (N/m): forces between discs are compared with k_n overlap; default "
                 "that of the snapshots")
      ->check(positive());
  app.add_option("--bound", options.bound, "exit code 1 when a balance is off by more than this fraction")
      ->check(not_negative());
  add_window_options(app, options.windows);
  app.add_flag("--json", options.json, "print JSON");
  app.add_flag("--quiet", options.quiet, "no progress bar");
}

std::int64_t read_frames(const FrameSource& source, const AuditOptions& options, const TakeFrame& take) {
  Progress progress(total_size(source.files()), options.quiet);
  FrameStream stream(source);
  Frame frame;
  std::int64_t frames = 0;
  RunsUsed runs(1 + source.further_runs.size());
  while (stream.next(frame)) {
    const bool covered = take(frame);
    runs.add(frame.run, !covered);
    note_volumes(frame, options.volumes, *source.notes);
    note_stiffness(frame, options.kn, options.kn_given, *source.notes);
    progress.update(stream.bytes_read(), ++frames);
  }
  if (frames > 0) {
    note_unused_runs(source, runs);
    note_unlike_runs(source);
    VolumeOptions volumes = options.volumes;
    volumes.weight = "sliced";
    if (runs.any_zero() && are_given(volumes)) note_empty_frames(source, volumes, runs.all_zero());
  }
  tell(*source.notes);
  if (frames == 0) throw source.no_frame_selected();
  return frames;
}

}  // namespace mikromakro
