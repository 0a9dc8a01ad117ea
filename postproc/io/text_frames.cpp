#include "io/text_frames.h"

#include <fmt/format.h>

#include "io/contact_presets.h"
#include "io/contact_reader.h"
#include "io/particle_reader.h"

namespace mikromakro {
namespace {

void add_walls(const RowBlock& block, const ColumnWishes& wishes, bool beside_discs, RawFrame& frame) {
  ContactRows walls = read_contacts(block, {wishes.wall_columns, true}, wishes.contacts_needed);
  if (beside_discs)
    add_wall_contacts(std::move(walls), frame.contacts);
  else
    frame.contacts = std::move(walls);
}

void note_missing_forces(const RowBlock* contacts, const ColumnWishes& wishes) {
  if (contacts == nullptr || !is_without_tangential_forces(wishes.contact_columns, contacts->header)) return;
  wishes.notes->add(fmt::format("{}: compute pair/local gives normal forces only (its p1 p2 p3 are the "
                                "tangential ones of granular styles)",
                                contacts->file));
}

}  // namespace

TextFrames::TextFrames(const std::vector<std::string>& particle_files,
                       const std::vector<std::string>& contact_files, ColumnWishes wishes,
                       const std::vector<std::string>& wall_files)
    : wishes_(std::make_shared<const ColumnWishes>(std::move(wishes))), particles_(particle_files) {
  if (!contact_files.empty()) contacts_.emplace(contact_files);
  if (!wall_files.empty()) walls_ = std::make_unique<WallDumps>(wall_files);
}

std::int64_t TextFrames::bytes_read() const {
  return particles_.bytes_read() + (contacts_ ? contacts_->bytes_read() : 0) +
         (walls_ ? walls_->bytes_read() : 0);
}

bool TextFrames::next(std::int64_t& step) {
  const bool some_particles = particles_.next(of_particles_);
  if (contacts_) check_partners(some_particles, contacts_->next(of_contacts_));
  step = of_particles_.step;
  return some_particles;
}

void TextFrames::check_partners(bool some_particles, bool some_contacts) {
  if (!some_particles && !some_contacts) return;
  if (some_particles && some_contacts && of_particles_.step == of_contacts_.step) return;
  // The earlier step of the two is the one without partner.
  const bool particles_alone = some_particles && (!some_contacts || of_particles_.step < of_contacts_.step);
  FileSequence<DumpReader>& dumps = particles_alone ? particles_ : *contacts_;
  const DumpHeader& alone = particles_alone ? of_particles_ : of_contacts_;
  const DumpHeader& other = particles_alone ? of_contacts_ : of_particles_;
  const bool some_other = particles_alone ? some_contacts : some_particles;
  throw bad_input(
      {dumps.reader().file(), alone.line},
      particles_alone ? "frame of particles without contacts" : "frame of contacts without particles",
      fmt::format("step {} in both", alone.step),
      some_other ? fmt::format("step {} there", other.step) : "no more frames there");
}

UnpackFrame TextFrames::take() {
  const auto particles = std::make_shared<const RowBlock>(particles_.reader().take_rows(of_particles_));
  const auto contacts =
      contacts_ ? std::make_shared<const RowBlock>(contacts_->reader().take_rows(of_contacts_)) : nullptr;
  const auto walls = walls_ ? walls_->take(of_particles_.step) : nullptr;
  return [wishes = wishes_, particles, contacts, walls](RawFrame& frame) {
    frame.step = particles->header.step;
    frame.box = particles->header.box;
    frame.particle_file = particles->file;
    frame.first_particle_line = particles->header.line + 1;
    frame.particles =
        read_particles(*particles, wishes->particle_columns, wishes->particles_needed, frame.particles_given);
    frame.with_contacts = contacts != nullptr || walls != nullptr;
    if (contacts)
      frame.contacts = read_contacts(*contacts, {wishes->contact_columns}, wishes->contacts_needed);
    if (walls) add_walls(*walls, *wishes, contacts != nullptr, frame);
    note_missing_forces(contacts.get(), *wishes);
  };
}

}  // namespace mikromakro
