// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/mercury/mercury_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/files/column_map.h"
#include "io/mercury/mercury_rows.h"
#include "model/same_box.h"

namespace mikromakro {
namespace {

void check_wishes(const std::string& file, const ColumnWishes& wishes) {
  const Place place{file};
  if (!wishes.particle_columns.empty() || !wishes.contact_columns.empty())
    throw bad_input(place, "columns of MercuryDPM's files are known",
                    "no --particle-columns, --contact-columns", "one of them");
  if ((wishes.particles_needed & column_set(ParticleColumn::mass)) != 0)
    throw bad_input(place, "MercuryDPM's files give no masses", "--density (kg/m^2) or fields without mass",
                    "neither");
  const ColumnMap contacts{{}, mercury_contact_columns};
  const ColumnNames names{contact_names().known, contact_names().ignored, ""};
  if (wishes.contacts_needed != 0) require_columns(contacts, wishes.contacts_needed, names, place);
}

// Interaction radii exceed the particle radii for cohesive particles, so a difference is not an error.
void note_other_radii(const RawFrame& frame, const MercuryBlock& contacts, Notes& notes) {
  if (!contacts.header.radii || frame.particles.empty()) return;
  const auto [smallest, largest] = std::minmax_element(
      frame.particles.begin(), frame.particles.end(),
      [](const Particle& one, const Particle& other) { return one.radius < other.radius; });
  constexpr double digits = 1e-5;
  const auto differs = [](double told, double radius) { return std::abs(told - radius) > digits * radius; };
  if (differs(contacts.header.radii->smallest, smallest->radius) ||
      differs(contacts.header.radii->largest, largest->radius))
    notes.add(fmt::format("{}: the radii in the header are not those of the particles (from another run? "
                          "radii of interaction?)",
                          contacts.file),
              frame.step);
}

void check_same_run(const RawFrame& frame, const MercuryBlock& contacts, Notes& notes) {
  if (contacts.header.box)
    check_same_box(frame.box, *contacts.header.box, {contacts.file, contacts.header.line - 1});
  note_other_radii(frame, contacts, notes);
}

}  // namespace

// Here steps are frame numbers, not those of a selection.
MercuryFrames::MercuryFrames(const std::vector<std::string>& particle_files,
                             const std::vector<std::string>& contact_files, ColumnWishes wishes)
    : wishes_(std::move(wishes)), frames_({{}, wishes_.look_through, wishes_.notes}) {
  check_wishes(particle_files.front(), wishes_);
  frames_.add<MercuryDataReader>(particle_files);
  if (!contact_files.empty()) frames_.add<MercuryFstatReader>(contact_files);
}

bool MercuryFrames::next(std::int64_t& step) {
  step = ++step_;
  return frames_.next();
}

UnpackFrame MercuryFrames::take(bool) {
  const auto blocks = frames_.take_rows();
  if (blocks.empty()) return {};
  return [step = step_, wishes = wishes_, blocks](RawFrame& frame) {
    const MercuryBlock& particles = *blocks.front();
    frame.step = step;
    frame.box = particles.header.box.value_or(Box{});
    frame.particle_file = particles.file;
    frame.first_particle_line = particles.header.line + 1;
    frame.particles = mercury_particles(particles, wishes.particles_needed, frame.particles_given);
    frame.with_contacts = blocks.size() > 1;
    if (!frame.with_contacts) return;
    check_same_run(frame, *blocks.back(), *wishes.notes);
    frame.contacts = mercury_contacts(*blocks.back(), frame.particles);
    frame.contacts.needed = wishes.contacts_needed;
    frame.closely = frame.closely || blocks.back()->may_be_cut;
  };
}

}  // namespace mikromakro
