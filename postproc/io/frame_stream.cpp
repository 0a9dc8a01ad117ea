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

bool FrameStream::next(Frame& frame) {
  std::int64_t step = 0;
  while (!over_ && format_->next(step)) {
    ++index_;
    over_ = selection_.over_after(index_, step);
    if (!selection_.contains(index_, step)) continue;
    read(frame);
    return true;
  }
  return false;
}

void FrameStream::read(Frame& frame) {
  format_->read(raw_);
  const IdMap ids(raw_.particles);
  check_ids(ids, raw_);
  frame.step = raw_.step;
  frame.box = raw_.box;
  frame.contacts.clear();
  if (raw_.with_contacts) frame.contacts = join_contacts(raw_.contacts, raw_.particles, ids, frame.box);
  // The rows are read anew for the next frame.
  frame.particles.swap(raw_.particles);
}

}  // namespace mikromakro
