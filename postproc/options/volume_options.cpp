// SPDX-License-Identifier: GPL-2.0-or-later
#include "options/volume_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstdlib>

#include "averaging/volumes/cartesian_components.h"
#include "averaging/volumes/grid_volumes.h"
#include "averaging/volumes/ring_volumes.h"
#include "averaging/volumes/sector_volumes.h"
#include "model/error.h"
#include "options/value_checks.h"

namespace mikromakro {
namespace {

Branch branch_of(const std::string& name) {
  if (name.empty()) return Branch::by_weight;
  if (name == "radius") return Branch::radius;
  if (name == "contact") return Branch::contact;
  throw bad_input({"--branch"}, "unknown branch vector", "radius or contact", in_quotes(name));
}

constexpr double most_volumes = 1e6;

int count_of(double count, std::string_view option, std::string_view what) {
  if (count != std::floor(count) || count < 1 || count > most_volumes)
    throw bad_input({option}, fmt::format("not a number of {}", what), "a whole number N, 1 to 1000000",
                    fmt::format("{}", count));
  return static_cast<int>(count);
}

void check_total(double volumes, std::string_view option) {
  if (volumes > most_volumes)
    throw bad_input({option}, "too many volumes", "1000000 or fewer", fmt::format("{}", volumes));
}

std::unique_ptr<const Volumes> grid_of(const VolumeOptions& options) {
  const auto& grid = options.grid;
  const int columns = count_of(grid[2], "--grid", "columns");
  const int rows = count_of(grid[5], "--grid", "rows");
  check_total(grid[2] * grid[5], "--grid");
  return std::make_unique<const GridVolumes>(equal_grid_edges(grid[0], grid[1], columns, "--grid"),
                                             equal_grid_edges(grid[3], grid[4], rows, "--grid"),
                                             thickness(options));
}

std::unique_ptr<const Volumes> box_of(const VolumeOptions& options) {
  const auto& box = options.box;
  return std::make_unique<const GridVolumes>(equal_grid_edges(box[0], box[1], 1, "--box"),
                                             equal_grid_edges(box[2], box[3], 1, "--box"),
                                             thickness(options));
}

// Exactly one kind of volume, sectors and polar components only with rings.
void check_choice(const VolumeOptions& options) {
  std::vector<std::string_view> given;
  if (!options.rings.empty()) given.emplace_back("--rings");
  if (!options.edges.empty()) given.emplace_back("--edges");
  if (!options.grid.empty()) given.emplace_back("--grid");
  if (!options.box.empty()) given.emplace_back("--box");
  if (given.size() != 1)
    throw bad_input({"--rings"}, "the volumes are ambiguous", "one of --rings, --edges, --grid, --box",
                    given.empty() ? "none" : fmt::format("{}", fmt::join(given, " ")));
  const bool rectangles = !options.grid.empty() || !options.box.empty();
  if (options.sectors > 0 && rectangles)
    throw bad_input({"--sectors"}, "only rings have sectors", "--rings or --edges", std::string(given[0]));
  if (!options.components.empty() && options.components != "polar" && options.components != "cartesian")
    throw bad_input({"--components"}, "unknown components", "polar or cartesian",
                    in_quotes(options.components));
  if (options.components == "polar" && rectangles)
    throw bad_input({"--components"}, "only rings have polar components", "--rings or --edges, or cartesian",
                    std::string(given[0]));
  if (!options.center.empty() && rectangles)
    throw bad_input({"--center"}, "only rings have a centre", "--rings or --edges", std::string(given[0]));
}

std::unique_ptr<const Volumes> polar_volumes_of(const VolumeOptions& options) {
  auto rings =
      std::make_unique<const RingVolumes>(ring_centre(options), ring_edges(options), thickness(options));
  if (options.sectors == 0) return rings;
  check_total(static_cast<double>(rings->count()) * options.sectors, "--sectors");
  return std::make_unique<const SectorVolumes>(std::move(rings), options.sectors);
}

std::unique_ptr<const Volumes> volumes_of(const VolumeOptions& options) {
  if (!options.grid.empty()) return grid_of(options);
  if (!options.box.empty()) return box_of(options);
  if (options.components != "cartesian") return polar_volumes_of(options);
  return std::make_unique<const CartesianComponents>(polar_volumes_of(options));
}

// Overall length of all volumes.
double extent(const VolumeOptions& options) {
  if (!options.rings.empty()) return 2 * options.rings[1];
  if (!options.edges.empty()) return 2 * options.edges.back();
  const auto& box = options.box;
  const auto& grid = options.grid;
  return grid.empty() ? std::fmax(box[1] - box[0], box[3] - box[2])
                      : std::fmax(grid[1] - grid[0], grid[4] - grid[3]);
}

// A kernel much wider than all volumes resolves nothing, and is slow.
void check_width(const VolumeOptions& options) {
  constexpr double widest = 1000;
  const double width = kernel_width(options);
  if (width > widest * extent(options))
    throw bad_input({"--weight"}, "the kernel is much wider than all volumes together",
                    fmt::format("a width of {:.3g} m or less", widest * extent(options)),
                    in_quotes(options.weight));
}

void describe_weight(const VolumeOptions& options, Preamble& lines) {
  lines.emplace_back("weight", options.weight);
  lines.emplace_back("branch", branch_name(options));
}

}  // namespace

void add_volume_options(CLI::App& app, VolumeOptions& options) {
  app.option_defaults()->group("Volumes");
  app.add_option("--rings", options.rings, "RMIN RMAX N: N equal rings (m)")
      ->expected(3)
      ->allow_extra_args(false);
  app.add_option("--center", options.center, "X Y: centre of the rings (m), default 0 0")
      ->expected(2)
      ->allow_extra_args(false);
  app.add_option("--edges", options.edges, "R0,R1,...: edges of the rings (m), instead of equal rings")
      ->delimiter(',');
  app.add_option("--sectors", options.sectors, "M: each ring is divided into M equal sectors")
      ->transform(whole_number(1, static_cast<std::int64_t>(most_volumes)));
  app.add_option("--grid", options.grid, "XMIN XMAX NX YMIN YMAX NY: NX by NY equal rectangles (m)")
      ->expected(6)
      ->allow_extra_args(false);
  app.add_option("--box", options.box, "XMIN XMAX YMIN YMAX: one rectangle (m)")
      ->expected(4)
      ->allow_extra_args(false);
  app.add_option("--height", options.height,
                 "thickness of the discs (m); default that of the snapshots, or none: stresses are then "
                 "forces per length")
      ->check(positive());
  app.add_option("--bulk-types", options.bulk_types, "types to average, default all")->delimiter(',');
  app.add_option("--branch", options.branch,
                 "branch vector: radius (a_p n; default except for kernels) or contact (to the contact "
                 "point; default for kernels)");
  app.option_defaults()->group("Options");
}

void add_components_option(CLI::App& app, VolumeOptions& options) {
  app.add_option("--components", options.components,
                 "of vectors and tensors: polar (default for rings and sectors) or cartesian (mean of the "
                 "Cartesian components, not the mean polar ones rotated)");
}

void add_weight_option(CLI::App& app, VolumeOptions& options, const std::string& choice) {
  app.add_option("--weight", options.weight,
                 choice.empty()
                     ? "sliced (area of the disc in the volume, default), centre, or a kernel of width W in "
                       "m: gauss:W (standard deviation), lucy:W, wendland:W, tophat:W (radius of the support)"
                     : choice);
}

int resolution_of(const VolumeOptions& options) {
  if (!options.rings.empty()) return static_cast<int>(options.rings[2]);
  if (!options.edges.empty()) return static_cast<int>(options.edges.size()) - 1;
  return options.grid.empty() ? 1 : static_cast<int>(options.grid[2]);
}

VolumeOptions at_resolution(const VolumeOptions& options, int resolution) {
  if (resolution < 1)
    throw bad_input({"--resolutions"}, "not a resolution", "whole numbers of 1 or more",
                    fmt::format("{}", resolution));
  VolumeOptions other = options;
  if (!options.rings.empty()) {
    other.rings[2] = resolution;
  } else if (!options.grid.empty()) {
    const double rows = options.grid[5] * resolution / options.grid[2];
    other.grid[2] = resolution;
    other.grid[5] = std::fmax(1, std::round(rows));
  } else {
    throw bad_input({"--resolutions"}, "the volumes have one resolution only", "--rings or --grid",
                    options.edges.empty() ? "--box" : "--edges");
  }
  return other;
}

double kernel_width(const VolumeOptions& options) {
  const auto colon = options.weight.find(':');
  return colon == std::string::npos ? 0 : std::strtod(options.weight.c_str() + colon + 1, nullptr);
}

double thickness(const VolumeOptions& options) {
  return options.height > 0 ? options.height : 1;
}

std::string_view volume_option(const VolumeOptions& options) {
  if (!options.rings.empty()) return "--rings";
  if (!options.edges.empty()) return "--edges";
  return options.grid.empty() ? "--box" : "--grid";
}

bool are_rings(const VolumeOptions& options) {
  return options.grid.empty() && options.box.empty() && options.sectors == 0 &&
         options.components != "cartesian";
}

std::vector<double> ring_edges(const VolumeOptions& options) {
  if (options.rings.empty() == options.edges.empty()) {
    throw bad_input({"--rings"}, "the volumes are ambiguous", "either --rings or --edges",
                    options.rings.empty() ? "none" : "both");
  }
  if (!options.edges.empty()) return options.edges;
  const int count = count_of(options.rings[2], "--rings", "rings");
  return equal_ring_edges(options.rings[0], options.rings[1], count);
}

Eigen::Vector2d ring_centre(const VolumeOptions& options) {
  if (options.center.empty()) return Eigen::Vector2d::Zero();
  return {options.center[0], options.center[1]};
}

bool is_plausible_height(double height, double radius) {
  return height >= 0.005 * radius && height <= 100 * radius;
}

std::unique_ptr<const Averager> make_averager(const VolumeOptions& options, FieldList fields,
                                              const GivenValues& given) {
  check_choice(options);
  check_width(options);
  const AveragingOptions averaging{options.bulk_types, branch_of(options.branch), options.height > 0, given};
  return std::make_unique<const Averager>(volumes_of(options), make_weight(options.weight), std::move(fields),
                                          averaging);
}

std::string branch_name(const VolumeOptions& options) {
  if (!options.branch.empty()) return options.branch;
  return make_weight(options.weight)->is_kernel() ? "contact" : "radius";
}

void describe_volumes(const VolumeOptions& options, Preamble& lines, bool with_weight, bool needs_height) {
  const auto add = [&](std::string_view name, const std::vector<double>& numbers, std::string_view between) {
    if (!numbers.empty()) lines.emplace_back(name, fmt::format("{}", fmt::join(numbers, between)));
  };
  add("rings", options.rings, " ");
  add("edges", options.edges, ",");
  add("grid", options.grid, " ");
  add("box", options.box, " ");
  if (options.components == "cartesian") lines.emplace_back("components", options.components);
  if (options.sectors > 0) lines.emplace_back("sectors", fmt::format("{}", options.sectors));
  if (options.grid.empty() && options.box.empty()) {
    const Eigen::Vector2d centre = ring_centre(options);
    add("center", {centre[0], centre[1]}, " ");
  }
  if (with_weight) describe_weight(options, lines);
  if (options.height > 0 || needs_height)
    lines.emplace_back("height", options.height > 0 ? fmt::format("{} m", options.height)
                                                    : "none given: forces per length in place of stresses");
  lines.emplace_back("bulk types", options.bulk_types.empty()
                                       ? "all"
                                       : fmt::format("{}", fmt::join(options.bulk_types, ",")));
}

}  // namespace mikromakro
