#include "io/frame_stream.h"

#include <fmt/format.h>

#include "io/contact_geometry.h"
#include "io/id_map.h"
#include "io/snapshot_reader.h"

namespace mikromakro {
namespace {

void check_ids(const IdMap& ids, const RawFrame& raw) {
  const int twice = ids.duplicate();
  if (twice < 0) return;
  throw bad_input({raw.particle_file, raw.first_particle_line + twice}, "two particles of one id",
                  "each id once per frame",
                  fmt::format("{} again", raw.particles[static_cast<std::size_t>(twice)].id));
}

// Particles go over to the frame, contacts become those of particles.
void join(RawFrame& raw, Frame& frame) {
  const IdMap ids(raw.particles);
  check_ids(ids, raw);
  frame.step = raw.step;
  frame.box = raw.box;
  frame.contacts.clear();
  if (raw.with_contacts) frame.contacts = join_contacts(raw.contacts, raw.particles, ids, frame.box);
  // The rows are read anew for the next frame.
  frame.particles.swap(raw.particles);
}

std::unique_ptr<FrameFormat> format_of(const FrameSource& source) {
  if (!source.snapshot_files.empty())
    return std::make_unique<SnapshotReader>(source.snapshot_files, source.wishes());
  return std::make_unique<TextFrames>(source.particle_files, source.contact_files, source.wishes());
}

}  // namespace

std::vector<std::string> FrameSource::files() const {
  std::vector<std::string> all = snapshot_files;
  all.insert(all.end(), particle_files.begin(), particle_files.end());
  all.insert(all.end(), contact_files.begin(), contact_files.end());
  return all;
}

FrameStream::FrameStream(const FrameSource& source)
    : selection_(source.selection), format_(format_of(source)) {}

UnpackFrame FrameStream::take_raw() {
  std::int64_t step = 0;
  while (!over_ && format_->next(step)) {
    ++index_;
    over_ = selection_.over_after(index_, step);
    if (selection_.contains(index_, step)) return format_->take();
  }
  return {};
}

bool FrameStream::next(Frame& frame) {
  const UnpackFrame unpack = take_raw();
  if (!unpack) return false;
  unpack(raw_);
  join(raw_, frame);
  return true;
}

MakeFrame FrameStream::take() {
  UnpackFrame unpack = take_raw();
  if (!unpack) return {};
  return [unpack = std::move(unpack)](Frame& frame) {
    RawFrame raw;
    unpack(raw);
    join(raw, frame);
  };
}

}  // namespace mikromakro
