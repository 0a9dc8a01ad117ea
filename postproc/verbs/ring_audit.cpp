// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "audit/contact_balance.h"
#include "audit/normal_forces.h"
#include "audit/ring_balance.h"
#include "averaging/time_average.h"
#include "model/error.h"
#include "verbs/audits.h"

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

class RingAuditor : public Auditor {
 public:
  explicit RingAuditor(const AuditOptions& options)
      : options_(options),
        volumes_(checked(options.volumes)),
        rings_(make_averager(volumes_, make_fields({"solid_fraction", "stress"}))),
        whole_(make_averager(one_ring(volumes_), make_fields({"solid_fraction"}))),
        forces_(options.kn),
        contacts_({ring_centre(volumes_), volumes_.bulk_types, options.wheel_types}) {}

  FrameSource source() const override {
    FrameSource source = source_of(options_.input, *rings_);
    source.contacts_needed |= column_set(ContactColumn::overlap);
    return source;
  }

  bool add(const Frame& frame, Notes& notes) override {
    note_wheel_outside(frame, options_, ring_edges(volumes_).back(), notes);
    const Rows sums = whole_->frame_sums(frame);
    of_rings_.add(rings_->frame_sums(frame));
    of_whole_.add(sums);
    contacts_.add(frame);
    forces_.add(frame);
    return (sums != 0).any();
  }

  Balances balances() const override { return result().balances; }
  RingAudit result() const;

 private:
  const AuditOptions& options_;
  VolumeOptions volumes_;
  std::unique_ptr<const Averager> rings_, whole_;
  TimeAverage of_rings_{0}, of_whole_{0};
  NormalForces forces_;
  ContactBalance contacts_;
};

RingAudit RingAuditor::result() const {
  RingAudit result;
  result.units = options_.units;
  result.frames = of_rings_.frames();
  result.wheel_torque = contacts_.wheel_torque();
  result.rings = ring_balances(rings_->solve(of_rings_.mean()), volumes_.height, options_.margin);
  const double to_volume = std::numbers::pi * volumes_.height;
  result.volume_of_rings = to_volume * volume_of(*rings_, of_rings_.mean());
  result.volume_inside = to_volume * volume_of(*whole_, of_whole_.mean());
  result.balances = {
      {"torque", torque_deviation(result.rings, result.wheel_torque),
       std::isnan(result.wheel_torque)
           ? "no contacts with a wheel (discs of --wheel-types, or wall 0)"
           : "largest deviation of 2 pi r^2 h sigma_phir from the wheel's torque"},
      {"radial", radial_deviation(result.rings),
       "largest |d(r sigma_rr)/dr - sigma_phiphi| over the pressure"},
      {"residual", contacts_.force_residual(),
       std::isnan(contacts_.force_residual()) ? "no contacts of averaged discs"
                                              : "mean force on a disc over the mean contact force"},
      {"volume", std::abs(result.volume_of_rings / result.volume_inside - 1),
       "volume of the rings' discs against that of all discs inside"},
      law_balance(forces_)};
  return result;
}

std::string text_of(const RingAudit& audit) {
  std::string text;
  fmt::format_to(std::back_inserter(text), "{:>10} {:>14} {:>10} {:>16} {:>14}\n", "r/m", "torque/(N m)",
                 "/wheel", "d(r s_rr)/dr/" + audit.units.stress, "s_phiphi/" + audit.units.stress);
  for (const RingBalance& ring : audit.rings) {
    fmt::format_to(std::back_inserter(text), "{:>10.6g} {} {} {} {}{}\n", ring.r,
                   number_or_dash(ring.torque, 14, "{:.6g}"),
                   number_or_dash(ring.torque / audit.wheel_torque, 10, "{:.4f}"),
                   number_or_dash(ring.slope, 16, "{:.6g}"), number_or_dash(ring.sigma_phiphi, 14, "{:.6g}"),
                   ring.counts ? "" : "  at a wall");
  }
  fmt::format_to(std::back_inserter(text),
                 "{} frames; torque of the discs on the wheel {} N m; volume of discs {:.6g} {}\n",
                 audit.frames, number_or_dash(audit.wheel_torque, 1, "{:.6g}"), audit.volume_inside,
                 audit.units.volume);
  add_balances(text, audit.balances);
  return text;
}

Json json_of(const RingAudit& audit) {
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
  return json;
}

}  // namespace

std::unique_ptr<Auditor> ring_auditor(const AuditOptions& options) {
  return std::make_unique<RingAuditor>(options);
}

AuditReport audit_rings(const AuditOptions& options) {
  RingAuditor auditor(options);
  const FrameSource source = auditor.source();
  read_frames(source, options, [&](const Frame& frame) { return auditor.add(frame, *source.notes); });
  const RingAudit result = auditor.result();
  return {result.balances, text_of(result), json_of(result)};
}

}  // namespace mikromakro
