// SPDX-License-Identifier: GPL-2.0-or-later
// `audit`: balances over rings or a box.
#pragma once

#include <memory>

#include "verbs/audit_input.h"
#include "verbs/audit_report.h"

namespace mikromakro {

/// Whether the volumes are rings.
bool of_rings(const VolumeOptions& volumes);

/// Checks --wheel-types and --margin against the volumes.
void check_wheel_and_margin(const AuditOptions& options);
void check_wheel_is_no_bulk(const AuditOptions& options);

/// Completes the options from the files, and checks that what they refer to exists.
void complete(AuditOptions& options);

/// The sums of one audit.
class Auditor {
 public:
  Auditor() = default;
  Auditor(const Auditor&) = delete;
  Auditor& operator=(const Auditor&) = delete;
  virtual ~Auditor() = default;

  /// What to read for it.
  virtual FrameSource source() const = 0;
  /// Adds a frame; whether any averaged disc lies in the volumes.
  virtual bool add(const Frame& frame, Notes& notes) = 0;
  /// Of all frames so far.
  virtual Balances balances() const = 0;
};

std::unique_ptr<Auditor> ring_auditor(const AuditOptions& options);
std::unique_ptr<Auditor> box_auditor(const AuditOptions& options);

/// Torque, radial momentum, forces on discs, volume over rings.
AuditReport audit_rings(const AuditOptions& options);

/// Stress of volume and walls, forces on discs and walls, volume, momentum of cells: for --box, --grid or,
/// with neither, the rectangle between the walls of each frame.
AuditReport audit_box(const AuditOptions& options);

/// Either of them, as the options have it, or of windows of frames; what the options leave open is taken from
/// the files.
AuditReport audit(AuditOptions options);

}  // namespace mikromakro
