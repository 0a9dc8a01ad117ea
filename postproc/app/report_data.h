// SPDX-License-Identifier: GPL-2.0-or-later
// Texts and tables of a page.
#pragma once

#include <CLI/CLI.hpp>

#include "io/frames/frame_stream.h"
#include "io/tables/csv_writer.h"
#include "io/tables/json.h"
#include "options/average_options.h"
#include "verbs/audit_input.h"

namespace mikromakro {

/// The names of the files without their folders.
std::string title_of(const FrameSource& source);

/// Kind of the volumes, centre of rings, and the columns that describe each volume.
Json volumes_json(const Averager& averager, const VolumeOptions& options);

/// The header lines of the table that `average` would write, after `lines`.
Json parameters_json(const AverageOptions& options, const Averager& averager, const Averaged& averaged,
                     const BlockErrors& errors, Preamble lines);

/// The constants in the snapshot files.
Json constants_json(const FrameSource& source);

/// Command lines of what the page shows; the page adds the frames. `stride`: of the selected frames.
Json commands_json(const CLI::App& app, const AuditOptions& audit, std::int64_t stride);

}  // namespace mikromakro
