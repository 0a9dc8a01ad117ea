// SPDX-License-Identifier: GPL-2.0-or-later
// fix biaxial/2d: changes of the wall control, checks, and restart.
#include <mpi.h>

#include "atom.h"
#include "comm.h"
#include "engine/engine_access.h"
#include "engine/first_rank.h"
#include "engine/restart_state.h"
#include "error.h"
#include "law/disc_law.h"
#include "physics/contact/contact_duration.h"
#include "placement/disc_insertion.h"
#include "update.h"
#include "walls/biaxial/fix_biaxial_2d.h"

namespace mikromakro::styles {

using Kind = WallControl::Kind;

namespace {

// Restart data in addition to the springs: walls, references and clock.
template <class Wall>
struct SavedState {
  std::array<Wall, 4> box;
  std::array<double, 2> reference_lengths;
  double elapsed;
  double step_of_clock;
  double dt;
  double step_of_file;
};

}  // namespace

void FixBiaxial2d::begin(int side, const WallControl& control) {
  Wall& wall = box_[side];
  wall.control = control;
  wall.start = wall.motion.position;
  wall.start_time = clock_.time_at(update->ntimestep);
  wall.motion.acceleration = 0.0;
  wall.continues = false;
  if (control.kind != Kind::stress) wall.motion.velocity = control.kind == Kind::rate ? control.target : 0.0;
  wall.contact_velocity = wall.motion.velocity;
}

void FixBiaxial2d::reset_references() {
  reference_lengths_ = {length(0), length(1)};
  for (Wall& wall : box_) wall.work = 0.0;
}

int FixBiaxial2d::modify_param(int narg, char** arg) {
  Arguments arguments(*lmp, std::string("fix_modify ") + style, narg, arg);
  const BiaxialChange change = parse_biaxial_change(arguments);
  notice_new_count();
  follow_time_step(update->ntimestep);
  for (int side = 0; side < 4; ++side) {
    if (change.controls[side]) begin(side, *change.controls[side]);
  }
  if (change.reset) reset_references();
  return narg;
}

// All ranks know all walls and reach the same result.
void FixBiaxial2d::check_rectangle() const {
  for (int axis = 0; axis < 2; ++axis) {
    if (length(axis) > 0) continue;
    stop(*lmp, style,
         "expected the " + biaxial_sides[2 * axis + 1] + " wall beyond the " + biaxial_sides[2 * axis] +
             " wall, got them at " + text_of(box_[2 * axis + 1].motion.position) + " and " +
             text_of(box_[2 * axis].motion.position));
  }
  check_inside_box(
      *lmp, style, "the walls",
      {box_[0].motion.position, box_[1].motion.position, box_[2].motion.position, box_[3].motion.position});
}

FixBiaxial2d::WallContacts FixBiaxial2d::wall_contacts() const {
  const DiscLaw& law = *active_disc_law(*lmp);
  const auto normal = law.effects().normal;
  const auto walls = smooth_walls();
  const auto kinds = walls_.kinds();
  WallContacts sums{};
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    const auto disc = walls_.disc(i);
    for (int side = 0; side < 4; ++side) {
      const double overlap = disc.radius - physics::nearest_point(walls[side], disc.position).distance;
      const auto& p = law.parameters(atom->type[i], kinds[side].type);
      // A wall that its dashpots shake has lost some of its contacts.
      constexpr double gap = 0.01;
      if (law.effects().normal_dashpot && overlap > -gap * disc.radius)
        sums.damping[side] += p.normal_damping;
      if (overlap <= 0) continue;
      sums.stiffness[side] += physics::with_law(
          normal, [&](auto law) { return law.stiffness(p.normal_stiffness, atom->radius[i], overlap); });
    }
  }
  for (auto* values : {&sums.stiffness, &sums.damping})
    MPI_Allreduce(MPI_IN_PLACE, values->data(), 4, MPI_DOUBLE, MPI_SUM, world);
  return sums;
}

void FixBiaxial2d::check_time_step() const {
  const auto [stiffness, damping] = wall_contacts();
  const bool predicted = active_disc_law(*lmp)->velocities_predicted();
  for (int side = 0; side < 4; ++side) {
    const WallControl& control = box_[side].control;
    if (control.kind != Kind::stress) continue;
    check_dashpots(side, physics::stable_dashpot_step(damping[side] / control.mass, predicted));
    if (stiffness[side] == 0) continue;
    const double half_period = physics::servo_half_period(control.mass, stiffness[side]);
    const double steps = half_period / update->dt;
    const std::string what = biaxial_sides[side] + ": half a period of the wall on its contacts (" +
                             text_of(half_period) + " s) has " + text_of(steps) +
                             " time steps; expected 50 or more, with a larger mass or a shorter step";
    if (steps < physics::least_steps_per_contact) stop(*lmp, style, what);
    if (steps < physics::steps_per_contact && comm->me == 0)
      error->warning(FLERR, (style + (": " + what)).c_str());
  }
}

// Of all discs at the wall, touching or nearly.
void FixBiaxial2d::check_dashpots(int side, double stable) const {
  constexpr double near = 0.75;
  const std::string what = std::string(biaxial_sides[side]) + ": time step " + text_of(update->dt) +
                           " s; expected at most " + text_of(near * stable) +
                           " s for the dashpots of its contacts, which are unstable above " +
                           text_of(stable) + " s, or a larger mass";
  if (update->dt > near * stable && comm->me == 0) error->warning(FLERR, (style + (": " + what)).c_str());
}

// The command `timestep` does not notify fixes.
void FixBiaxial2d::follow_time_step(LAMMPS_NS::bigint step) {
  if (update->dt != clock_.dt()) clock_.change_step_length(step, update->dt);
}

void FixBiaxial2d::reset_dt() {
  follow_time_step(update->ntimestep);
}

void FixBiaxial2d::renumber_steps(LAMMPS_NS::bigint shift) {
  clock_.shift_steps(shift);
}

void FixBiaxial2d::write_restart(FILE* fp) {
  if (comm->me != 0) return;
  const SavedState<Wall> state{box_,
                               reference_lengths_,
                               clock_.elapsed(),
                               static_cast<double>(clock_.step()),
                               clock_.dt(),
                               static_cast<double>(update->ntimestep)};
  write_state(fp, state);
}

void FixBiaxial2d::restart(char* buf) {
  const auto state = read_state<SavedState<Wall>>(*lmp, *this, buf);
  clock_ = physics::StepClock(state.elapsed, static_cast<LAMMPS_NS::bigint>(state.step_of_clock), state.dt);
  // Steps may have been renumbered since read_restart.
  clock_.shift_steps(update->ntimestep - static_cast<LAMMPS_NS::bigint>(state.step_of_file));
  reference_lengths_ = state.reference_lengths;
  for (int side = 0; side < 4; ++side) {
    const WallControl wanted = box_[side].control;
    box_[side] = state.box[side];
    if (wanted == box_[side].control) continue;
    print_line(*lmp, "WARNING: fix " + std::string(id) + " (" + style + "): " + biaxial_sides[side] +
                         ": not the control in the restart file: the new control starts at the present "
                         "position of the wall (after fix_modify, give the fix the latest controls)");
    begin(side, wanted);
  }
}

}  // namespace mikromakro::styles
