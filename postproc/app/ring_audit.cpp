// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "app/audits.h"
#include "audit/contact_balance.h"
#include "audit/normal_forces.h"
#include "audit/ring_balance.h"
#include "averaging/time_average.h"
#include "model/error.h"

namespace mikromakro {
namespace {

struct RingAudit {
  AuditUnits units;
  std::int64_t frames = 0;
  double wheel_torque = 0;
  std::vector<RingBalance> rings;
  double volume_of_rings = 0;  // sum of nu V
  double volume_inside = 0;    // of discs between the first and the last edge
  Balances balances;
};

double volume_of(const Averager& averager, const Rows& mean) {
  const Table table = averager.solve(mean);
  double volume = 0;
  for (Eigen::Index i = 0; i < table.rows.rows(); ++i) {
    const double area = (table.rows(i, 1) - table.rows(i, 0)) * (table.rows(i, 1) + table.rows(i, 0));
    volume += area * table.rows(i, 3);
  }
  return volume;
}

VolumeOptions one_ring(const VolumeOptions& options) {
  VolumeOptions one = options;
  const std::vector<double> edges = ring_edges(options);
  one.rings.clear();
  one.edges = {edges.front(), edges.back()};
  return one;
}

VolumeOptions checked(const VolumeOptions& options) {
  if (options.sectors > 0)
    throw bad_input({"--sectors"}, "audits are of whole rings", "no --sectors",
                    fmt::format("{}", options.sectors));
  VolumeOptions volumes = options;
  if (volumes.weight.empty()) volumes.weight = "sliced";
  return volumes;
}

// The balance holds for the wheel inside of the rings.
void note_wheel_outside(const Frame& frame, const AuditOptions& options, double last_edge, Notes& notes) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Particle& disc : frame.particles)
    if (std::find(options.wheel_types.begin(), options.wheel_types.end(), disc.type) !=
        options.wheel_types.end())
      nearest = std::min(nearest, (disc.position - ring_centre(options.volumes)).norm());
  if (std::isfinite(nearest) && nearest > last_edge)
    notes.add("--wheel-types: all discs of the wheel are outside of the rings (the types of the outer ring?)",
              frame.step);
}

RingAudit audit(const AuditOptions& options) {
  const VolumeOptions volumes = checked(options.volumes);
  const auto rings = make_averager(volumes, make_fields({"solid_fraction", "stress"}));
  const auto whole = make_averager(one_ring(volumes), make_fields({"solid_fraction"}));
  FrameSource source = source_of(options.input, *rings);
  source.contacts_needed |= column_set(ContactColumn::overlap);
  TimeAverage of_rings(0);
  TimeAverage of_whole(0);
  NormalForces forces(options.kn);
  ContactBalance contacts({ring_centre(volumes), volumes.bulk_types, options.wheel_types});
  RingAudit result;
  result.units = options.units;
  result.frames = read_frames(source, options, [&](const Frame& frame) {
    note_wheel_outside(frame, options, ring_edges(volumes).back(), *source.notes);
    const Rows sums = whole->frame_sums(frame);
    of_rings.add(rings->frame_sums(frame));
    of_whole.add(sums);
    contacts.add(frame);
    forces.add(frame);
    return (sums != 0).any();
  });
  result.wheel_torque = contacts.wheel_torque();
  result.rings = ring_balances(rings->solve(of_rings.mean()), volumes.height, options.margin);
  const double to_volume = std::numbers::pi * volumes.height;
  result.volume_of_rings = to_volume * volume_of(*rings, of_rings.mean());
  result.volume_inside = to_volume * volume_of(*whole, of_whole.mean());
  result.balances = {
      {"torque", torque_deviation(result.rings, result.wheel_torque),
       std::isnan(result.wheel_torque)
           ? "no contacts with a wheel (discs of --wheel-types, or wall 0)"
           : "largest deviation of 2 pi r^2 h sigma_phir from the wheel's torque"},
      {"radial", radial_deviation(result.rings),
       "largest |d(r sigma_rr)/dr - sigma_phiphi| over the pressure"},
      {"residual", contacts.force_residual(),
       std::isnan(contacts.force_residual()) ? "no contacts of averaged discs"
                                             : "mean force on a disc over the mean contact force"},
      {"volume", std::abs(result.volume_of_rings / result.volume_inside - 1),
       "volume of the rings' discs against that of all discs inside"},
      law_balance(forces)};
  return result;
}

void print_text(const RingAudit& audit) {
  fmt::print("{:>10} {:>14} {:>10} {:>16} {:>14}\n", "r/m", "torque/(N m)", "/wheel",
             "d(r s_rr)/dr/" + audit.units.stress, "s_phiphi/" + audit.units.stress);
  for (const RingBalance& ring : audit.rings) {
    fmt::print("{:>10.6g} {} {} {} {}{}\n", ring.r, number_or_dash(ring.torque, 14, "{:.6g}"),
               number_or_dash(ring.torque / audit.wheel_torque, 10, "{:.4f}"),
               number_or_dash(ring.slope, 16, "{:.6g}"), number_or_dash(ring.sigma_phiphi, 14, "{:.6g}"),
               ring.counts ? "" : "  at a wall");
  }
  fmt::print("{} frames; torque of the discs on the wheel {} N m; volume of discs {:.6g} {}\n", audit.frames,
             number_or_dash(audit.wheel_torque, 1, "{:.6g}"), audit.volume_inside, audit.units.volume);
  print_balances(audit.balances);
}

void print_json(const RingAudit& audit) {
  Json json = Json::object();
  json["frames"] = audit.frames;
  json["wheel_torque"] = audit.wheel_torque;
  json["volume_of_rings"] = audit.volume_of_rings;
  json["volume_inside"] = audit.volume_inside;
  add_balances(json, audit.balances);
  const auto add = [&](std::string_view name, const auto& value_of) {
    std::vector<double> values;
    for (const RingBalance& ring : audit.rings) values.push_back(value_of(ring));
    json[name] = values;
  };
  add("r", [](const RingBalance& ring) { return ring.r; });
  add("torque_of_ring", [](const RingBalance& ring) { return ring.torque; });
  add("radial_slope", [](const RingBalance& ring) { return ring.slope; });
  add("sigma_phiphi", [](const RingBalance& ring) { return ring.sigma_phiphi; });
  add("counts", [](const RingBalance& ring) { return ring.counts ? 1.0 : 0.0; });
  fmt::print("{}\n", text_of(json));
}

}  // namespace

Balances audit_rings(const AuditOptions& options) {
  const RingAudit result = audit(options);
  options.json ? print_json(result) : print_text(result);
  return result.balances;
}

}  // namespace mikromakro
