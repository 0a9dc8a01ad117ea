// Frames of our HDF5 snapshots.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "io/frame_format.h"
#include "io/hdf5_file.h"
#include "io/text_frames.h"

namespace mikromakro {

/// What is in a snapshot file, told without reading its frames.
struct SnapshotSummary {
  std::vector<std::int64_t> steps;
  std::vector<std::int64_t> contact_offsets;  ///< empty: no contacts
  std::uint64_t most_particles = 0;
  ColumnSet particles_given = 0;
  ColumnSet contacts_given = 0;
};
SnapshotSummary summarise_snapshots(const Hdf5File& file, const std::string& name);

/// Reads one frame at a time, only columns that are needed. Checks numbers as the text readers do; in
/// messages the line is the row within the frame. Throws: no or damaged HDF5, missing columns, time steps
/// that do not ascend, numbers that are none.
class SnapshotReader : public FrameFormat {
 public:
  SnapshotReader(std::vector<std::string> files, ColumnWishes wishes);
  ~SnapshotReader() override;

  bool next(std::int64_t& step) override;
  UnpackFrame take(bool closely = false) override;
  std::int64_t bytes_read() const override { return bytes_; }

 private:
  struct Open;
  struct Packed;
  bool open_next();
  static bool are_of_two_systems(const Open& before, const Open& after);
  std::string place() const;

  std::vector<std::string> files_;
  ColumnWishes wishes_;
  std::unique_ptr<Open> open_;
  std::size_t opened_ = 0;
  std::uint64_t frame_ = 0;
  std::int64_t last_step_ = -1;
  std::int64_t bytes_ = 0;
};

}  // namespace mikromakro
