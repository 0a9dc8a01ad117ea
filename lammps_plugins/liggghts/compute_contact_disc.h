// compute contact/disc: one row for each contact, with the forces that were applied in the step.
#pragma once

#include <array>
#include <vector>

#include "compute.h"

namespace mikromakro::liggghts {

struct AppliedContact;

/// compute ID group contact/disc
///
/// Local rows of 16 columns: id1 id2 x1 y1 x2 y2 nx ny overlap fx fy fn ft xi vn vt (signs in
/// physics/contact_law.h; the force acts on 1; x2 y2 are those of the periodic image that touches). Both
/// discs have to be in the group. Nothing is evaluated again: the rows are what the pair style applied.
class ComputeContactDisc : public LAMMPS_NS::Compute {
 public:
  ComputeContactDisc(LAMMPS_NS::LAMMPS* engine, int& iarg, int narg, char** arg);
  void init() override;
  void compute_local() override;
  double memory_usage() override;

 private:
  static constexpr int columns = 16;
  using Row = std::array<double, columns>;
  Row row_of(const AppliedContact& contact) const;

  std::vector<Row> rows_;
  std::vector<double*> row_pointers_;  // the engine wants an array of rows
};

}  // namespace mikromakro::liggghts
