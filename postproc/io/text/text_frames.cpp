// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/text/text_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/text/contact_presets.h"
#include "io/text/contact_reader.h"
#include "io/text/particle_reader.h"
#include "model/same_box.h"

namespace mikromakro {
namespace {

using Blocks = std::vector<std::shared_ptr<const RowBlock>>;

void unpack_particles(const Blocks& pieces, const ColumnWishes& wishes, ColumnSet needed, RawFrame& frame) {
  frame.particles.clear();
  for (const auto& piece : pieces) {
    ParticleRows rows = read_particles(*piece, wishes.particle_columns, needed);
    if (piece == pieces.front()) {
      frame.particles = std::move(rows.particles);
      frame.particles_given = rows.given;
      frame.place_error = rows.place_error;
      continue;
    }
    frame.further_pieces.push_back({frame.particles.size(), piece->file, piece->header.line + 1});
    frame.particles.insert(frame.particles.end(), rows.particles.begin(), rows.particles.end());
    frame.particles_given &= rows.given;
    frame.place_error = std::fmax(frame.place_error, rows.place_error);
  }
}

ContactRows contacts_of(const Blocks& pieces, const ContactFormat& format, ColumnSet needed) {
  ContactRows contacts;
  for (const auto& piece : pieces) {
    ContactRows rows = read_contacts(*piece, format, needed);
    piece == pieces.front() ? void(contacts = std::move(rows)) : contacts.append(rows);
  }
  return contacts;
}

void note_missing_forces(const Blocks& contacts, const ColumnWishes& wishes) {
  if (contacts.empty() || !is_without_tangential_forces(wishes.contact_columns, contacts.front()->header))
    return;
  wishes.notes->add(
      fmt::format("{}: compute pair/local gives normal forces only (its p1 p2 p3 are the "
                  "tangential ones of granular styles)",
                  contacts.front()->file));
}

// Fewer may leave at once.
constexpr std::int64_t many_discs = 20;

}  // namespace

TextFrames::TextFrames(const std::vector<std::string>& particle_files,
                       const std::vector<std::string>& contact_files, ColumnWishes wishes,
                       const std::vector<std::string>& wall_files)
    : wishes_(std::make_shared<const ColumnWishes>(std::move(wishes))),
      frames_({wishes_->selection, wishes_->look_through, wishes_->notes}) {
  frames_.add<DumpReader>(particle_files);
  particle_pieces_ = frames_.size();
  if (!contact_files.empty()) frames_.add<DumpReader>(contact_files);
  contact_pieces_ = frames_.size() - particle_pieces_;
  if (!wall_files.empty()) frames_.add<DumpReader>(wall_files);
}

bool TextFrames::next(std::int64_t& step) {
  if (!frames_.next()) return false;
  step = frames_.header(0).step;
  if (!last_size_) note_names();
  check_boundaries();
  check_system();
  find_units();
  return true;
}

std::int64_t TextFrames::contact_rows() const {
  std::int64_t rows = 0;
  for (std::size_t piece = particle_pieces_; piece < frames_.size(); ++piece)
    rows += frames_.header(piece).rows;
  return rows;
}

void TextFrames::note_names() {
  note_other_names(wishes_->particle_columns, frames_.header(0).columns, particle_names(),
                   wishes_->notes.get());
  if (contact_pieces_ > 0)
    note_other_names(wishes_->contact_columns, frames_.header(particle_pieces_).columns, contact_names(),
                     wishes_->notes.get());
}

// Notes if the boundaries change between the frames of a run, as far as the files give them.
void TextFrames::check_boundaries() {
  const Box& box = frames_.header(0).box;
  if (!box.boundaries_known) return;
  if (last_box_ && last_box_->periodic != box.periodic)
    wishes_->notes->add(frames_.file(0) +
                        ": the boundaries are not those of the earlier frames (another run?)");
  last_box_ = box;
}

void TextFrames::check_system() {
  const DumpHeader& header = frames_.header(0);
  std::int64_t rows = 0;
  for (std::size_t piece = 0; piece < particle_pieces_; ++piece) rows += frames_.header(piece).rows;
  if (last_size_ && last_size_->rows != rows && jumps(last_size_->box, header.box))
    wishes_->notes->add(frames_.file(0) + ": " + another_system);
  else if (last_size_ && is_another(last_size_->box, header.box))
    wishes_->notes->add(frames_.file(0) + ": " + another_box, header.step);
  const bool lost = last_size_ && 3 * (last_size_->rows - rows) > last_size_->rows;
  const bool back = last_size_ && rows == rows_before_last_ && last_size_->rows < rows;
  if ((lost || back) && std::max(rows, last_size_->rows) >= many_discs)
    wishes_->notes->add(
        frames_.file(0) + (lost ? ": more than a third of the discs of the previous frame are missing (discs "
                                  "that left, or rows left out?)"
                                : ": discs reappear that are missing in the previous frame (rows left out?)"),
        header.step);
  rows_before_last_ = last_size_ ? last_size_->rows : -1;
  last_size_ = {header.box, rows};
}

// LAMMPS names the units only before the first frame of the first file, and possibly in one of the dumps
// only.
void TextFrames::find_units() {
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const DumpHeader& header = frames_.header(i);
    if (header.units.empty() || header.units == units_name_) continue;
    const Place place{frames_.file(i), header.line};
    const Units units = units_of(header.units, place);
    if (!units_name_.empty() || (some_taken_ && !units.are_si()))
      throw bad_input(place, "the units change",
                      units_name_.empty() ? "the units of the earlier frames" : in_quotes(units_name_),
                      in_quotes(header.units));
    units_name_ = header.units;
    units_ = units;
    if (const std::string text = units_note(units_name_); !text.empty())
      wishes_->notes->add(fmt::format("{}: {}", frames_.file(i), text));
  }
}

// The rows of a frame as in the files.
struct TextFrames::Packed {
  std::shared_ptr<const ColumnWishes> wishes;
  Units units;
  bool closely;
  Blocks particles, contacts, walls;

  void unpack(RawFrame& frame) const {
    const RowBlock& first = *particles.front();
    frame.step = first.header.step;
    frame.time = first.header.time;
    frame.box = first.header.box;
    frame.units = units;
    frame.particle_file = first.file;
    frame.first_particle_line = first.header.line + 1;
    frame.with_contacts = !contacts.empty() || !walls.empty();
    // Pieces that are the same file twice can be detected only by ids.
    const bool ids = frame.with_contacts || particles.size() > 1;
    unpack_particles(particles, *wishes,
                     wishes->particles_needed | (ids ? column_set(ParticleColumn::id) : 0), frame);
    if (frame.with_contacts) unpack_contacts(frame);
  }

  void unpack_contacts(RawFrame& frame) const {
    for (const Blocks* files : {&contacts, &walls})
      for (const auto& piece : *files)
        check_same_box(particles.front()->header.box, piece->header.box, {piece->file, piece->header.line});
    if (!contacts.empty())
      frame.contacts =
          contacts_of(contacts, {wishes->contact_columns, false, closely}, wishes->contacts_needed);
    if (!walls.empty()) {
      ContactRows rows = contacts_of(walls, {wishes->wall_columns, true, closely}, wishes->contacts_needed);
      contacts.empty() ? void(frame.contacts = std::move(rows))
                       : add_wall_contacts(std::move(rows), frame.contacts);
    }
    note_missing_forces(contacts, *wishes);
  }
};

UnpackFrame TextFrames::take(bool closely) {
  const Blocks blocks = frames_.take_rows();
  if (blocks.empty()) return {};
  some_taken_ = true;
  const auto first_contacts = blocks.begin() + static_cast<std::ptrdiff_t>(particle_pieces_);
  const auto first_walls = first_contacts + static_cast<std::ptrdiff_t>(contact_pieces_);
  const Packed packed{wishes_,
                      units_,
                      closely,
                      {blocks.begin(), first_contacts},
                      {first_contacts, first_walls},
                      {first_walls, blocks.end()}};
  return [packed](RawFrame& frame) { packed.unpack(frame); };
}

}  // namespace mikromakro
