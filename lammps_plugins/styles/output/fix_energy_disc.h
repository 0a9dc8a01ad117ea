// SPDX-License-Identifier: GPL-2.0-or-later
// fix ID group energy/disc
//
// Energy of the discs and dissipation in contacts, from the contact rows of every step (contact_rows.h);
// scripts without this fix pay nothing. Both discs of a contact must be in the group; walls count. Define it
// after fixes with walls. Dissipation counts from the first run with this fix.
//
// Scalar: the sum of the vector: the total energy input by walls, gravity and other fixes. Vector (J):
//   1  kinetic, of translation and spin      2  elastic, of overlaps: k_n overlap^2/2 (Hertz: 2/5 f overlap)
//   3  elastic, of tangential springs        4  dissipated by normal dashpots
//   5  dissipated by tangential forces: sliding, dashpots, springs of contacts that open
// Dissipation is the sum over steps of force times velocity at the same time, consistent with the energy
// change of velocity Verlet.
//
// Energy balance of a scene: the change of the scalar equals the work of the walls (scalar of their fixes)
// plus the work of gravity (by which the scalar of its stock fix falls) minus the energy dissipated by the
// bottom (scalar of fix bottom/friction).
#pragma once

#include <array>
#include <vector>

#include "dialect.h"
#include "law/contact_rows.h"
#include "law/contact_schedule.h"
#include "physics/contact/contact_law.h"

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
  // Sums over the contacts of this rank.
  struct Contacts {
    double normal_energy = 0, spring_energy = 0, dashpot_power = 0, tangential_power = 0;
  };

  struct Partner {
    int type;
    double reduced_radius;  // m
  };

  Contacts evaluate();
  template <class NormalLaw>
  Contacts sum_of_rows() const;
  void find_walls();
  Partner partner_of(const ContactRow& row, double radius) const;
  double kinetic_energy() const;
  void update_values();
  std::array<double, 5> tallies() const;
  void set_tallies(const std::array<double, 5>& tallies);

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
