// SPDX-License-Identifier: GPL-2.0-or-later
// fix ID group snapshot/disc N file NAME.h5 [append yes|no] [start yes|no] [height H]
//
// In every step that is a multiple of N, the discs of the group, their contacts (columns of contact_rows.h)
// and the values of the fixes with walls are written as a frame to one HDF5 file
// (postproc/io/snapshot/snapshot_layout.h). `mikromakro` reads it in place of dumps, even during the run.
// `start yes`: also write the step in which the first run starts. The thickness H (m), effects and material
// constants are written once.
//
// A new file appears with its first frame and replaces an old one, unless `append yes` continues the old one:
// it must be of the same system, and its frames after the present step are dropped. Complete frames survive a
// kill of any rank at any moment (postproc/io/snapshot/snapshot_log.h).
//
// All ranks send their discs and contacts to the first one, which writes alone: only HDF5's single-writer
// mode keeps a file readable after a kill, and HDF5 1.10 does not allow it with MPI-IO.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "dialect.h"
#include "io/snapshot/snapshot_log.h"
#include "law/agreement.h"
#include "law/contact_rows.h"
#include "law/contact_schedule.h"
#include "output/output_names.h"

namespace mikromakro::styles {

class FixSnapshotDisc : public FixOfEngine, public ContactObserver, public FileWriter, public KnowsHeight {
 public:
  FixSnapshotDisc(LAMMPS_NS::LAMMPS* engine, int narg, char** arg);

  bool wants_contacts_at(LAMMPS_NS::bigint step) const override { return step % nevery == 0; }

  double given_height() const override { return height_; }

  std::vector<std::string> output_names() const override { return {file_}; }

  int setmask() override;
  void init() override;
  void setup(int vflag) override;
  void end_of_step() override;

 private:
  void begin(const RawFrame& frame);
  void warn_of_no_frame(bool due_now);
  void check_order() const;

  std::string file_;
  bool append_ = false;
  bool at_start_ = false;
  double height_ = 0;  // m; 0: not given
  SnapshotParameters record_;
  std::unique_ptr<SnapshotLog> log_;  // on the first rank, from the first run on
  bool begun_ = false;
  LAMMPS_NS::bigint last_step_ = -1;  // step of this fix's last frame
};

}  // namespace mikromakro::styles
