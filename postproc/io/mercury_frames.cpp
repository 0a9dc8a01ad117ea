#include "io/mercury_frames.h"

#include <fmt/format.h>

#include <cmath>

#include "io/mercury_rows.h"

namespace mikromakro {
namespace {

// Six digits of each.
constexpr double same_time = 1e-5;

bool same(double a, double b) {
  return std::abs(a - b) <= same_time * std::max(std::abs(a), std::abs(b));
}

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

}  // namespace

MercuryFrames::MercuryFrames(const std::vector<std::string>& particle_files,
                             const std::vector<std::string>& contact_files, const ColumnWishes& wishes)
    : contacts_needed_(wishes.contacts_needed), particles_(particle_files) {
  check_wishes(particle_files.front(), wishes);
  if (!contact_files.empty()) contacts_.emplace(contact_files);
}

std::int64_t MercuryFrames::bytes_read() const {
  return particles_.bytes_read() + (contacts_ ? contacts_->bytes_read() : 0);
}

bool MercuryFrames::next(std::int64_t& step) {
  const bool some_particles = particles_.next(of_particles_);
  if (contacts_) check_partners(some_particles, contacts_->next(of_contacts_));
  step = ++step_;
  return some_particles;
}

void MercuryFrames::check_partners(bool some_particles, bool some_contacts) {
  if (!some_particles && !some_contacts) return;
  if (some_particles && some_contacts && same(of_particles_.time, of_contacts_.time)) return;
  const bool particles_alone = some_particles && (!some_contacts || of_particles_.time < of_contacts_.time);
  const MercuryHeader& alone = particles_alone ? of_particles_ : of_contacts_;
  const std::string& file = particles_alone ? particles_.reader().file() : contacts_->reader().file();
  throw bad_input(
      {file, alone.line},
      particles_alone ? "frame of particles without contacts" : "frame of contacts without particles",
      fmt::format("time {} in both", alone.time),
      some_particles && some_contacts
          ? fmt::format("time {} there", (particles_alone ? of_contacts_ : of_particles_).time)
          : "no more frames there");
}

UnpackFrame MercuryFrames::take() {
  const auto particles = std::make_shared<const MercuryBlock>(particles_.reader().take_rows(of_particles_));
  const auto contacts =
      contacts_ ? std::make_shared<const MercuryBlock>(contacts_->reader().take_rows(of_contacts_)) : nullptr;
  return [step = step_, needed = contacts_needed_, particles, contacts](RawFrame& frame) {
    frame.step = step;
    frame.box = particles->header.box;
    frame.particle_file = particles->file;
    frame.first_particle_line = particles->header.line + 1;
    frame.particles_given = mercury_particle_columns;
    frame.particles = mercury_particles(*particles);
    frame.with_contacts = contacts != nullptr;
    if (!contacts) return;
    frame.contacts = mercury_contacts(*contacts, frame.particles);
    frame.contacts.needed = needed;
  };
}

}  // namespace mikromakro
