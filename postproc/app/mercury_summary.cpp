// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/mercury_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "io/mercury/mercury_rows.h"

namespace mikromakro {
namespace {

struct MercurySummary {
  bool of_particles = false;
  std::int64_t frames = 0;
  double first_time = 0;
  double last_time = 0;
  std::int64_t fewest_rows = std::numeric_limits<std::int64_t>::max();
  std::int64_t most_rows = 0;
  Box box;
  std::map<int, std::int64_t> counts_by_type;  // in the last frame
  double smallest_radius = std::numeric_limits<double>::infinity();
  double largest_radius = 0;

  void add_particles(const MercuryBlock& block) {
    box = block.header.box.value_or(Box{});
    counts_by_type.clear();
    ColumnSet given = 0;
    for (const Particle& particle : mercury_particles(block, 0, given)) {
      if (particle.type > 0) ++counts_by_type[particle.type];
      smallest_radius = std::min(smallest_radius, particle.radius);
      largest_radius = std::max(largest_radius, particle.radius);
    }
  }
};

template <typename Reader>
MercurySummary summarise(const std::string& file, Notes& notes) {
  MercurySummary summary;
  summary.of_particles = std::is_same_v<Reader, MercuryDataReader>;
  Reader reader(file);
  MercuryHeader header;
  while (reader.next_header(header)) {
    const auto taken = reader.take_rows(header);
    if (!taken) break;
    const MercuryBlock& block = *taken;
    if (summary.frames++ == 0) summary.first_time = header.time;
    summary.last_time = header.time;
    const std::int64_t rows = std::count(block.text.begin(), block.text.end(), '\n');
    summary.fewest_rows = std::min(summary.fewest_rows, rows);
    summary.most_rows = std::max(summary.most_rows, rows);
    if (summary.of_particles) summary.add_particles(block);
  }
  if (reader.cut()) notes.add(file + ": the compressed file is truncated: only its complete frames are used");
  return summary;
}

MercurySummary summary_of(const std::string& file, Notes& notes) {
  return MercuryDataReader::recognises(file) ? summarise<MercuryDataReader>(file, notes)
                                             : summarise<MercuryFstatReader>(file, notes);
}

}  // namespace

bool is_mercury_file(const std::string& file) {
  return MercuryDataReader::recognises(file) || MercuryFstatReader::recognises(file);
}

void print_mercury(const std::string& file, Notes& notes) {
  const MercurySummary summary = summary_of(file, notes);
  fmt::print("{}: {} (MercuryDPM)\n  frames   {} (times {} to {} s)\n  rows     {} to {} per frame\n", file,
             summary.of_particles ? "particles" : "contacts", summary.frames, summary.first_time,
             summary.last_time, summary.fewest_rows, summary.most_rows);
  if (summary.largest_radius == 0) return;
  fmt::print("  box      x {} to {} m, y {} to {} m\n", summary.box.low[0], summary.box.high[0],
             summary.box.low[1], summary.box.high[1]);
  for (const auto& [type, count] : summary.counts_by_type) fmt::print("  type {}   {} discs\n", type, count);
  fmt::print("  radius   {} to {} m\n", summary.smallest_radius, summary.largest_radius);
}

Json mercury_json(const std::string& file, Notes& notes) {
  const MercurySummary summary = summary_of(file, notes);
  Json json = Json::object();
  json["file"] = file;
  json["kind"] = summary.of_particles ? "MercuryDPM particles" : "MercuryDPM contacts";
  json["frames"] = summary.frames;
  json["first_time"] = summary.first_time;
  json["last_time"] = summary.last_time;
  json["fewest_rows"] = summary.fewest_rows;
  json["most_rows"] = summary.most_rows;
  if (summary.largest_radius == 0) return json;
  Json types = Json::object();
  for (const auto& [type, count] : summary.counts_by_type) types[fmt::format("{}", type)] = count;
  json["types"] = types;
  json["radius"] = std::vector<double>{summary.smallest_radius, summary.largest_radius};
  return json;
}

}  // namespace mikromakro
