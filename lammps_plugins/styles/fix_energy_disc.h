// SPDX-License-Identifier: GPL-2.0-or-later
// fix ID group energy/disc
//
// The energy of discs and what contacts turn into heat, from the contact rows of every step (contact_rows.h):
// a run pays for it only where a script has this fix. Both discs of a contact have to be in the group; walls
// count. Define it behind fixes with walls. Heat counts from the first run with this fix on.
//
// Scalar: the sum of the vector, which is what walls, gravity and other fixes have put in. Vector (J):
//   1  kinetic, of translation and spin      2  elastic, of overlaps: k_n overlap^2/2 (Hertz: 2/5 f overlap)
//   3  elastic, of tangential springs        4  heat of normal dashpots
//   5  heat of tangential forces: sliding, dashpots, springs of contacts that open
// Heat is the sum over steps of force times velocity of the same instant, as velocity Verlet changes the
// energy.
//
// The account of a scene: its change is the work of the walls (scalar of their fixes) and what gravity gives
// (the scalar of its stock fix falls by that), less what the bottom takes (scalar of fix bottom/friction).
#pragma once

#include <array>
#include <vector>

#include "contact_rows.h"
#include "dialect.h"
#include "physics/contact_law.h"

namespace mikromakro::styles {

class FixEnergyDisc : public FixOfEngine, public ContactObserver {
 public:
  FixEnergyDisc(LAMMPS_NS::LAMMPS* engine, int narg, char** arg);
  int setmask() override;
  void init() override;
  void setup(int vflag) override;
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int i) override;
  void write_restart(FILE* fp) override;
  void restart(char* buffer) override;

  bool wants_contacts_at(LAMMPS_NS::bigint /*step*/) const override { return true; }

 private:
  // Of the contacts of this rank.
  struct Contacts {
    double normal_energy = 0, spring_energy = 0, dashpot_power = 0, tangential_power = 0;
  };

  struct Partner {
    int type;
    double reduced_radius;  // m
  };

  Contacts evaluate();
  template <physics::Normal normal>
  Contacts sum_of_rows() const;
  void find_walls();
  Partner partner_of(const ContactRow& row, double radius) const;
  double kinetic_energy() const;
  void update_values();
  std::array<double, 5> tallies() const;
  void go_on_with(const std::array<double, 5>& tallies);

  std::vector<WallKind> walls_;
  std::vector<ContactRow> rows_;
  Contacts now_;
  bool begun_ = false;
  double dashpot_heat_ = 0, tangential_work_ = 0;  // of this rank, since the first set-up (J)
  double first_spring_energy_ = 0;                 // of this rank (J)
  std::array<double, 5> values_{};
  LAMMPS_NS::bigint step_of_values_ = -1;
};

}  // namespace mikromakro::styles
