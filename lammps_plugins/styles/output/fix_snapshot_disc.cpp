// SPDX-License-Identifier: GPL-2.0-or-later
#include "output/fix_snapshot_disc.h"

#include <limits>

#include "comm.h"
#include "engine/arguments.h"
#include "engine/engine_access.h"
#include "engine/engine_lists.h"
#include "engine/first_rank.h"
#include "group.h"
#include "io/files/output_file.h"
#include "law/disc_law.h"
#include "mikromakro_version.h"
#include "modify.h"
#include "output/frame_gathering.h"
#include "output/run_record.h"
#include "update.h"

namespace mikromakro::styles {

namespace {

bool yes_or_no(Arguments& arguments, const std::string& keyword) {
  const std::string value = arguments.word(keyword);
  if (value != "yes" && value != "no") arguments.fail(keyword + ": expected yes or no, got '" + value + "'");
  return value == "yes";
}

}  // namespace

FixSnapshotDisc::FixSnapshotDisc(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : FixOfEngine(engine, narg, arg) {
  Arguments arguments(*engine, style, narg, arg, 3);
  nevery = static_cast<int>(arguments.integer("N", 1, std::numeric_limits<int>::max()));
  while (arguments.more()) {
    if (arguments.take_once("file")) {
      file_ = arguments.word("file");
    } else if (arguments.take_once("append")) {
      append_ = yes_or_no(arguments, "append");
    } else if (arguments.take_once("start")) {
      at_start_ = yes_or_no(arguments, "start");
    } else if (arguments.take_once("height")) {
      height_ = arguments.positive("height");
    } else {
      arguments.unexpected("file, append, start or height");
    }
  }
  if (file_.empty()) arguments.fail("expected 'file NAME.h5'");
  if (file_.find('*') != std::string::npos)
    arguments.fail("file: expected a name without *, since all frames go into one file, got '" + file_ + "'");
  // Fail before a long run starts.
  on_first_rank(*lmp, style, [this] { check_snapshot_name(file_); });
}

int FixSnapshotDisc::setmask() {
  return LAMMPS_NS::FixConst::END_OF_STEP;
}

void FixSnapshotDisc::init() {
  if (!active_disc_law(*lmp))
    stop(*lmp, style, std::string("needs '") + disc_pair_style + "' before the run");
  require_orthogonal_box(*lmp, style);
  check_outputs(*lmp, *this);
}

void FixSnapshotDisc::setup(int /*vflag*/) {
  warn_of_discs_outside(*lmp, *this);
  warn_of_height(*lmp, *this, height_);
  const bool first_run = !begun_;
  const bool due = update->ntimestep % nevery == 0 || (first_run && at_start_);
  const SnapshotParameters record = run_record(*lmp, group->names[igroup], height_);
  if (!first_run && !(record == record_))
    stop(*lmp, style,
         "effects or material constants have changed since the first run; expected another fix with another "
         "file, got '" +
             file_ + "'");
  warn_of_no_frame(due);
  if (!first_run && (!due || update->ntimestep == last_step_)) return;
  record_ = record;
  check_order();
  const RawFrame frame = gather_frame(*lmp, groupbit, style);
  if (first_run) begin(frame);
  if (!due) return;
  on_first_rank(*lmp, style, [&] { log_->add(frame); });
  last_step_ = update->ntimestep;
}

/// Fixes are set up in script order, and the first frame needs the wall forces.
void FixSnapshotDisc::check_order() const {
  bool behind = false;
  for (const Fix* fix : fixes(*modify)) {
    if (behind && dynamic_cast<const WallContactSource*>(fix))
      stop(*lmp, style,
           std::string("its first frame needs the forces of fix ") + fix->id + " (" + fix->style +
               "), which is defined after it; expected fix " + id +
               " after the fixes with walls ('unfix' it and define it again, with 'append yes' to continue "
               "its file)");
    behind = behind || fix == this;
  }
}

void FixSnapshotDisc::warn_of_no_frame(bool due_now) {
  const auto run = update->laststep - update->ntimestep;
  const bool later = update->laststep / nevery > update->ntimestep / nevery;
  if (begun_ || due_now || later || run == 0) return;
  warn(*lmp, std::string("fix ") + id + " (" + style +
                 "): no frame in this run: N = " + std::to_string(nevery) + " is not reached by step " +
                 std::to_string(update->laststep) + "; expected a smaller N, or 'start yes'");
}

void FixSnapshotDisc::begin(const RawFrame& frame) {
  begun_ = true;
  std::int64_t dropped = 0;
  on_first_rank(*lmp, style, [&] {
    log_ = std::make_unique<SnapshotLog>(file_, "mikromakro " MIKROMAKRO_VERSION, record_);
    if (append_) dropped = log_->resume(frame);
  });
  if (dropped > 0)
    print_line(*lmp, std::string(style) + ": dropped " + std::to_string(dropped) + " frames after step " +
                         std::to_string(frame.step) + " from " + file_);
}

void FixSnapshotDisc::end_of_step() {
  const RawFrame frame = gather_frame(*lmp, groupbit, style);
  on_first_rank(*lmp, style, [&] { log_->add(frame); });
  last_step_ = update->ntimestep;
}

}  // namespace mikromakro::styles
