#include "io/text_frames.h"

#include <fmt/format.h>

#include "io/contact_reader.h"
#include "io/particle_reader.h"

namespace mikromakro {
namespace {

using Blocks = std::vector<std::shared_ptr<const RowBlock>>;

void unpack_particles(const Blocks& pieces, const ColumnWishes& wishes, ColumnSet needed, RawFrame& frame) {
  for (const auto& piece : pieces) {
    ColumnSet given = 0;
    std::vector<Particle> particles = read_particles(*piece, wishes.particle_columns, needed, given);
    if (piece == pieces.front()) {
      frame.particles = std::move(particles);
      frame.particles_given = given;
      continue;
    }
    frame.further_pieces.push_back({frame.particles.size(), piece->file, piece->header.line + 1});
    frame.particles.insert(frame.particles.end(), particles.begin(), particles.end());
    frame.particles_given &= given;
  }
}

void unpack_contacts(const Blocks& pieces, const ColumnWishes& wishes, ContactRows& contacts) {
  for (const auto& piece : pieces) {
    ContactRows rows = read_contacts(*piece, wishes.contact_columns, wishes.contacts_needed);
    piece == pieces.front() ? void(contacts = std::move(rows)) : contacts.append(rows);
  }
}

}  // namespace

TextFrames::TextFrames(const std::vector<std::string>& particle_files,
                       const std::vector<std::string>& contact_files, ColumnWishes wishes)
    : wishes_(std::make_shared<const ColumnWishes>(std::move(wishes))),
      frames_({wishes_->selection, wishes_->look_through, wishes_->notes}) {
  frames_.add<DumpReader>(particle_files);
  particle_pieces_ = frames_.size();
  if (!contact_files.empty()) frames_.add<DumpReader>(contact_files);
}

bool TextFrames::next(std::int64_t& step) {
  if (!frames_.next()) return false;
  step = frames_.header(0).step;
  find_units();
  return true;
}

// LAMMPS names them before the first frame of the first file only, and perhaps in one of the dumps only.
void TextFrames::find_units() {
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const DumpHeader& header = frames_.header(i);
    if (header.units.empty() || header.units == units_name_) continue;
    const Place place{frames_.file(i), header.line};
    const Units units = units_of(header.units, place);
    if (!units_name_.empty() || (some_taken_ && !units.are_si()))
      throw bad_input(place, "the units change",
                      units_name_.empty() ? "units of the frames before" : in_quotes(units_name_),
                      in_quotes(header.units));
    units_name_ = header.units;
    units_ = units;
    if (const std::string text = units_note(units_name_); !text.empty())
      wishes_->notes->add(fmt::format("{}: {}", frames_.file(i), text));
  }
}

UnpackFrame TextFrames::take() {
  const Blocks blocks = frames_.take_rows();
  if (blocks.empty()) return {};
  some_taken_ = true;
  const auto first_contacts = blocks.begin() + static_cast<std::ptrdiff_t>(particle_pieces_);
  // Pieces that are the same file twice are only seen by their ids.
  const ColumnSet ids = blocks.size() > 1 ? column_set(ParticleColumn::id) : 0;
  return [wishes = wishes_, units = units_, needed = wishes_->particles_needed | ids,
          particles = Blocks(blocks.begin(), first_contacts),
          contacts = Blocks(first_contacts, blocks.end())](RawFrame& frame) {
    const RowBlock& first = *particles.front();
    frame.step = first.header.step;
    frame.time = first.header.time;
    frame.box = first.header.box;
    frame.particle_file = first.file;
    frame.first_particle_line = first.header.line + 1;
    unpack_particles(particles, *wishes, needed, frame);
    frame.with_contacts = !contacts.empty();
    if (frame.with_contacts) unpack_contacts(contacts, *wishes, frame.contacts);
    convert(units, frame);
  };
}

}  // namespace mikromakro
