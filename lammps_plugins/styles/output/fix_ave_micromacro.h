// SPDX-License-Identifier: GPL-2.0-or-later
// fix ID group ave/micromacro Nevery Nfreq file NAME [file NAME ...] OPTIONS
//
// The averages of `mikromakro average`, taken in situ: in every step that is a multiple of Nevery the sums
// over the discs of the group and their contacts are accumulated, and in every multiple of Nfreq the table is
// written. NAME ends in .csv, .h5, .vtkhdf or .hdf. A * in NAME becomes the time step: each file then holds
// the mean of its own Nfreq/Nevery frames. Without a *, the file is replaced each time by the mean of all
// frames since the fix was defined. Averages are not kept across restarts.
//
// OPTIONS are the program's averaging options, without the leading dashes:
//
//   rings RMIN RMAX N  edges R0,R1,...  center X Y  sectors M  grid ...  box ...  weight W  branch B
//   height H  bulk_types 1,2  kn K  mu MU  fields NAME,...  histogram BINS  error_blocks N
//
// Discs and contacts are gathered on the first rank, which averages them as the program averages a snapshot:
// the results agree to the last bit. Wall discs must be in the group: contacts with discs outside the group
// do not count.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "dialect.h"
#include "io/tables/csv_writer.h"
#include "law/agreement.h"
#include "law/contact_rows.h"
#include "law/contact_schedule.h"
#include "law/disc_law.h"
#include "model/notes.h"
#include "options/average_options.h"
#include "output/output_names.h"

namespace mikromakro::styles {

class FixAveMicromacro : public FixWithClock, public ContactObserver, public FileWriter, public KnowsHeight {
 public:
  FixAveMicromacro(LAMMPS_NS::LAMMPS* engine, int narg, char** arg);

  bool wants_contacts_at(LAMMPS_NS::bigint step) const override { return step % nevery == 0; }

  double given_height() const override { return options_.volumes.height; }

  std::vector<std::string> output_names() const override { return options_.out; }

  void init() override;
  void setup(int vflag) override;
  void end_of_step() override;

 protected:
  int calls_wanted() const override;
  void renumber_steps(LAMMPS_NS::bigint shift) override;
  void run_ended() override;

 private:
  void parse(std::vector<std::string> words);
  void write();
  bool needs_forces() const;
  void look(const Frame& frame);
  std::vector<std::string> warnings();
  void tell(Preamble& lines);
  void warn_of_change();
  void warn_of_constants() const;
  void warn_of(const std::string& name, const std::string& keyword, double given) const;

  LAMMPS_NS::bigint write_every_ = 0;
  AverageOptions options_;
  std::vector<MaterialConstant> constants_;  // of the first run
  LAMMPS_NS::bigint waiting_ = 0;            // frames not yet in a table
  bool announced_ = false;                   // next frame announced since the last one
  bool windows_ = false;                     // each file holds its own frames only
  std::unique_ptr<const Averager> averager_;
  Averaged averaged_;                          // on the first rank, as are those below
  std::optional<Notes> notes_{std::in_place};  // of the frames of the next table
  bool discs_ = false;                         // some disc was in the volumes in one of them
  std::set<std::string> told_;
};

}  // namespace mikromakro::styles
