// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/audit_input.h"

#include "app/progress.h"
#include "app/runs_used.h"
#include "app/warnings.h"
#include "io/files/file_list.h"
#include "model/error.h"
#include "options/value_checks.h"

namespace mikromakro {

void add_audit_options(CLI::App& app, AuditOptions& options) {
  add_input_options(app, options.input);
  add_volume_options(app, options.volumes);
  // The best default depends on the volumes.
  options.volumes.weight.clear();
  add_weight_option(app, options.volumes,
                    "sliced (default for rings), centre (default for --grid), or a kernel of width W in m: "
                    "gauss:W, lucy:W, wendland:W, tophat:W; one box: centre");
  app.add_option("--wheel-types", options.wheel_types,
                 "types of the wheel's discs; the inner wall counts too (rings)")
      ->delimiter(',');
  app.add_option("--margin", options.margin,
                 "rings nearer than this to the first and last edge are shown but not judged (m), default 0")
      ->check(not_negative());
  app.add_option("--kn", options.kn,
                 "normal stiffness k_n (N/m): forces of discs are set beside k_n overlap; default that of "
                 "the snapshots")
      ->check(positive());
  app.add_option("--bound", options.bound, "exit code 1 when a balance is off by more than this part")
      ->check(not_negative());
  app.add_flag("--json", options.json, "print JSON");
  app.add_flag("--quiet", options.quiet, "no progress bar");
}

std::int64_t read_frames(const FrameSource& source, bool quiet,
                         const std::function<void(const Frame&)>& take) {
  Progress progress(total_size(source.files()), quiet);
  FrameStream stream(source);
  Frame frame;
  std::int64_t frames = 0;
  RunsUsed runs(1 + source.further_runs.size());
  while (stream.next(frame)) {
    take(frame);
    runs.add(frame.run);
    progress.update(stream.bytes_read(), ++frames);
  }
  if (frames > 0) {
    note_unused_runs(source, runs);
    note_unlike_runs(source);
  }
  tell(*source.notes);
  if (frames == 0) throw source.no_frame_selected();
  return frames;
}

}  // namespace mikromakro
