#include "app/volume_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "averaging/ring_volumes.h"
#include "io/error.h"

namespace mikromakro {
namespace {

Branch branch_of(const std::string& name) {
  if (name == "radius") return Branch::radius;
  if (name == "contact") return Branch::contact;
  throw bad_input({"--branch"}, "unknown branch vector", "radius or contact", in_quotes(name));
}

}  // namespace

void add_volume_options(CLI::App& app, VolumeOptions& options) {
  app.add_option("--rings", options.rings, "RMIN RMAX N: N equal rings (m)")->expected(3);
  app.add_option("--center", options.center, "X Y: centre of the rings (m), default 0 0")->expected(2);
  app.add_option("--edges", options.edges, "R0,R1,...: own radii of the rings (m)")->delimiter(',');
  app.add_option("--weight", options.weight, "sliced (area of the disc in the volume, default) or centre");
  app.add_option("--height", options.height, "thickness of the discs (m), default 1");
  app.add_option("--bulk-types", options.bulk_types, "types that are averaged, default all")->delimiter(',');
  app.add_option("--branch", options.branch,
                 "branch vector: radius (a_p n, default) or contact (to the contact point)");
}

std::vector<double> ring_edges(const VolumeOptions& options) {
  if (options.rings.empty() == options.edges.empty()) {
    throw bad_input({"--rings"}, "the volumes are not clear", "either --rings or --edges",
                    options.rings.empty() ? "none" : "both");
  }
  if (!options.edges.empty()) return options.edges;
  constexpr double most_rings = 1e6;
  const double count = options.rings[2];
  if (count != std::floor(count) || count < 1 || count > most_rings)
    throw bad_input({"--rings"}, "not a number of rings", "a whole number N, 1 to 1000000",
                    fmt::format("{}", count));
  return equal_ring_edges(options.rings[0], options.rings[1], static_cast<int>(count));
}

Eigen::Vector2d ring_centre(const VolumeOptions& options) {
  const Eigen::Vector2d centre{options.center[0], options.center[1]};
  if (!centre.allFinite()) throw bad_input({"--center"}, "not a point", "finite numbers", "others");
  return centre;
}

std::unique_ptr<const Averager> make_averager(const VolumeOptions& options, FieldList fields) {
  const AveragingOptions averaging{options.bulk_types, branch_of(options.branch)};
  auto volumes =
      std::make_unique<const RingVolumes>(ring_centre(options), ring_edges(options), options.height);
  return std::make_unique<const Averager>(std::move(volumes), make_weight(options.weight), std::move(fields),
                                          averaging);
}

void describe_volumes(const VolumeOptions& options, Preamble& lines) {
  if (options.edges.empty()) {
    lines.emplace_back("rings",
                       fmt::format("{} {} {}", options.rings[0], options.rings[1], options.rings[2]));
  } else {
    lines.emplace_back("edges", fmt::format("{}", fmt::join(options.edges, ",")));
  }
  lines.emplace_back("center", fmt::format("{} {}", options.center[0], options.center[1]));
  lines.emplace_back("weight", options.weight);
  lines.emplace_back("branch", options.branch);
  lines.emplace_back("height", fmt::format("{} m", options.height));
  lines.emplace_back("bulk types", options.bulk_types.empty()
                                       ? "all"
                                       : fmt::format("{}", fmt::join(options.bulk_types, ",")));
}

}  // namespace mikromakro
