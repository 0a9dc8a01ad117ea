// SPDX-License-Identifier: GPL-2.0-or-later
#include "walls/biaxial/fix_biaxial_2d.h"

#include <mpi.h>

#include "atom.h"
#include "domain.h"
#include "engine/engine_access.h"
#include "physics/math/half_cosine.h"
#include "placement/disc_insertion.h"
#include "update.h"

namespace mikromakro::styles {
namespace {

using Kind = WallControl::Kind;

// Left, right, bottom, top: away from the discs along x or y.
constexpr std::array<double, 4> outward = {-1, 1, -1, 1};
constexpr std::array<int, 4> wall_ids = {-1, -2, -3, -4};

}  // namespace

FixBiaxial2d::FixBiaxial2d(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) : FixWithWalls(lmp, narg, arg) {
  scalar_flag = vector_flag = 1;
  size_vector = 27;
  global_freq = 1;
  extscalar = extvector = 0;

  if (domain->xperiodic || domain->yperiodic)
    stop(*lmp, style, "expected a box that is not periodic in x and y, such as 'boundary f f p'");
  Arguments arguments(*lmp, style, narg, arg, 3);
  settings_ = parse_biaxial(*lmp, arguments);
  clock_ = physics::StepClock(0.0, update->ntimestep, update->dt);
  for (int side = 0; side < 4; ++side) {
    walls_.add(wall_ids[side], biaxial_sides[side], settings_.walls[side].type);
    box_[side].motion.position = settings_.walls[side].position;
    begin(side, settings_.walls[side].control);
  }
  walls_.act_on(groupbit, 0);
  reset_references();

  store_springs_with_atoms();
}

int FixBiaxial2d::calls_wanted() const {
  using namespace LAMMPS_NS::FixConst;
  return INITIAL_INTEGRATE | POST_FORCE | FINAL_INTEGRATE | POST_RUN;
}

// Called after the restart state, if any, has been read.
void FixBiaxial2d::once_defined() {
  check_rectangle();
  walls_.check_cuts(smooth_walls());
}

void FixBiaxial2d::init() {
  notice_new_count();
  saved_walls_.warn_of_unclaimed(*lmp);
  follow_time_step(update->ntimestep);
  check_rectangle();
  walls_.init(smooth_walls());
}

void FixBiaxial2d::setup(int) {
  check_time_step();
  walls_.apply(smooth_walls());
  sum_forces();
  for (int side = 0; side < 4; ++side) {
    Wall& wall = box_[side];
    if (wall.continues) continue;
    wall.previous_pressing = wall.pressing;
    if (wall.control.kind == Kind::stress)
      wall.motion.acceleration =
          (force_on(side) - wall.control.damping * wall.motion.velocity) / wall.control.mass;
  }
}

void FixBiaxial2d::initial_integrate(int) {
  follow_time_step(update->ntimestep - 1);
  const double time = clock_.time_at(update->ntimestep);
  for (Wall& wall : box_) {
    wall.previous_position = wall.motion.position;
    move(wall, time);
  }
  check_rectangle();
}

void FixBiaxial2d::move(Wall& wall, double time) const {
  physics::ServoWall& motion = wall.motion;
  switch (wall.control.kind) {
    case Kind::fixed:
      break;
    case Kind::rate:
      motion.position = wall.start + wall.control.target * (time - wall.start_time);
      break;
    case Kind::cosine: {
      const physics::HalfCosine course{wall.start, wall.control.target, wall.control.duration};
      motion.position = course.value(time - wall.start_time);
      motion.velocity = course.rate(time - wall.start_time);
      break;
    }
    case Kind::stress:
      motion = physics::servo_drift(motion, update->dt);
      wall.contact_velocity =
          walls_.velocities_predicted() ? physics::predicted_velocity(motion, update->dt) : motion.velocity;
      return;
  }
  wall.contact_velocity = motion.velocity;
}

void FixBiaxial2d::post_force(int) {
  walls_.apply(smooth_walls());
  sum_forces();
}

void FixBiaxial2d::final_integrate() {
  for (int side = 0; side < 4; ++side) {
    Wall& wall = box_[side];
    if (wall.control.kind == Kind::stress) {
      wall.motion = physics::servo_kick(wall.motion, force_on(side),
                                        {wall.control.mass, wall.control.damping}, update->dt);
    }
    wall.work -= outward[side] * 0.5 * (wall.previous_pressing + wall.pressing) *
                 (wall.motion.position - wall.previous_position);
    wall.previous_pressing = wall.pressing;
    wall.continues = true;
  }
}

// Contacts may have formed during the run.
void FixBiaxial2d::run_ended() {
  check_time_step();
}

// Sums all wall loads over the ranks in a single reduction.
void FixBiaxial2d::sum_forces() {
  std::array<double, 8> sums{};
  for (int side = 0; side < 4; ++side) {
    const physics::WallLoad& load = walls_.loads()[side];
    sums[2 * side] = load.pressing;
    sums[2 * side + 1] = side < 2 ? load.force.y : load.force.x;
  }
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), 8, MPI_DOUBLE, MPI_SUM, world);
  for (int side = 0; side < 4; ++side) {
    box_[side].pressing = sums[2 * side];
    box_[side].along = sums[2 * side + 1];
  }
}

double FixBiaxial2d::length(int axis) const {
  return box_[2 * axis + 1].motion.position - box_[2 * axis].motion.position;
}

double FixBiaxial2d::pressure(int side) const {
  return box_[side].pressing / (length_of_wall(side) * settings_.height);
}

// Outward force along x or y, without damping.
double FixBiaxial2d::force_on(int side) const {
  const Wall& wall = box_[side];
  return outward[side] *
         physics::servo_force(wall.pressing, wall.control.target * settings_.height, length_of_wall(side));
}

std::vector<physics::SmoothWall> FixBiaxial2d::smooth_walls() const {
  std::vector<physics::SmoothWall> walls(4);
  for (int side = 0; side < 4; ++side) {
    const Wall& wall = box_[side];
    const bool vertical = side < 2;
    auto along_axis = [&](double value) {
      return vertical ? physics::PlaneVector{value, 0} : physics::PlaneVector{0, value};
    };
    walls[side].point = along_axis(wall.motion.position);
    walls[side].outward = along_axis(outward[side]);
    walls[side].velocity = along_axis(wall.contact_velocity);
  }
  return walls;
}

double FixBiaxial2d::compute_scalar() {
  double work = 0;
  for (const Wall& wall : box_) work += wall.work;
  return work;
}

double FixBiaxial2d::compute_vector(int i) {
  if (i < 16 || i >= 19) {
    const int j = i < 16 ? i : i - 19;  // in blocks of four walls
    const Wall& wall = box_[j % 4];
    if (i >= 19) return j / 4 == 0 ? wall.work : wall.along;
    const std::array<double, 4> values = {wall.motion.position, wall.motion.velocity, wall.pressing,
                                          pressure(i % 4)};
    return values[i / 4];
  }
  const double horizontal = length(0) / reference_lengths_[0], vertical = length(1) / reference_lengths_[1];
  const std::array<double, 3> strains = {horizontal - 1, vertical - 1, horizontal * vertical - 1};
  return strains[i - 16];
}

}  // namespace mikromakro::styles
