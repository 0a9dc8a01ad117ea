#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "app/commands.h"
#include "app/input_options.h"
#include "app/progress.h"
#include "audit/contact_balance.h"
#include "audit/ring_balance.h"
#include "averaging/time_average.h"
#include "io/error.h"
#include "io/file_list.h"
#include "io/json_object.h"
#include "options/volume_options.h"

namespace mikromakro {
namespace {

struct AuditOptions {
  InputOptions input;
  VolumeOptions volumes;
  std::vector<int> wheel_types;
  double margin = 0;
  double bound = std::nan("");
  bool json = false;
  bool quiet = false;
};

struct Audit {
  std::int64_t frames = 0;
  double wheel_torque = 0;
  std::vector<RingBalance> rings;
  double volume_of_rings = 0;  // sum of nu V
  double volume_inside = 0;    // of discs between the first and the last edge
  double torque_deviation = 0, radial_deviation = 0, force_residual = 0, volume_deviation = 0;
};

struct Balance {
  std::string_view name;
  double Audit::*value;
  std::string_view text;
};
constexpr Balance balances[] = {
    {"torque", &Audit::torque_deviation,
     "largest deviation of 2 pi r^2 h sigma_phir from the wheel's torque"},
    {"radial", &Audit::radial_deviation, "largest |d(r sigma_rr)/dr - sigma_phiphi| over the pressure"},
    {"residual", &Audit::force_residual, "mean force on a disc over the mean contact force"},
    {"volume", &Audit::volume_deviation, "volume of the rings' discs against that of all discs inside"}};

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

Audit audit(const AuditOptions& options) {
  const auto rings = make_averager(options.volumes, make_fields({"solid_fraction", "stress"}));
  const auto whole = make_averager(one_ring(options.volumes), make_fields({"solid_fraction"}));
  FrameSource source = source_of(options.input, *rings);
  source.contacts_needed |= column_set(ContactColumn::overlap);
  Progress progress(total_size(source.files()), options.quiet);
  FrameStream stream(source);
  TimeAverage of_rings(0);
  TimeAverage of_whole(0);
  ContactBalance contacts({ring_centre(options.volumes), options.volumes.bulk_types, options.wheel_types});
  Frame frame;
  while (stream.next(frame)) {
    of_rings.add(rings->frame_sums(frame));
    of_whole.add(whole->frame_sums(frame));
    contacts.add(frame);
    progress.update(stream.bytes_read(), of_rings.frames());
  }
  if (of_rings.frames() == 0)
    throw bad_input({source.files().front()}, "no frame is selected",
                    "frames that --frames and --steps select", "0");
  Audit result;
  result.frames = of_rings.frames();
  result.wheel_torque = contacts.wheel_torque();
  result.force_residual = contacts.force_residual();
  result.rings = ring_balances(rings->solve(of_rings.mean()), options.volumes.height, options.margin);
  result.torque_deviation = torque_deviation(result.rings, result.wheel_torque);
  result.radial_deviation = radial_deviation(result.rings);
  const double to_volume = std::numbers::pi * options.volumes.height;
  result.volume_of_rings = to_volume * volume_of(*rings, of_rings.mean());
  result.volume_inside = to_volume * volume_of(*whole, of_whole.mean());
  result.volume_deviation = std::abs(result.volume_of_rings / result.volume_inside - 1);
  return result;
}

void print_text(const Audit& audit) {
  fmt::print("{:>10} {:>14} {:>10} {:>16} {:>14}\n", "r/m", "torque/(N m)", "/wheel", "d(r s_rr)/dr/Pa",
             "s_phiphi/Pa");
  for (const RingBalance& ring : audit.rings) {
    fmt::print("{:>10.6g} {:>14.6g} {:>10.4f} {:>16.6g} {:>14.6g}{}\n", ring.r, ring.torque,
               ring.torque / audit.wheel_torque, ring.slope, ring.sigma_phiphi,
               ring.counts ? "" : "  at a wall");
  }
  fmt::print("{} frames; torque of the discs on the wheel {:.6g} N m; volume of discs {:.6g} m^3\n",
             audit.frames, audit.wheel_torque, audit.volume_inside);
  for (const Balance& balance : balances)
    fmt::print("{:<9} {:>10.3e}  {}\n", balance.name, audit.*balance.value, balance.text);
}

void print_json(const Audit& audit) {
  JsonObject json;
  json.add("frames", audit.frames);
  json.add("wheel_torque", audit.wheel_torque);
  json.add("volume_of_rings", audit.volume_of_rings);
  json.add("volume_inside", audit.volume_inside);
  for (const Balance& balance : balances) json.add(balance.name, audit.*balance.value);
  const auto add = [&](std::string_view name, const auto& value_of) {
    std::vector<double> values;
    for (const RingBalance& ring : audit.rings) values.push_back(value_of(ring));
    json.add(name, values);
  };
  add("r", [](const RingBalance& ring) { return ring.r; });
  add("torque_of_ring", [](const RingBalance& ring) { return ring.torque; });
  add("radial_slope", [](const RingBalance& ring) { return ring.slope; });
  add("sigma_phiphi", [](const RingBalance& ring) { return ring.sigma_phiphi; });
  add("counts", [](const RingBalance& ring) { return ring.counts ? 1.0 : 0.0; });
  fmt::print("{}\n", json.text());
}

// A balance that is not known is off, too.
void check_bound(const Audit& audit, double bound) {
  std::vector<std::string> off;
  for (const Balance& balance : balances) {
    if (!(audit.*balance.value <= bound))
      off.push_back(fmt::format("{} {:.3g}", balance.name, audit.*balance.value));
  }
  if (!off.empty())
    throw run_failed("balances are off", fmt::format("at most {}", bound),
                     fmt::format("{}", fmt::join(off, ", ")));
}

}  // namespace

void add_audit_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("audit", "balances of torque, forces and volume over rings");
  auto options = std::make_shared<AuditOptions>();
  add_input_options(*app, options->input);
  add_volume_options(*app, options->volumes);
  add_weight_option(*app, options->volumes);
  app->add_option("--wheel-types", options->wheel_types,
                  "types of the wheel's discs; the inner wall counts too")
      ->delimiter(',');
  app->add_option("--margin", options->margin,
                  "rings nearer than this to the first and last edge are shown but not judged (m), default 0")
      ->check(CLI::NonNegativeNumber);
  app->add_option("--bound", options->bound, "exit code 1 when a balance is off by more than this part")
      ->check(CLI::NonNegativeNumber);
  app->add_flag("--json", options->json, "print JSON");
  app->add_flag("--quiet", options->quiet, "no progress bar");
  app->callback([options] {
    const Audit result = audit(*options);
    options->json ? print_json(result) : print_text(result);
    if (!std::isnan(options->bound)) check_bound(result, options->bound);
  });
}

}  // namespace mikromakro
