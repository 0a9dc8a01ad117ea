// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/snapshot/snapshot_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Core>
#include <functional>
#include <span>
#include <utility>

#include "io/files/file_list.h"
#include "io/hdf5/chunk_reader.h"
#include "io/snapshot/snapshot_layout.h"
#include "io/snapshot/wall_series.h"
#include "io/text/particle_reader.h"
#include "joining/needed_columns.h"
#include "model/same_box.h"

namespace mikromakro {
namespace {

ColumnNames without_option(const ColumnNames& names) {
  return {names.known, names.ignored, ""};
}

// Rows are filled in blocks, column by column; a block (20 kB of contacts) stays in the first-level cache.
constexpr std::size_t rows_of_block = 128;

// Numbers of a dataset that are adjacent in the rows, from slot `first` on.
struct Stripe {
  const PackedNumbers* numbers;
  std::size_t first, width;
};

ParticleSlots& slots_of(ParticleSlots& row) {
  return row;
}

auto& slots_of(ContactRow& row) {
  return row.value;
}

void check_finite(std::span<const double> numbers, const std::function<Place(std::size_t)>& place_of) {
  const Eigen::Map<const Eigen::ArrayXd> all(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
  if ((0 * all).sum() == 0) return;  // one vectorised sweep
  const auto bad = std::find_if(numbers.begin(), numbers.end(), [](double x) { return !std::isfinite(x); });
  throw bad_input(place_of(static_cast<std::size_t>(bad - numbers.begin())), "not a finite number",
                  "a finite number", fmt::format("{}", *bad));
}

// Numbers of a block, unpacked into `buffer` unless they can be read in place.
std::span<const double> numbers_of(const Stripe& stripe, std::size_t begin, std::size_t rows,
                                   std::vector<double>& buffer) {
  const auto& [packed, first, width] = stripe;
  const std::span<const double> in_place = packed->in_place(begin * width, rows * width);
  if (!in_place.empty()) return in_place;
  buffer.resize(rows * width);
  packed->unpack(begin * width, buffer);
  return buffer;
}

// Fills the rows from row `begin` of the frame on. Throws if a number is not finite.
template <typename Row>
void fill_block(const std::vector<Stripe>& stripes, std::size_t begin, std::span<Row> block,
                const std::string& file) {
  std::vector<double> buffer;
  for (const Stripe& stripe : stripes) {
    const std::size_t width = stripe.width;
    const std::span<const double> numbers = numbers_of(stripe, begin, block.size(), buffer);
    check_finite(numbers, [&](std::size_t number) {
      return Place{file, static_cast<std::int64_t>(begin + number / width) + 1};
    });
    for (std::size_t axis = 0; axis < width; ++axis)
      for (std::size_t i = 0; i < block.size(); ++i)
        slots_of(block[i])[stripe.first + axis] = numbers[i * width + axis];
  }
}

}  // namespace

// The boxes of all frames (32 bytes each).
struct Boxes {
  Boxes(const Hdf5File& file, const SnapshotSummary& summary, const std::string& name)
      : low(all_corners(file, "low", summary)), edges(all_corners(file, "edges", summary)) {
    const auto numbers = file.number_attribute(snapshot::box, snapshot::periodic);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const std::int64_t number = axis < numbers.size() ? numbers[axis] : -1;
      if (number != 0 && number != 1)
        throw bad_input({name}, "the box has no boundaries", "1 (periodic) or 0", fmt::format("{}", number));
      periodic[axis] = number == 1;
    }
  }

  /// The first frame whose box differs from that of the frame before; 0 if there is none.
  std::size_t first_other() const {
    for (std::size_t frame = 1; 2 * frame < low.size(); ++frame)
      if (is_another(of(frame - 1), of(frame))) return frame;
    return 0;
  }

  Box of(std::size_t frame) const {
    const Eigen::Vector2d corner(low[2 * frame], low[2 * frame + 1]);
    return {corner, corner + Eigen::Vector2d(edges[2 * frame], edges[2 * frame + 1]), periodic};
  }

  static std::vector<double> all_corners(const Hdf5File& file, const std::string& corner,
                                         const SnapshotSummary& summary) {
    std::vector<double> numbers(2 * summary.steps.size());
    const Hdf5Dataset dataset = file.dataset(snapshot::corner_path(corner));
    dataset.read<double>({{0, 0}, {summary.steps.size(), 2}}, numbers);
    check_finite(numbers, [&](std::size_t) { return Place{dataset.place()}; });
    return numbers;
  }

  std::vector<double> low, edges;
  std::array<bool, 2> periodic = {false, false};
};

struct SnapshotReader::Open {
  Open(const std::string& name, const ColumnWishes& wishes)
      : file(Hdf5File::open(name)),
        summary(summarise_snapshots(file, name)),
        boxes(file, summary, name),
        walls(file, wishes.walls) {
    const ColumnMap particles{{}, summary.particles_given};
    require_columns(particles,
                    wishes.particles_needed | particle_base_columns | column_set(ParticleColumn::id),
                    without_option(particle_names()), {name});
    const ColumnMap contacts{{}, summary.contacts_given};
    if (wishes.contacts_needed != 0)
      require_columns(contacts, required_contact_columns(wishes.contacts_needed, summary.contacts_given),
                      without_option(contact_names()), {name});
    for (Hdf5Dataset& dataset : summary.elements)
      elements.push_back(dataset.id() >= 0 ? ChunkReader(std::move(dataset)) : ChunkReader());
    const ColumnSet wanted = wanted_contact_columns(wishes.contacts_needed, summary.contacts_given, true);
    for (std::size_t slot = 0; slot < summary.columns.size(); ++slot)
      columns.push_back((wanted >> slot & 1U) != 0 ? ChunkReader(std::move(summary.columns[slot]))
                                                   : ChunkReader());
  }

  Hdf5File file;
  SnapshotSummary summary;
  Boxes boxes;
  WallReader walls;
  std::vector<ChunkReader> elements;  // in the order of snapshot::elements
  std::vector<ChunkReader> columns;   // by ContactColumn
};

// Call only if both files have frames.
bool SnapshotReader::are_of_two_systems(const Open& before, const Open& after) {
  const std::size_t frames = before.summary.steps.size();
  return frames > 0 && !after.summary.steps.empty() &&
         before.summary.most_particles != after.summary.most_particles &&
         jumps(before.boxes.of(frames - 1), after.boxes.of(0));
}

SnapshotReader::SnapshotReader(std::vector<std::string> files, ColumnWishes wishes)
    : files_(std::move(files)), wishes_(std::move(wishes)) {}

SnapshotReader::~SnapshotReader() = default;

std::string SnapshotReader::place() const {
  return fmt::format("{}:frame {}", files_[opened_ - 1], frame_ - 1);
}

bool SnapshotReader::open_next() {
  if (opened_ == files_.size()) return false;
  const std::string& file = files_[opened_++];
  const std::unique_ptr<Open> before = std::move(open_);
  bytes_before_ += std::exchange(bytes_, total_size({file}));
  open_ = std::make_unique<Open>(file, wishes_);
  if (before && before->boxes.periodic != open_->boxes.periodic && wishes_.notes)
    wishes_.notes->add(file + ": the boundaries are not those of the earlier files (another run?)");
  if (before && wishes_.notes && are_of_two_systems(*before, *open_))
    wishes_.notes->add(file + ": " + another_system);
  if (const std::size_t other = open_->boxes.first_other(); other > 0 && wishes_.notes)
    wishes_.notes->add(file + ": " + another_box, open_->summary.steps[other]);
  frame_ = 0;
  frames_ = open_->summary.steps.size();
  // A continued run writes the step that it starts from once more.
  if (frames_ > 0 && opened_ < files_.size()) {
    const auto next = summarise_snapshots(Hdf5File::open(files_[opened_]), files_[opened_]).steps;
    if (!next.empty() && next.front() == open_->summary.steps.back()) --frames_;
  }
  return true;
}

bool SnapshotReader::next(std::int64_t& step) {
  while (!open_ || frame_ == frames_)
    if (!open_next()) return false;
  step = open_->summary.steps[frame_++];
  if (step <= last_step_)
    throw bad_input({place()}, "time steps do not increase",
                    fmt::format("more than {} (another run: its own --snapshots)", last_step_),
                    fmt::format("{}", step));
  last_step_ = step;
  return true;
}

// The part of the file that its frames so far are.
std::int64_t SnapshotReader::bytes_read() const {
  if (!open_ || open_->summary.steps.empty()) return bytes_before_;
  const double part = static_cast<double>(frame_) / static_cast<double>(open_->summary.steps.size());
  return bytes_before_ + std::llround(part * static_cast<double>(bytes_));
}

std::int64_t SnapshotReader::contact_rows() const {
  const auto& offsets = open_->summary.contact_offsets;
  return offsets.empty() ? 0 : offsets[frame_] - offsets[frame_ - 1];
}

// A frame as stored in the file.
struct SnapshotReader::Packed {
  std::string place;
  std::int64_t step = 0;
  double time = not_given;
  Box box;
  ColumnSet particles_given = 0;
  std::vector<PackedNumbers> elements;
  bool with_contacts = false;
  ColumnSet contacts_given = 0;
  ColumnSet contacts_needed = 0;
  std::vector<PackedNumbers> columns;
  std::vector<WallState> walls;

  void unpack(RawFrame& frame) const;
  void unpack_particles(RawFrame& frame) const;
  void unpack_contacts(ContactRows& rows) const;
};

UnpackFrame SnapshotReader::take(bool closely) {
  const auto packed = std::make_shared<Packed>();
  const SnapshotSummary& summary = open_->summary;
  const std::uint64_t frame = frame_ - 1;
  packed->place = place();
  packed->step = last_step_;
  if (!summary.times.empty()) packed->time = summary.times[frame];
  packed->box = open_->boxes.of(frame);
  packed->walls = open_->walls.read(frame);
  packed->particles_given = summary.particles_given;
  for (std::size_t i = 0; i < std::size(snapshot::elements); ++i) {
    const bool given = (snapshot::elements[i].columns() & ~summary.particles_given) == 0;
    // An incomplete frame with more discs than any before may have widened only some of the datasets.
    ChunkReader& element = open_->elements[i];
    packed->elements.push_back(
        given ? element.take_row(frame, std::min(summary.most_particles, element.places()))
              : PackedNumbers());
  }
  packed->with_contacts = !summary.contact_offsets.empty();
  if (packed->with_contacts) {
    packed->contacts_needed = wishes_.contacts_needed;
    packed->contacts_given = wanted_contact_columns(wishes_.contacts_needed, summary.contacts_given, closely);
    const auto begin = static_cast<std::uint64_t>(summary.contact_offsets[frame]);
    const std::uint64_t count = static_cast<std::uint64_t>(summary.contact_offsets[frame + 1]) - begin;
    for (std::size_t slot = 0; slot < std::size(contact_column_names); ++slot)
      packed->columns.push_back((packed->contacts_given >> slot & 1U) != 0
                                    ? open_->columns[slot].take(begin, count)
                                    : PackedNumbers());
  }
  return [packed](RawFrame& raw) { packed->unpack(raw); };
}

void SnapshotReader::Packed::unpack(RawFrame& frame) const {
  frame.step = step;
  frame.time = time;
  frame.box = box;
  frame.walls = walls;
  unpack_particles(frame);
  frame.with_contacts = with_contacts;
  if (with_contacts) unpack_contacts(frame.contacts);
}

void SnapshotReader::Packed::unpack_particles(RawFrame& frame) const {
  std::vector<std::int64_t> ids(elements.front().size());
  elements.front().unpack(0, ids);
  const auto count =
      static_cast<std::size_t>(std::find(ids.begin(), ids.end(), snapshot::no_id) - ids.begin());
  if (std::any_of(ids.begin() + static_cast<std::ptrdiff_t>(count), ids.end(),
                  [](std::int64_t id) { return id != snapshot::no_id; }))
    throw bad_input({place}, fmt::format("slot {} has no disc, but later slots have some", count + 1),
                    "all discs before the empty slots", fmt::format("id {}", snapshot::no_id));
  std::vector<Stripe> stripes;
  for (std::size_t i = 0; i < std::size(snapshot::elements); ++i) {
    const auto& element = snapshot::elements[i];
    if ((element.columns() & ~particles_given) != 0) continue;
    const auto width = static_cast<std::size_t>(element.width);
    if (elements[i].size() < count * width)
      throw bad_input({place}, fmt::format("{} is missing for some discs", element.name),
                      fmt::format("{} discs", count), fmt::format("{}", elements[i].size() / width));
    stripes.push_back({&elements[i], static_cast<std::size_t>(element.first), width});
  }
  frame.particle_file = place;
  frame.first_particle_line = 1;
  frame.particles_given = particles_given;
  frame.particles.clear();
  frame.particles.reserve(count);
  ParticleSlots empty;
  empty.fill(not_given);
  // The available columns overwrite those of the previous block.
  std::vector<ParticleSlots> block(rows_of_block, empty);
  Place row{place, 0};
  for (std::size_t begin = 0; begin < count; begin += block.size()) {
    block.resize(std::min(rows_of_block, count - begin));
    fill_block(stripes, begin, std::span(block), place);
    for (const ParticleSlots& slots : block) {
      ++row.line;
      frame.particles.push_back(particle_of(slots, particles_given, row));
    }
  }
}

void SnapshotReader::Packed::unpack_contacts(ContactRows& rows) const {
  rows.file = place;
  rows.first_line = 1;
  rows.given = contacts_given;
  rows.needed = contacts_needed;
  std::vector<Stripe> stripes;
  for (std::size_t slot = 0; slot < columns.size(); ++slot)
    if ((contacts_given >> slot & 1U) != 0) stripes.push_back({&columns[slot], slot, 1});
  const std::size_t count = columns.front().size();
  ContactRow empty{};
  empty.value.fill(not_given);
  rows.rows.assign(count, empty);
  for (std::size_t begin = 0; begin < count; begin += rows_of_block) {
    const auto block = std::span(rows.rows).subspan(begin).first(std::min(rows_of_block, count - begin));
    fill_block(stripes, begin, block, place);
    for (std::size_t i = 0; i < block.size(); ++i)
      if (!is_sound(block[i], contacts_given))
        check_contact_row(block[i], contacts_given, false, rows.place(begin + i));
  }
}

}  // namespace mikromakro
