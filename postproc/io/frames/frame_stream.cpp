// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/frames/frame_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <numbers>

#include "io/frames/run_sequence.h"
#include "io/mercury/mercury_frames.h"
#include "io/snapshot/snapshot_reader.h"
#include "joining/overlapping_discs.h"
#include "joining/plausible_forces.h"
#include "model/id_map.h"
#include "model/same_box.h"

namespace mikromakro {
namespace {

void check_ids(const IdMap& ids, const RawFrame& raw) {
  const int twice = ids.duplicate();
  if (twice < 0) return;
  throw bad_input(raw.place_of_particle(static_cast<std::size_t>(twice)), "two particles with the same id",
                  "each id once per frame (another run: its own --particles)",
                  fmt::format("{} again", raw.particles[static_cast<std::size_t>(twice)].id));
}

void set_masses(RawFrame& raw, double density) {
  if (density == 0) return;
  constexpr ColumnSet mass = column_set(ParticleColumn::mass);
  if ((raw.particles_given & mass) != 0)
    throw bad_input({raw.particle_file, raw.first_particle_line - 1}, "the file gives masses",
                    "no --density with them", "both");
  const double in_units = density * raw.units.length * raw.units.length / raw.units.mass;
  for (Particle& particle : raw.particles)
    particle.mass = in_units * std::numbers::pi * particle.radius * particle.radius;
  raw.particles_given |= mass;
}

// True for discs cut by a periodic boundary; discs overlap walls by much less.
bool reaches_out(const Particle& disc, const Box& box) {
  constexpr double into_walls = 0.1;
  const double reach = (1 - into_walls) * disc.radius;
  return ((disc.position.array() - reach < box.low.array()) ||
          (disc.position.array() + reach > box.high.array()))
      .any();
}

void note_boundaries(const RawFrame& raw, Notes* notes) {
  if (raw.box.boundaries_known || notes == nullptr) return;
  const auto out = std::count_if(raw.particles.begin(), raw.particles.end(),
                                 [&](const Particle& disc) { return reaches_out(disc, raw.box); });
  if (out > 0)
    notes->add("the files do not say whether the box is periodic: discs that extend beyond it have no images",
               raw.step, out);
}

void complete(RawFrame& raw, double density, bool contacts_required) {
  if (contacts_required && !raw.with_contacts)
    throw bad_input({raw.particle_file}, "the file holds no contacts", "contacts, or --fields that need none",
                    "none");
  set_masses(raw, density);
}

std::unique_ptr<FrameFormat> open_run(const Run& run, const ColumnWishes& wishes) {
  if (!run.snapshot_files.empty()) return std::make_unique<SnapshotReader>(run.snapshot_files, wishes);
  if (MercuryDataReader::recognises(run.particle_files.front())) {
    if (!run.wall_files.empty())
      throw bad_input({run.particle_files.front()}, "MercuryDPM's .fstat contains the walls",
                      "no --wall-contacts with it", "them");
    return std::make_unique<MercuryFrames>(run.particle_files, run.contact_files, wishes);
  }
  return std::make_unique<TextFrames>(run.particle_files, run.contact_files, wishes, run.wall_files);
}

std::unique_ptr<FrameFormat> format_of(const FrameSource& source) {
  std::vector<RunSequence::Open> runs;
  for (const Run& run : source.runs())
    runs.emplace_back([run, wishes = source.wishes()] { return open_run(run, wishes); });
  return std::make_unique<RunSequence>(std::move(runs));
}

}  // namespace

void join(RawFrame& raw, Frame& frame, ContactRules rules) {
  const IdMap ids(raw.particles);
  check_ids(ids, raw);
  frame.step = raw.step;
  frame.box = raw.box;
  frame.contacts_known = raw.with_contacts;
  frame.contacts.clear();
  rules.step = raw.step;
  rules.closely = raw.closely;
  check_box(raw.box, {raw.particle_file, raw.first_particle_line - 1});
  note_boundaries(raw, rules.notes);
  if (raw.with_contacts)
    frame.contacts = join_contacts(raw.contacts, {raw.particles, ids, raw.box, raw.place_error}, rules);
  // A frame without contacts is rare, or its contacts are missing.
  const bool without = raw.with_contacts && frame.contacts.empty();
  if ((raw.closely || without) && rules.notes != nullptr) note_overlaps(raw, frame.contacts, rules);
  note_forces(frame.contacts, rules);
  if (raw.with_contacts) note_derived_overlaps(raw, frame.contacts, rules);
  // The rows are read again for the next frame.
  frame.particles.swap(raw.particles);
  convert(raw.units, raw, frame);
  frame.time = raw.time;
  frame.walls = raw.walls;
}

ColumnWishes FrameSource::wishes() const {
  const ColumnSet mass = density > 0 ? column_set(ParticleColumn::mass) : 0;
  return {particle_columns, contact_columns, particles_needed & ~mass,
          contacts_needed,  notes,           selection,
          look_through,     wall_columns,    walls};
}

std::vector<Run> FrameSource::runs() const {
  std::vector<Run> all = {{particle_files, contact_files, snapshot_files, wall_files}};
  all.insert(all.end(), further_runs.begin(), further_runs.end());
  return all;
}

FrameSource FrameSource::one_run(std::size_t run) const {
  const Run files = runs()[run];
  FrameSource one = *this;
  one.particle_files = files.particle_files;
  one.contact_files = files.contact_files;
  one.snapshot_files = files.snapshot_files;
  one.wall_files = files.wall_files;
  one.further_runs.clear();
  one.selection = {};
  one.of_all_ranks.reset();
  one.notes = std::make_shared<Notes>();
  return one;
}

std::vector<std::string> FrameSource::files() const {
  std::vector<std::string> all;
  for (const Run& run : runs())
    for (const auto* files : {&run.snapshot_files, &run.particle_files, &run.contact_files, &run.wall_files})
      all.insert(all.end(), files->begin(), files->end());
  return all;
}

FrameSource::Count FrameSource::count() const {
  const auto format = format_of(*this);
  Count count;
  std::int64_t index = 0;
  for (std::int64_t step = 0; format->next(step); ++index) {
    if (!format->take()) continue;
    if (count.frames == 0) count.first_step = step;
    count.frames = index + 1;
    count.last_step = step;
  }
  return count;
}

FrameSelection FrameSource::settled_selection() const {
  if (!selection.counts_from_the_end()) return selection;
  const std::int64_t frames = count().frames;
  if (selection.first + frames < 0 && selection.last >= selection.first)
    notes->add(
        fmt::format("--frames: frame {} is the first one, {} would be before it", -frames, selection.first));
  return selection.among(frames);
}

Error FrameSource::no_frame_selected() const {
  const Count there = count();
  const std::string all = there.frames > 1 ? fmt::format(" of 0 to {}, steps {} to {},", there.frames - 1,
                                                         there.first_step, there.last_step)
                                           : "";
  return bad_input({files().front()}, "no frame is selected",
                   fmt::format("frames{} that --frames and --steps select", all), "0");
}

FrameStream::FrameStream(const FrameSource& source)
    : selection_(source.settled_selection()),
      of_all_ranks_(source.of_all_ranks.value_or(selection_)),
      density_(source.density),
      contacts_required_(source.contacts_required),
      distant_contacts_(source.distant_contacts),
      averaged_types_(source.averaged_types),
      notes_(source.notes),
      one_run_(source.further_runs.empty()),
      format_(format_of(source)) {}

// The first frame of each run, every 64th, and those with a quarter more or a fifth fewer contacts than any
// frame checked so far: a run that starts with separated discs has no contacts to check in its first frame,
// and a frame that has lost rows may occur anywhere.
bool FrameStream::is_checked_closely(std::int64_t step) {
  constexpr std::int64_t seldom = 64;
  if (!of_all_ranks_.contains(index_, step)) return false;
  if (last_selected_run_ != format_->run()) selected_of_run_ = most_rows_checked_ = least_rows_checked_ = 0;
  last_selected_run_ = format_->run();
  ++selected_;
  const std::int64_t number = selected_of_run_++, rows = format_->contact_rows();
  const bool unlike = rows < 0 ? std::has_single_bit(static_cast<std::uint64_t>(number))
                               : 4 * rows > 5 * most_rows_checked_ || 5 * rows < 4 * least_rows_checked_;
  if (number % seldom != 0 && !unlike) return false;
  most_rows_checked_ = std::max(most_rows_checked_, rows);
  least_rows_checked_ = number == 0 ? rows : std::min(least_rows_checked_, rows);
  return true;
}

UnpackFrame FrameStream::take_raw() {
  std::int64_t step = 0;
  while (!over_) {
    if (!format_->next(step)) {
      note_last_frame();
      break;
    }
    ++index_;
    // Time steps restart with each run.
    over_ = one_run_ ? selection_.over_after(index_, step) : index_ >= selection_.last;
    closely_ = is_checked_closely(step);
    if (!selection_.contains(index_, step)) continue;
    // Empty if a file was truncated.
    if (UnpackFrame unpack = format_->take(closely_)) return unpack;
  }
  return {};
}

// Notes if the last requested frame does not exist.
void FrameStream::note_last_frame() {
  over_ = true;
  const bool asked_for = of_all_ranks_.last < std::numeric_limits<std::int64_t>::max();
  if (asked_for && of_all_ranks_.last > index_ && selected_ > 0)
    notes_->add(fmt::format("--frames: frame {} is the last one, not {}", index_, of_all_ranks_.last));
}

bool FrameStream::next(Frame& frame) {
  const UnpackFrame unpack = take_raw();
  if (!unpack) return false;
  raw_.further_pieces.clear();
  raw_.place_error = not_given;
  raw_.units = {};
  raw_.closely = closely_;
  unpack(raw_);
  complete(raw_, density_, contacts_required_);
  join(raw_, frame, {distant_contacts_, notes_.get(), Notes::whole, averaged_types_});
  frame.index = index_;
  frame.run = format_->run();
  return true;
}

MakeFrame FrameStream::take() {
  UnpackFrame unpack = take_raw();
  if (!unpack) return {};
  return [unpack = std::move(unpack), density = density_, required = contacts_required_, index = index_,
          run = format_->run(), closely = closely_, distant = distant_contacts_, notes = notes_,
          types = averaged_types_](Frame& frame) {
    RawFrame raw;
    raw.closely = closely;
    unpack(raw);
    complete(raw, density, required);
    join(raw, frame, {distant, notes.get(), Notes::whole, types});
    frame.index = index;
    frame.run = run;
  };
}

}  // namespace mikromakro
