#include "compute_contact_disc.h"

#include "atom.h"
#include "error.h"
#include "pair_gran_disc.h"
#include "update.h"

namespace mikromakro::liggghts {

using namespace LAMMPS_NS;

ComputeContactDisc::ComputeContactDisc(LAMMPS* engine, int& iarg, int narg, char** arg)
    : Compute(engine, iarg, narg, arg) {
  if (narg != iarg) error->all(FLERR, "compute contact/disc: expected no arguments after the style");
  local_flag = 1;
  size_local_cols = columns;
  size_local_rows = 0;
  array_local = nullptr;
}

void ComputeContactDisc::init() {
  if (!active_disc_law(*lmp)) {
    error->all(FLERR, "compute contact/disc: needs 'pair_style gran model disc/linear ...' before the run");
  }
}

void ComputeContactDisc::compute_local() {
  invoked_local = update->ntimestep;
  const PairGranDisc* law = active_disc_law(*lmp);
  const auto* contacts = law ? law->applied_contacts() : nullptr;
  if (!contacts) {
    error->all(FLERR,
               "compute contact/disc: the forces of this step were not recorded; it gives rows to dumps in "
               "steps that "
               "the engine has scheduled for output");
    return;
  }
  rows_.clear();
  for (const auto& c : *contacts) {
    if (!(atom->mask[c.i] & groupbit) || !(atom->mask[c.j] & groupbit)) continue;
    // A contact across a rank boundary is evaluated on both sides; the side that owns the larger id reports
    // it.
    if (c.j >= atom->nlocal && atom->tag[c.i] <= atom->tag[c.j]) continue;
    rows_.push_back(row_of(c));
  }
  row_pointers_.clear();
  for (auto& row : rows_) row_pointers_.push_back(row.data());
  array_local = row_pointers_.data();
  size_local_rows = static_cast<int>(rows_.size());
}

ComputeContactDisc::Row ComputeContactDisc::row_of(const AppliedContact& c) const {
  const double *x_1 = atom->x[c.i], *x_2 = atom->x[c.j];
  return {static_cast<double>(atom->tag[c.i]),
          static_cast<double>(atom->tag[c.j]),
          x_1[0],
          x_1[1],
          x_2[0],
          x_2[1],
          c.n_x,
          c.n_y,
          c.overlap,
          -c.force.f_n * c.n_x - c.force.f_t * c.n_y,
          -c.force.f_n * c.n_y + c.force.f_t * c.n_x,
          c.force.f_n,
          c.force.f_t,
          c.force.xi,
          c.v_n,
          c.v_t};
}

double ComputeContactDisc::memory_usage() {
  return static_cast<double>(rows_.capacity() * sizeof(Row));
}

}  // namespace mikromakro::liggghts
