// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

#include "audit/cell_balance.h"
#include "audit/contact_balance.h"
#include "audit/normal_forces.h"
#include "audit/table_column.h"
#include "averaging/time_average.h"
#include "model/error.h"
#include "verbs/audits.h"
#include "verbs/box_audit_report.h"

namespace mikromakro {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

constexpr const char* not_whole =
    "not judged: the box leaves out discs or does not end at the walls (without --box it ends at the walls)";

// Relative friction below which the walls count as frictionless.
constexpr double smooth = 1e-12;

VolumeOptions checked(const AuditOptions& options) {
  VolumeOptions volumes = options.volumes;
  if (volumes.weight.empty()) volumes.weight = "centre";
  if (volumes.sectors > 0 || (!volumes.grid.empty() && !volumes.box.empty()))
    make_averager(volumes, {});  // throws an error that names the problem
  if (!volumes.branch.empty() && volumes.branch != "contact")
    throw bad_input({"--branch"}, "stresses balance with branches to the contact points only", "contact",
                    in_quotes(volumes.branch));
  volumes.branch = "contact";
  if (volumes.grid.empty() && volumes.weight != "centre")
    throw bad_input({"--weight"}, "in one box discs count by their centres", "centre, or --grid",
                    in_quotes(volumes.weight));
  return volumes;
}

// The requested rectangle; none if it is to be found from the walls.
std::optional<Rectangle> given_box(const VolumeOptions& volumes) {
  const auto& box = volumes.box;
  const auto& grid = volumes.grid;
  if (!box.empty()) return Rectangle{{box[0], box[2]}, {box[1], box[3]}};
  if (!grid.empty()) return Rectangle{{grid[0], grid[3]}, {grid[1], grid[4]}};
  return std::nullopt;
}

VolumeOptions one_box(const VolumeOptions& volumes, const Rectangle& box) {
  VolumeOptions one = volumes;
  one.grid.clear();
  one.box = {box.low[0], box.high[0], box.low[1], box.high[1]};
  return one;
}

// V nu, summed over a table of rectangles.
double disc_volume_of(const Table& table, double height) {
  const Eigen::ArrayXd areas = (column_of(table, "x_max") - column_of(table, "x_min")) *
                               (column_of(table, "y_max") - column_of(table, "y_min"));
  return (areas * column_of(table, "nu")).sum() * height;
}

// Accumulates, frame by frame, the sums that make up the audit of a box.
class BoxAuditor : public Auditor {
 public:
  explicit BoxAuditor(const AuditOptions& options)
      : options_(options),
        volumes_(checked(options)),
        given_(given_box(volumes_)),
        contacts_({Eigen::Vector2d::Zero(), volumes_.bulk_types, {}}),
        forces_(options.kn) {
    if (volumes_.grid.empty()) return;
    cells_ = make_averager(volumes_, make_fields({"solid_fraction", "stress", "wall_force_density"}));
    is_kernel_ = make_weight(volumes_.weight)->is_kernel();
  }

  FrameSource source() const override {
    const InputOptions& input = options_.input;
    require_contacts(input, "the stress of walls needs");
    FrameSource source = frame_source(input);
    if (!volumes_.bulk_types.empty()) source.particles_needed = column_set(ParticleColumn::type);
    source.averaged_types = volumes_.bulk_types;
    source.contacts_required = true;
    source.contacts_needed = column_set(ContactColumn::fx, ContactColumn::fy, ContactColumn::overlap);
    return source;
  }

  bool add(const Frame& frame, Notes& /*notes*/) override {
    const Rectangle box = given_ ? *given_ : wall_rectangle(frame);
    VolumeOptions by_centre = one_box(volumes_, box);
    by_centre.weight = "centre";
    const auto inside = make_averager(by_centre, make_fields({"solid_fraction", "stress"}));
    const Rows sums = inside->frame_sums(frame);
    const Table table = inside->solve(sums);
    const double volume = box.size().prod() * volumes_.height;
    Eigen::Matrix2d stress;
    stress << column_of(table, "sigma_xx"), column_of(table, "sigma_xy"), column_of(table, "sigma_yx"),
        column_of(table, "sigma_yy");
    box_.add(box, volumes_.height, volume * stress, box_load(frame, box, volumes_.bulk_types));
    volume_by_centre_ += disc_volume_of(table, volumes_.height);
    const double area = disc_area_inside(frame, box, volumes_.bulk_types);
    disc_volume_ += volumes_.height * area;
    contacts_.add(frame);
    forces_.add(frame);
    if (!cells_) return area > 0;
    of_cells_.add(cells_->frame_sums(frame));
    if (volumes_.weight == "centre") return area > 0;
    const auto whole = make_averager(one_box(volumes_, box), make_fields({"solid_fraction"}));
    volume_by_weight_ += disc_volume_of(whole->solve(whole->frame_sums(frame)), volumes_.height);
    return area > 0;
  }

  Balances balances() const override { return result().balances; }

  BoxAudit result() const {
    BoxAudit audit;
    audit.box = box_;
    const auto frames = static_cast<double>(box_.frames());
    audit.disc_volume = disc_volume_ / frames;
    audit.balances = {stress_balance()};
    add_walls(audit);
    audit.balances.push_back({"residual", contacts_.force_residual(),
                              std::isnan(contacts_.force_residual())
                                  ? "no contacts of averaged discs"
                                  : "mean force on a disc over the mean contact force"});
    add_volume(audit);
    audit.balances.push_back(law_balance(forces_));
    if (cells_) add_momentum(audit);
    return audit;
  }

 private:
  Balance stress_balance() const {
    if (box_.is_cut()) return {"stress", nan, not_whole, false};
    const bool x = box_.is_open(0);
    const bool y = box_.is_open(1);
    if (x && y)
      return {"stress", nan, "not judged: periodic along x and y, without walls to compare with", false};
    if (!box_.has_boundary())
      return {"stress", nan, "no contacts with walls, nor with discs that are not averaged"};
    if (!x && !y)
      return {"stress", box_.stress_deviation(),
              "largest difference of a component, volume and boundary, over the pressure"};
    return {"stress", box_.stress_deviation(),
            fmt::format("the same for the components {} only: periodic along {}, without walls there",
                        x ? "xy, yy" : "xx, yx", x ? 'x' : 'y')};
  }

  void add_walls(BoxAudit& audit) const {
    if (box_.is_cut()) {
      for (const char* name : {"walls", "forces"}) audit.balances.push_back({name, nan, not_whole, false});
      return;
    }
    if (!box_.has_walls()) {
      const bool judged = box_.may_have_wall(0) || box_.may_have_wall(2);
      const char* text = "no contacts with walls -1, -2, -3, -4";
      // Other boundaries, such as rows of discs, enter the stress balance.
      const bool other = box_.has_boundary() || !judged;
      audit.balances.push_back({"walls", nan, text, !other});
      audit.balances.push_back({"forces", nan, text, !other});
      return;
    }
    const bool is_smooth = box_.friction() < smooth;
    audit.balances.push_back(
        {"walls", box_.wall_deviation(),
         is_smooth ? "largest difference of normal stresses, walls and volume, over the pressure"
                   : "the same for the walls' normal stresses; not judged, since walls have friction",
         is_smooth});
    audit.balances.push_back(
        {"forces", box_.wall_residual(), "sum of the forces of the walls over the mean of one"});
  }

  void add_volume(BoxAudit& audit) const {
    const bool by_centre = volumes_.weight == "centre";
    const double all = by_centre ? disc_volume_ : volume_by_weight_;
    const double found = cells_ ? disc_volume_of(cells_->solve(of_cells_.mean()), volumes_.height) *
                                      static_cast<double>(box_.frames())
                                : volume_by_centre_;
    audit.balances.push_back({"volume", std::abs(found / all - 1),
                              !(all > 0)  ? "no averaged disc inside"
                              : by_centre ? "sum of nu V against the volume of the discs inside"
                                          : "sum of nu V over the cells against the whole box"});
  }

  void add_momentum(BoxAudit& audit) const {
    const auto columns = static_cast<int>(volumes_.grid[2]);
    const Table table = cells_->solve(of_cells_.mean());
    audit.cells = cell_balances(table, columns);
    const bool judged = is_kernel_ && !audit.cells.empty();
    audit.balances.push_back({"momentum", momentum_deviation(table, columns),
                              judged ? "largest |div sigma + t| of a cell times its side over the pressure"
                              : audit.cells.empty()
                                  ? "not judged: no cell has four neighbours"
                                  : "|div sigma + t|; not judged: needs a kernel, wider than a cell",
                              judged});
  }

  const AuditOptions& options_;
  VolumeOptions volumes_;
  std::optional<Rectangle> given_;
  std::unique_ptr<const Averager> cells_;
  bool is_kernel_ = false;
  BoxBalance box_;
  ContactBalance contacts_;
  NormalForces forces_;
  TimeAverage of_cells_{0};
  double disc_volume_ = 0;
  double volume_by_centre_ = 0;
  double volume_by_weight_ = 0;
};

}  // namespace

std::unique_ptr<Auditor> box_auditor(const AuditOptions& options) {
  return std::make_unique<BoxAuditor>(options);
}

AuditReport audit_box(const AuditOptions& options) {
  BoxAuditor auditor(options);
  const FrameSource source = auditor.source();
  read_frames(source, options, [&](const Frame& frame) { return auditor.add(frame, *source.notes); });
  BoxAudit audit = auditor.result();
  audit.units = options.units;
  return {audit.balances, text_of(audit), json_of(audit)};
}

}  // namespace mikromakro
