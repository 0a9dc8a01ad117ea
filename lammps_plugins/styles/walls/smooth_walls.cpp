// SPDX-License-Identifier: GPL-2.0-or-later
#include "walls/smooth_walls.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "atom.h"
#include "engine/arguments.h"
#include "engine/engine_access.h"
#include "engine/first_rank.h"
#include "law/disc_law.h"
#include "law/fixes_in_step.h"
#include "neighbor.h"
#include "update.h"

namespace mikromakro::styles {

using physics::Effects;
using physics::Tangential;

int SmoothWalls::add(int id, const std::string& name, int type) {
  kinds_.push_back({id, type, 0.0});
  springs_.add_wall(id);
  names_.push_back(name);
  near_.emplace_back();
  loads_.emplace_back();
  return static_cast<int>(kinds_.size()) - 1;
}

void SmoothWalls::act_on(int group_bit, int excluded_bits) {
  group_bit_ = group_bit;
  excluded_bits_ = excluded_bits;
}

template <int... numbers>
void SmoothWalls::choose_among(const Effects& wanted, std::integer_sequence<int, numbers...> /*all*/) {
  const auto choose = [&]<Effects effects>() {
    if (wanted == effects) loop_ = &SmoothWalls::touch<effects>;
  };
  (choose.template operator()<physics::effects_of_combination(numbers)>(), ...);
}

void SmoothWalls::find_law() {
  law_ = active_disc_law(*lmp);
  if (!law_) stop(*lmp, style_, std::string("smooth walls need '") + disc_pair_style + "' before the run");
  choose_among(law_->effects(), std::make_integer_sequence<int, physics::effect_combinations>{});
}

void SmoothWalls::init(const std::vector<physics::SmoothWall>& walls) {
  find_law();
  check_group();
  if (has_run_)
    warn_of_cuts(walls);
  else
    check_cuts(walls);
  has_run_ = true;
  parameters_.clear();
  for (const WallKind& kind : kinds_) {
    auto& of_wall = parameters_.emplace_back();
    for (int type = 1; type <= atom->ntypes; ++type) of_wall.push_back(law_->parameters(type, kind.type));
  }
  step_.predicted = law_->velocities_predicted();
  schedule_.look_up(*lmp);
  recorded_step_ = -1;
  walls_then_.clear();
  walls_now_ = walls;
}

bool SmoothWalls::touches_walls(int i) const {
  return (atom->mask[i] & group_bit_) && !(atom->mask[i] & excluded_bits_);
}

void SmoothWalls::check_group() const {
  long count = 0;
  for (int i = 0; i < atom->nlocal; ++i) count += touches_walls(i);
  MPI_Allreduce(MPI_IN_PLACE, &count, 1, MPI_LONG, MPI_SUM, world);
  // Discs may be inserted later.
  if (count == 0 && atom->natoms > 0)
    stop(*lmp, style_, "expected a group with discs that can touch the walls, got an empty one");
}

void SmoothWalls::check_cuts(const std::vector<physics::SmoothWall>& walls) const {
  if (const std::string cut = deepest_cut(walls); !cut.empty()) stop(*lmp, style_, cut);
}

void SmoothWalls::warn_of_cuts(const std::vector<physics::SmoothWall>& walls) const {
  if (const std::string cut = deepest_cut(walls); !cut.empty()) warn(*lmp, style_ + ": " + cut);
}

std::string SmoothWalls::deepest_cut(const std::vector<physics::SmoothWall>& walls) const {
  constexpr double cut = 0.5;
  struct {
    double depth;
    int id;
  } worst{0.0, 0};
  int wall_of_worst = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!touches_walls(i)) continue;
    for (std::size_t k = 0; k < walls.size(); ++k) {
      const auto at = physics::nearest_point(walls[k], {atom->x[i][0], atom->x[i][1]});
      const double depth = 1 - at.distance / atom->radius[i];
      if (depth > worst.depth) worst = {depth, atom->tag[i]}, wall_of_worst = static_cast<int>(k);
    }
  }
  const int mine = worst.id;
  MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_DOUBLE_INT, MPI_MAXLOC, world);
  if (worst.depth < cut) return "";
  if (mine != worst.id) wall_of_worst = 0;  // only the owner of the disc knows the wall
  MPI_Allreduce(MPI_IN_PLACE, &wall_of_worst, 1, MPI_INT, MPI_MAX, world);
  return names_[wall_of_worst] + ": expected a wall that cuts through no disc, got an overlap of " +
         text_of(worst.depth) + " radii with disc " + std::to_string(worst.id) +
         (names_[wall_of_worst] == "plane" ? " (the normal NX NY points from the wall to the discs)" : "");
}

/// Finds the discs that may touch a wall before the next search: until the next neighbour list build, disc
/// and wall each move by at most half the skin.
void SmoothWalls::find_near(const std::vector<physics::SmoothWall>& walls) {
  springs_.drop_unused(atom->nlocal, [this](int i) { return touches_walls(i); });
  for (auto& of_wall : near_) of_wall.clear();
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!touches_walls(i)) continue;
    const auto position = disc(i).position;
    const double cutoff = atom->radius[i] + neighbor->skin;
    for (std::size_t k = 0; k < walls.size(); ++k) {
      if (physics::nearest_point(walls[k], position).distance < cutoff) near_[k].push_back(i);
    }
  }
  walls_then_ = walls;
}

physics::MovingDisc SmoothWalls::disc(int i) const {
  if (const auto* row = law_ ? law_->evaluated_row(i) : nullptr) {
    // Without friction, rows hold no spin.
    const double spin = law_->effects().tangential == Tangential::none ? atom->omega[i][2] : row->spin();
    return {{row->x(), row->y()}, row->velocity(), spin, row->radius()};
  }
  const double *x = atom->x[i], *v = atom->v[i];
  return {{x[0], x[1]}, {v[0], v[1]}, atom->omega[i][2], atom->radius[i]};
}

void SmoothWalls::apply(const std::vector<physics::SmoothWall>& walls) {
  AddedLoads on_discs(law_, *atom);
  bool search = neighbor->ago == 0 || walls_then_.empty();
  for (std::size_t k = 0; !search && k < walls.size(); ++k)
    search = physics::displacement(walls_then_[k], walls[k]) > neighbor->skin / 2;
  if (search) find_near(walls);
  walls_now_ = walls;

  step_.dt = update->setupflag ? 0.0 : update->dt;
  recording_ = schedule_.due(*update, *output);
  recorded_.clear();
  for (std::size_t k = 0; k < walls.size(); ++k) {
    loads_[k] = {};
    kinds_[k].curvature = physics::curvature(walls[k]);
    (this->*loop_)(static_cast<int>(k), walls[k], on_discs);
  }
  if (recording_) recorded_step_ = update->ntimestep;
}

template <Effects effects>
void SmoothWalls::touch(int number, const physics::SmoothWall& wall, AddedLoads& on_discs) {
  for (const int i : near_[number]) {
    const auto disc = this->disc(i);
    const auto at = physics::nearest_point(wall, disc.position);
    const bool contact = at.distance < disc.radius;
    physics::WallSpring none, *spring = &none;
    if constexpr (effects.spring()) {
      spring = contact ? springs_.find_or_add(i, number) : springs_.find(i, number);
      if (!contact && spring) *spring = {};
    }
    if (!contact) continue;
    auto state = physics::state_at_wall(wall, at, disc, spring->xi);
    if constexpr (physics::NormalLaw<effects.normal>::depends_on_radius)
      state.reduced_radius = physics::reduced_radius_at(physics::curvature(wall), disc.radius);
    const auto& parameters = parameters_[number][atom->type[i] - 1];
    const auto force = physics::wall_contact_force<effects>(parameters, state, step_, *spring);
    const auto& n = at.normal;
    const physics::PlaneVector on_disc{-force.f_n * n.x - force.f_t * n.y,
                                       -force.f_n * n.y + force.f_t * n.x};
    on_discs.add(i, on_disc, at.distance * force.f_t);
    loads_[number].add(wall, at, force.f_n, on_disc);
    if (recording_) record(i, number, at, state, force);
  }
}

void SmoothWalls::record(int i, int number, const physics::WallPoint& at, const physics::ContactState& state,
                         const physics::ContactForce& force) {
  const auto& n = at.normal;
  recorded_.push_back(
      {i,
       {static_cast<double>(atom->tag[i]), static_cast<double>(kinds_[number].id), atom->x[i][0],
        atom->x[i][1], at.place.x, at.place.y, n.x, n.y, state.overlap, -force.f_n * n.x - force.f_t * n.y,
        -force.f_n * n.y + force.f_t * n.x, force.f_n, force.f_t, force.xi, state.v_n, state.v_t}});
}

namespace {

/// A changing box may have moved the disc of a wall contact since, by much less than a radius.
void move_to(const double* place, ContactRow& row) {
  const double x = place[0] - row[2], y = place[1] - row[3];
  if (x == 0 && y == 0) return;
  const double n_x = row[6], n_y = row[7], inwards = x * n_x + y * n_y;
  row[2] = place[0];
  row[3] = place[1];
  row[4] += x - inwards * n_x;
  row[5] += y - inwards * n_y;
  row[8] += inwards;
}

}  // namespace

std::vector<WallTouch> SmoothWalls::touches() const {
  std::vector<WallTouch> found;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!touches_walls(i)) continue;
    for (std::size_t k = 0; k < walls_now_.size(); ++k) {
      const auto at = physics::nearest_point(walls_now_[k], {atom->x[i][0], atom->x[i][1]});
      if (at.distance < atom->radius[i])
        found.push_back({i, at.normal.x, at.normal.y, at.distance, kinds_[k].type});
    }
  }
  return found;
}

bool SmoothWalls::append_contacts(int group_bit, std::vector<ContactRow>& rows) const {
  if (!any()) return true;
  if (recorded_step_ != update->ntimestep) return false;
  for (const Recorded& contact : recorded_) {
    if (!(atom->mask[contact.disc] & group_bit)) continue;
    rows.push_back(contact.row);
    move_to(atom->x[contact.disc], rows.back());
  }
  return true;
}

}  // namespace mikromakro::styles
