// SPDX-License-Identifier: GPL-2.0-or-later
// Options that say over what is averaged, and how discs count there. Shared by the verbs that average.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "averaging/averager.h"
#include "io/tables/csv_writer.h"

namespace mikromakro {

struct VolumeOptions {
  std::vector<double> rings, center, edges, grid, box;  ///< no centre: the origin
  int sectors = 0;                                      ///< 0: whole rings
  std::string weight = "sliced", branch;                ///< no branch: the one that goes with the weight
  double height = 0;                                    ///< 0: not known
  std::vector<int> bulk_types;
};

void add_volume_options(CLI::App& app, VolumeOptions& options);
/// Beside them, where one weight is chosen; `choice` is the help.
void add_weight_option(CLI::App& app, VolumeOptions& options, const std::string& choice = {});

/// Number of rings, or of columns of a grid.
int resolution_of(const VolumeOptions& options);
/// The same volumes with another one; the rows of a grid in proportion. Throws for volumes other than --rings
/// and
/// --grid, and for resolutions below 1.
VolumeOptions at_resolution(const VolumeOptions& options, int resolution);

/// W of --weight NAME:W (m); 0 where it is no kernel.
double kernel_width(const VolumeOptions& options);

/// The height, 1 where it is not known.
double thickness(const VolumeOptions& options);

/// The option that gives the volumes, for messages.
std::string_view volume_option(const VolumeOptions& options);

/// Whether the volumes are a sequence of whole rings, which some fields need.
bool are_rings(const VolumeOptions& options);

/// The averager that the options ask for. Throws on options that contradict each other or have no meaning.
std::unique_ptr<const Averager> make_averager(const VolumeOptions& options, FieldList fields);

/// The radii of the rings' edges, of --rings or --edges (m). Throws where the volumes are rectangles.
std::vector<double> ring_edges(const VolumeOptions& options);
Eigen::Vector2d ring_centre(const VolumeOptions& options);

/// The branch vectors that count, `radius` or `contact`, given or those of the weight.
std::string branch_name(const VolumeOptions& options);

/// Lines above a table: the volumes, and the discs; where one weight is chosen, how these count.
void describe_volumes(const VolumeOptions& options, Preamble& lines, bool with_weight = true);

}  // namespace mikromakro
