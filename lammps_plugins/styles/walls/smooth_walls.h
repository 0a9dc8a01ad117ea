// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts of discs with the smooth walls of a fix: nearby discs, springs and forces.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "law/contact_rows.h"
#include "law/contact_schedule.h"
#include "physics/contact/contact_law.h"
#include "physics/walls/smooth_wall.h"
#include "pointers.h"
#include "walls/wall_springs.h"

namespace mikromakro::styles {

class AddedLoads;
class DiscLaw;

/// Up to four walls act on the discs of a group, except those of excluded groups, under the active disc law.
/// The owner moves the walls and forwards the engine's per-atom callbacks. Discs further from a wall than the
/// skin of the neighbour list cost nothing; springs are stored only for touching discs.
class SmoothWalls : protected LAMMPS_NS::Pointers {
 public:
  SmoothWalls(LAMMPS_NS::LAMMPS& engine, std::string style) : Pointers(&engine), style_(std::move(style)) {}

  /// Adds a wall: its id in contact rows (contact_rows.h), a name for messages, and the atom type that
  /// supplies its material constants. Returns its index.
  int add(int id, const std::string& name, int type);
  /// Changes the id in contact rows; springs in restart files keep the id of add().
  void show_as(int number, int id) { kinds_[number].id = id; }
  bool any() const { return !kinds_.empty(); }
  /// The discs that may touch the walls: those of a group, without those of the excluded groups.
  void act_on(int group_bit, int excluded_bits);
  const std::vector<WallKind>& kinds() const { return kinds_; }

  /// Stops the run if a wall overlaps a disc by half its radius or more. For new walls.
  void check_cuts(const std::vector<physics::SmoothWall>& walls) const;
  /// Call at the start of a run. Stops it if no disc law is active or the group is empty. A wall that cuts
  /// through a disc is an error in the first run and a warning in later ones, when walls may have been
  /// pressed into discs.
  void init(const std::vector<physics::SmoothWall>& walls);

  /// Adds this step's wall forces to the discs; one wall for each add(), in that order.
  void apply(const std::vector<physics::SmoothWall>& walls);
  /// Loads on the walls from the discs of this rank, at the last apply().
  const std::vector<physics::WallLoad>& loads() const { return loads_; }
  bool append_contacts(int group_bit, std::vector<ContactRow>& rows) const;
  std::vector<WallTouch> touches() const;
  /// A disc as used for contacts in this step: from its row once contacts have been evaluated.
  physics::MovingDisc disc(int i) const;
  /// True if velocities are predicted for the time of the positions.
  bool velocities_predicted() const { return step_.predicted; }

  /// For the engine's callbacks.
  WallSprings& springs() { return springs_; }
  const WallSprings& springs() const { return springs_; }

 private:
  using Loop = void (SmoothWalls::*)(int number, const physics::SmoothWall& wall, AddedLoads& on_discs);
  struct Recorded {
    int disc;
    ContactRow row;
  };

  bool touches_walls(int i) const;
  void find_law();
  void warn_of_cuts(const std::vector<physics::SmoothWall>& walls) const;
  /// Describes the deepest cut of half a radius or more; "" if none.
  std::string deepest_cut(const std::vector<physics::SmoothWall>& walls) const;
  void check_group() const;
  void find_near(const std::vector<physics::SmoothWall>& walls);
  template <physics::Effects effects>
  void touch(int number, const physics::SmoothWall& wall, AddedLoads& on_discs);
  void record(int i, int number, const physics::WallPoint& at, const physics::ContactState& state,
              const physics::ContactForce& force);
  template <int... numbers>
  void choose_among(const physics::Effects& wanted, std::integer_sequence<int, numbers...> all);

  std::string style_;
  int group_bit_ = 1;
  int excluded_bits_ = 0;
  bool has_run_ = false;
  std::vector<WallKind> kinds_;
  std::vector<std::string> names_;
  std::vector<std::vector<physics::ContactParameters>> parameters_;  // per wall and atom type
  DiscLaw* law_ = nullptr;
  Loop loop_ = nullptr;
  physics::StepOfSlip step_{0.0, false};
  // Discs within the skin of each wall, and the walls when these were found.
  std::vector<std::vector<int>> near_;
  std::vector<physics::SmoothWall> walls_then_, walls_now_;
  WallSprings springs_;  // of touching discs; unused ones are dropped in find_near()
  std::vector<physics::WallLoad> loads_;
  ContactSchedule schedule_;
  LAMMPS_NS::bigint recorded_step_ = -1;
  bool recording_ = false;
  std::vector<Recorded> recorded_;
};

}  // namespace mikromakro::styles
