// Frames of MercuryDPM, particles and contacts matched by their times.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/file_sequence.h"
#include "io/frame_format.h"
#include "io/mercury_reader.h"
#include "io/text_frames.h"

namespace mikromakro {

/// The files have no time steps: the step is the number of the frame, from 0. Throws: a time that only one of
/// the two has (times are compared in the six digits that the files have at least), wishes for columns that
/// the files do not have, and all that mercury_particles and mercury_contacts throw.
class MercuryFrames : public FrameFormat {
 public:
  /// No contact files: frames without contacts.
  MercuryFrames(const std::vector<std::string>& particle_files, const std::vector<std::string>& contact_files,
                const ColumnWishes& wishes);

  bool next(std::int64_t& step) override;
  UnpackFrame take() override;
  std::int64_t bytes_read() const override;

 private:
  void check_partners(bool some_particles, bool some_contacts);

  ColumnSet contacts_needed_;
  FileSequence<MercuryDataReader> particles_;
  std::optional<FileSequence<MercuryFstatReader>> contacts_;
  MercuryHeader of_particles_;
  MercuryHeader of_contacts_;
  std::int64_t step_ = -1;
};

}  // namespace mikromakro
