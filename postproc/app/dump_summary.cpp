// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/dump_summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "io/text/particle_reader.h"
#include "model/units.h"

namespace mikromakro {
namespace {

void add_particles(const ParticleRows& rows, DumpSummary& summary) {
  summary.counts_by_type.clear();
  const bool with_types = (rows.given & column_set(ParticleColumn::type)) != 0;
  for (const Particle& particle : rows.particles) {
    if (with_types) {
      DumpSummary::Count& count = summary.counts_by_type[particle.type];
      count.most = ++count.fewest;
    }
    summary.smallest_radius = std::min(summary.smallest_radius, particle.radius);
    summary.largest_radius = std::max(summary.largest_radius, particle.radius);
  }
}

// False for a dump without the columns that averages need; it is still summarised.
bool has_discs(const DumpHeader& header, const std::vector<std::string>& list, const std::string& file) {
  if (!header.of_particles() || (header.columns.empty() && list.empty())) return false;
  const ParticleColumns columns(header, list, {file, header.line});
  return (particle_base_columns & ~columns.map().given) == 0;
}

void add_frame(const RowBlock& rows, DumpSummary& summary) {
  const DumpHeader& header = rows.header;
  if (summary.frames++ == 0) summary.first_step = header.step;
  summary.last_step = header.step;
  summary.fewest_rows = std::min(summary.fewest_rows, header.rows);
  summary.most_rows = std::max(summary.most_rows, header.rows);
  summary.last = header;
}

std::string periodic_text(const Box& box) {
  return std::string(box.periodic[0] ? "x" : "") + (box.periodic[1] ? "y" : "");
}

std::string boundaries_text(const Box& box) {
  if (!box.boundaries_known) return "not said";
  return periodic_text(box).empty() ? "no" : periodic_text(box);
}

}  // namespace

DumpSummary summarise_dump(const std::string& file, const std::vector<std::string>& particle_columns,
                           Notes& notes) {
  DumpReader dump(file);
  DumpSummary summary;
  for (DumpHeader header; dump.next_header(header);) {
    const auto rows = dump.take_rows(header);
    if (!rows) break;
    if (summary.frames > 0 && header.step <= summary.last_step)
      notes.add(file + ": steps occur again", header.step);
    add_frame(*rows, summary);
    if (has_discs(header, particle_columns, file))
      add_particles(read_particles(*rows, particle_columns, 0), summary);
  }
  if (dump.cut()) notes.add(file + ": the compressed file is truncated: only its complete frames are used");
  if (summary.last.units.empty()) return summary;
  const Units units = units_of(summary.last.units, {file});
  convert(units, summary.last.box);
  summary.smallest_radius *= units.length;
  summary.largest_radius *= units.length;
  if (const std::string text = units_note(summary.last.units); !text.empty())
    notes.add(fmt::format("{}: {}", file, text));
  return summary;
}

bool alike(const DumpSummary& one, const DumpSummary& other) {
  return one.last.of_particles() == other.last.of_particles() && one.last.columns == other.last.columns &&
         one.last.units == other.last.units;
}

void add_part(const DumpSummary& part, DumpSummary& whole) {
  if (part.last_step >= whole.last_step) whole.last = part.last;
  whole.frames += part.frames;
  whole.first_step = std::min(whole.first_step, part.first_step);
  whole.last_step = std::max(whole.last_step, part.last_step);
  whole.fewest_rows = std::min(whole.fewest_rows, part.fewest_rows);
  whole.most_rows = std::max(whole.most_rows, part.most_rows);
  whole.smallest_radius = std::min(whole.smallest_radius, part.smallest_radius);
  whole.largest_radius = std::max(whole.largest_radius, part.largest_radius);
  std::map<int, DumpSummary::Count> counts = part.counts_by_type;
  for (auto& [type, count] : counts) {
    const auto before = whole.counts_by_type.find(type);
    const DumpSummary::Count old =
        before == whole.counts_by_type.end() ? DumpSummary::Count{0, 0} : before->second;
    count = {std::min(count.fewest, old.fewest), std::max(count.most, old.most)};
  }
  for (const auto& [type, count] : whole.counts_by_type)
    counts.try_emplace(type, DumpSummary::Count{0, count.most});
  whole.counts_by_type = std::move(counts);
}

Json dump_json(const std::string& file, const DumpSummary& summary) {
  const DumpHeader& last = summary.last;
  Json json = Json::object();
  json["file"] = file;
  json["kind"] = last.of_particles() ? "particles" : "contacts";
  json["frames"] = summary.frames;
  json["first_step"] = summary.first_step;
  json["last_step"] = summary.last_step;
  json["fewest_rows"] = summary.fewest_rows;
  json["most_rows"] = summary.most_rows;
  json["columns"] = last.columns;
  if (!last.units.empty()) json["units"] = last.units;
  json["box"] = std::vector<double>{last.box.low[0], last.box.high[0], last.box.low[1], last.box.high[1]};
  json["periodic"] = periodic_text(last.box);
  if (summary.largest_radius == 0) return json;
  Json types = Json::object();
  for (const auto& [type, count] : summary.counts_by_type) types[fmt::format("{}", type)] = count.most;
  json["types"] = types;
  json["radius"] = std::vector<double>{summary.smallest_radius, summary.largest_radius};
  return json;
}

void print_dump(const std::string& file, const DumpSummary& summary) {
  const DumpHeader& last = summary.last;
  const std::string_view metre = last.units == "lj" ? "" : " m";
  fmt::print("{}: {} (text dump)\n", file, last.of_particles() ? "particles" : "contacts");
  fmt::print("  frames   {} (steps {} to {})\n", summary.frames, summary.first_step, summary.last_step);
  fmt::print("  rows     {} to {} per frame\n", summary.fewest_rows, summary.most_rows);
  fmt::print("  columns  {}\n", fmt::join(last.columns, " "));
  if (!last.units.empty()) fmt::print("  units    {}\n", last.units);
  fmt::print("  box      x {} to {}{}, y {} to {}{}, periodic: {}\n", last.box.low[0], last.box.high[0],
             metre, last.box.low[1], last.box.high[1], metre, boundaries_text(last.box));
  for (const auto& [type, count] : summary.counts_by_type)
    fmt::print("  type {}   {} discs\n", type,
               count.fewest == count.most ? fmt::format("{}", count.most)
                                          : fmt::format("{} to {}", count.fewest, count.most));
  if (summary.largest_radius > 0)
    fmt::print("  radius   {} to {}{}\n", summary.smallest_radius, summary.largest_radius, metre);
}

}  // namespace mikromakro
