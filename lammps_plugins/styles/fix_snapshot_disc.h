// SPDX-License-Identifier: GPL-2.0-or-later
// fix ID group snapshot/disc N file NAME.h5 [append yes|no] [start yes|no] [height H]
//
// In every step that is a multiple of N the discs of the group, their contacts (columns of contact_rows.h)
// and the numbers of the fixes with walls go as a frame into one HDF5 file
// (postproc/io/snapshot/snapshot_layout.h), which `mikromakro` reads in place of dumps, while the run goes on
// too. `start yes`: also in the step in which the first run starts. The thickness H (m), effects and material
// constants are written down once.
//
// A new file appears with its first frame and replaces an old one, unless `append yes` continues that: it has
// to be of the same system, and its frames after the present step are dropped. The frames that were complete
// outlive a kill of any rank at any moment (postproc/io/snapshot/snapshot_log.h).
//
// All ranks give their discs and contacts to the first one, which writes alone: of HDF5's ways to write, only
// that of a single writer keeps a file readable through a kill, and HDF5 1.10 refuses it with MPI-IO.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "agreement.h"
#include "contact_rows.h"
#include "dialect.h"
#include "io/snapshot/snapshot_log.h"
#include "output_names.h"

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
  LAMMPS_NS::bigint last_step_ = -1;  // of a frame of this fix
};

}  // namespace mikromakro::styles
