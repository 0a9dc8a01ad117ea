// SPDX-License-Identifier: GPL-2.0-or-later
// The same discs, walls, law and integration as the disc styles, in one loop with no engine around it: what
// this hardware gives. Sorted in space, packed in rows, vectorised, on one core; no groups, no types, no
// output.
#pragma once

#include <vector>

#include "disc_scene.h"
#include "physics/contact/contact_batch.h"
#include "physics/contact/inner_list.h"
#include "physics/motion/ring_motion.h"

namespace mikromakro::bench {

class DiscReference {
 public:
  explicit DiscReference(const DiscScene& scene);

  void run(int steps);

  /// Of the free discs, translation and spin, at the end of the last step [J].
  double kinetic_energy() const;
  std::size_t contacts() const;
  std::size_t pairs() const { return pairs_.size(); }
  int neighbour_lists_built() const { return builds_; }

 private:
  struct WallDisc {
    int disc, ring;
    physics::PlaneVector reference;
  };
  struct Spring {
    double xi = 0, slip_rate = 0;
  };
  struct Cells;

  void add(const test::Disc& disc);
  void move_discs(int kicks);
  void move_walls(double time);
  void evaluate_contacts(double dt);
  void update_pairs();
  void build_pairs();
  void find_near_pairs();
  void put_springs_away();
  void begin_and_end_contacts(int first, int count, double dt);
  bool moved_too_far() const;
  physics::Four force(int i) const;

  DiscScene scene_;
  physics::RingMotion rings_[2];
  long step_ = 0;

  // Of each disc, sorted in space: row, load, velocity and spin of the half step before (of the step itself
  // before the first), half a time step over mass and moment of inertia.
  std::vector<physics::DiscRow> discs_;
  std::vector<physics::DiscLoad> loads_;
  std::vector<physics::Four> half_step_, kick_;
  std::vector<int> free_;
  std::vector<WallDisc> walls_;

  // Since the neighbour list was built.
  std::vector<physics::DiscPair> pairs_;
  std::vector<Spring> springs_;
  std::vector<char> in_contact_;
  std::vector<physics::PlaneVector> built_at_;
  int builds_ = 0;

  // Since the last look at all pairs.
  physics::InnerList near_;
  double near_gap_ = 0, moved_ = 0;
  int steps_of_near_ = 0;

  physics::ContactBatch batch_{};
};

}  // namespace mikromakro::bench
