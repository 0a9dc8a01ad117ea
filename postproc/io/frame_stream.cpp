#include "io/frame_stream.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/contact_geometry.h"
#include "io/contact_reader.h"
#include "io/id_map.h"
#include "io/particle_reader.h"

namespace mikromakro {
namespace {

std::int64_t first_step_of(const std::string& file) {
  DumpHeader header;
  DumpReader(file).next_header(header);
  return header.step;
}

void check_ids(const IdMap& ids, const std::vector<Particle>& particles, const Place& header) {
  const int twice = ids.duplicate();
  if (twice < 0) return;
  throw bad_input({header.file, header.line + 1 + twice}, "two particles of one id", "each id once per frame",
                  fmt::format("{} again", particles[static_cast<std::size_t>(twice)].id));
}

}  // namespace

DumpSequence::DumpSequence(const std::vector<std::string>& files) {
  std::vector<std::pair<std::int64_t, std::string>> by_step;
  by_step.reserve(files.size());
  for (const std::string& file : files) by_step.emplace_back(first_step_of(file), file);
  std::stable_sort(by_step.begin(), by_step.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [step, file] : by_step) files_.push_back(std::move(file));
}

bool DumpSequence::next(DumpHeader& header) {
  while (true) {
    if (dump_ && dump_->next_header(header)) break;
    if (opened_ == files_.size()) return false;
    bytes_before_ = bytes_read();
    dump_ = std::make_unique<DumpReader>(files_[opened_++]);
  }
  if (last_step_ && header.step <= *last_step_) {
    throw bad_input({dump_->file(), header.line}, "time steps do not ascend",
                    fmt::format("more than {}", *last_step_), fmt::format("{}", header.step));
  }
  last_step_ = header.step;
  return true;
}

FrameStream::FrameStream(const FrameSource& source) : source_(source), particles_(source.particle_files) {
  if (!source.contact_files.empty()) contacts_.emplace(source.contact_files);
}

std::int64_t FrameStream::bytes_read() const {
  return particles_.bytes_read() + (contacts_ ? contacts_->bytes_read() : 0);
}

bool FrameStream::next(Frame& frame) {
  DumpHeader of_particles;
  DumpHeader of_contacts;
  while (!over_ && next_headers(of_particles, of_contacts)) {
    ++index_;
    over_ = source_.selection.over_after(index_, of_particles.step);
    if (!source_.selection.contains(index_, of_particles.step)) continue;
    read(of_particles, of_contacts, frame);
    return true;
  }
  return false;
}

bool FrameStream::next_headers(DumpHeader& of_particles, DumpHeader& of_contacts) {
  const bool some_particles = particles_.next(of_particles);
  if (!contacts_) return some_particles;
  const bool some_contacts = contacts_->next(of_contacts);
  if (!some_particles && !some_contacts) return false;
  if (some_particles && some_contacts && of_particles.step == of_contacts.step) return true;
  // The earlier step of the two is the one without partner.
  const bool particles_alone = some_particles && (!some_contacts || of_particles.step < of_contacts.step);
  DumpSequence& dumps = particles_alone ? particles_ : *contacts_;
  const DumpHeader& alone = particles_alone ? of_particles : of_contacts;
  const DumpHeader& other = particles_alone ? of_contacts : of_particles;
  const bool some_other = particles_alone ? some_contacts : some_particles;
  throw bad_input(
      {dumps.dump().file(), alone.line},
      particles_alone ? "frame of particles without contacts" : "frame of contacts without particles",
      fmt::format("step {} in both", alone.step),
      some_other ? fmt::format("step {} there", other.step) : "no more frames there");
}

void FrameStream::read(const DumpHeader& of_particles, const DumpHeader& of_contacts, Frame& frame) {
  frame.step = of_particles.step;
  frame.box = of_particles.box;
  frame.particles =
      read_particles(particles_.dump(), of_particles, source_.particle_columns, source_.particles_needed);
  const IdMap ids(frame.particles);
  check_ids(ids, frame.particles, {particles_.dump().file(), of_particles.line});
  frame.contacts.clear();
  if (!contacts_) return;
  const ContactRows rows =
      read_contacts(contacts_->dump(), of_contacts, source_.contact_columns, source_.contacts_needed);
  frame.contacts = join_contacts(rows, frame.particles, ids, frame.box);
}

}  // namespace mikromakro
