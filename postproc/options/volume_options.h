// SPDX-License-Identifier: GPL-2.0-or-later
// Options for the averaging volumes and the weight of discs, shared by all verbs that average.
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
  std::string components = {};                          ///< cartesian, or none: polar for rings
  std::string weight = "sliced", branch;                ///< no branch: the one implied by the weight
  double height = 0;                                    ///< 0: not known
  std::vector<int> bulk_types;
};

void add_volume_options(CLI::App& app, VolumeOptions& options);
/// Adds --components, for verbs that write components of rings and sectors.
void add_components_option(CLI::App& app, VolumeOptions& options);
/// Adds --weight, for verbs that use a single weight; `choice` is its help text.
void add_weight_option(CLI::App& app, VolumeOptions& options, const std::string& choice = {});

/// Number of rings, or of grid columns.
int resolution_of(const VolumeOptions& options);
/// The same volumes at another resolution; the rows of a grid are scaled in proportion. Throws for volumes
/// other than --rings and --grid, and for resolutions below 1.
VolumeOptions at_resolution(const VolumeOptions& options, int resolution);

/// W of --weight NAME:W (m); 0 if the weight is not a kernel.
double kernel_width(const VolumeOptions& options);

/// The height, or 1 if not known.
double thickness(const VolumeOptions& options);

/// From 1/200 of a radius (sheets) to 100 radii (rods).
bool is_plausible_height(double height, double radius);

/// The option that defines the volumes, for messages.
std::string_view volume_option(const VolumeOptions& options);

/// Whether the volumes are a sequence of whole rings with polar components, which some fields need.
bool are_rings(const VolumeOptions& options);

/// The averager for these options. Throws on contradictory or meaningless options.
std::unique_ptr<const Averager> make_averager(const VolumeOptions& options, FieldList fields,
                                              const GivenValues& given = {});

/// Edge radii of the rings, from --rings or --edges (m). Throws if the volumes are rectangles.
std::vector<double> ring_edges(const VolumeOptions& options);
Eigen::Vector2d ring_centre(const VolumeOptions& options);

/// The branch vectors in use, `radius` or `contact`: as given, or as implied by the weight.
std::string branch_name(const VolumeOptions& options);

/// Header lines of a table: the volumes and the discs; if a single weight is used, how discs count; that
/// there is no height, if it is needed.
void describe_volumes(const VolumeOptions& options, Preamble& lines, bool with_weight, bool needs_height);

}  // namespace mikromakro
