// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/error.h"
#include "verbs/audit_windows.h"
#include "verbs/audits.h"
#include "verbs/coverage.h"
#include "verbs/run_constants.h"
#include "verbs/warnings.h"

namespace mikromakro {
namespace {

void check_in_one_list(const AuditOptions& options) {
  const std::vector<int>& bulk = options.volumes.bulk_types;
  for (const int type : options.wheel_types)
    if (std::find(bulk.begin(), bulk.end(), type) != bulk.end())
      throw bad_input({"--wheel-types"}, "discs of the wheel are walls and are not averaged",
                      "types that are not in --bulk-types", fmt::format("{} in both", type));
}

void check_box(const AuditOptions& options) {
  if (!options.wheel_types.empty())
    throw bad_input({"--wheel-types"}, "a box has no wheel", "--rings or --edges", "neither");
  if (options.margin > 0)
    throw bad_input({"--margin"}, "a box is judged up to its edges", "--rings or --edges", "neither");
}

}  // namespace

bool of_rings(const VolumeOptions& volumes) {
  return !volumes.rings.empty() || !volumes.edges.empty();
}

void check_wheel_and_margin(const AuditOptions& options) {
  check_in_one_list(options);
  if (!of_rings(options.volumes)) check_box(options);
}

// Without --bulk-types all discs are averaged: the wheel would then contribute to the stresses, but not to
// its own torque.
void check_wheel_is_no_bulk(const AuditOptions& options) {
  if (!options.wheel_types.empty() && options.volumes.bulk_types.empty())
    throw bad_input({"--wheel-types"}, "the discs of the wheel would be averaged, too",
                    "--bulk-types as well, without those of the wheel", "none");
}

void complete(AuditOptions& options) {
  check_windows(options.windows);
  check_wheel_and_margin(options);
  const FrameSource source = frame_source(options.input);
  take_height(source, options.volumes.height);
  note_other_runs(source);
  note_unrecorded_walls(source);
  if (options.volumes.height == 0) options.units = {"N/m", "m^2"};
  options.volumes.height = thickness(options.volumes);
  FieldChoice stiffness{{"stress"}, {}};
  options.kn_given = !std::isnan(options.kn);
  if (options.kn_given) stiffness.numbers.normal_stiffness = options.kn;
  take_stiffness(source, options.volumes.bulk_types, stiffness);
  if (stiffness.stiffness_of_run > 0) options.kn = stiffness.stiffness_of_run;
  VolumeOptions volumes = options.volumes;
  volumes.weight = "sliced";
  check_before(source, volumes, of_rings(volumes) ? options.wheel_types : std::vector<int>());
  check_wheel_is_no_bulk(options);
  tell(*source.notes);
}

AuditReport audit(AuditOptions options) {
  complete(options);
  const bool rings = of_rings(options.volumes);
  AuditReport report;
  reading_again(options.input, [&] {
    report = options.windows.any() ? audit_windows(options, rings ? ring_auditor : box_auditor)
             : rings               ? audit_rings(options)
                                   : audit_box(options);
  });
  return report;
}

}  // namespace mikromakro
