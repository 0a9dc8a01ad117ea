// SPDX-License-Identifier: GPL-2.0-or-later
#include "output/fix_energy_disc.h"

#include <mpi.h>

#include <algorithm>
#include <numeric>

#include "atom.h"
#include "comm.h"
#include "engine/arguments.h"
#include "engine/engine_access.h"
#include "engine/engine_lists.h"
#include "engine/restart_state.h"
#include "law/disc_law.h"
#include "modify.h"
#include "physics/contact/contact_energy.h"
#include "physics/walls/smooth_wall.h"
#include "update.h"

namespace mikromakro::styles {
namespace {

// Columns of ContactRow.
constexpr int column_id1 = 0, column_id2 = 1, column_overlap = 8, column_fn = 11, column_ft = 12,
              column_xi = 13, column_vn = 14, column_vt = 15;

}  // namespace

FixEnergyDisc::FixEnergyDisc(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : FixOfEngine(engine, narg, arg) {
  nevery = 1;
  restart_global = 1;
  scalar_flag = vector_flag = 1;
  size_vector = 5;
  global_freq = 1;
  extscalar = extvector = 1;
  if (narg > 3) Arguments(*lmp, style, narg, arg, 3).unexpected("no arguments after the style");
  if (atom->map_style == 0) stop(*lmp, style, "expected 'atom_modify map array' before the box is created");
}

int FixEnergyDisc::setmask() {
  return LAMMPS_NS::FixConst::END_OF_STEP;
}

void FixEnergyDisc::init() {
  if (!active_disc_law(*lmp))
    stop(*lmp, style, std::string("needs '") + disc_pair_style + "' before the run");
}

void FixEnergyDisc::find_walls() {
  walls_.clear();
  for (const Fix* fix : fixes(*modify)) {
    const auto* source = dynamic_cast<const WallContactSource*>(fix);
    if (!source) continue;
    const auto kinds = source->wall_kinds();
    walls_.insert(walls_.end(), kinds.begin(), kinds.end());
  }
}

// A continued run uses the powers of the last step, whose velocities were predicted.
void FixEnergyDisc::setup(int /*vflag*/) {
  const Contacts before = now_;
  now_ = evaluate();
  if (begun_) {
    now_.dashpot_power = before.dashpot_power;
    now_.tangential_power = before.tangential_power;
  } else {
    first_spring_energy_ = now_.spring_energy;
  }
  begun_ = true;
  step_of_values_ = -1;
}

void FixEnergyDisc::end_of_step() {
  const Contacts before = now_;
  now_ = evaluate();
  dashpot_heat_ += update->dt * 0.5 * (before.dashpot_power + now_.dashpot_power);
  tangential_work_ += update->dt * 0.5 * (before.tangential_power + now_.tangential_power);
}

FixEnergyDisc::Partner FixEnergyDisc::partner_of(const ContactRow& row, double radius) const {
  const int id = static_cast<int>(row[column_id2]);
  if (id > 0) {
    const int j = atom->map(id);
    return {atom->type[j], physics::reduced_radius(radius, atom->radius[j])};
  }
  const auto wall =
      std::find_if(walls_.begin(), walls_.end(), [&](const WallKind& kind) { return kind.id == id; });
  return {wall->type, physics::reduced_radius_at(wall->curvature, radius)};
}

template <class NormalLaw>
FixEnergyDisc::Contacts FixEnergyDisc::sum_of_rows() const {
  const DiscLaw& law = *active_disc_law(*lmp);
  Contacts sum;
  for (const ContactRow& row : rows_) {
    const int i = atom->map(static_cast<int>(row[column_id1]));
    const Partner partner = partner_of(row, atom->radius[i]);
    const physics::ContactParameters& p = law.parameters(atom->type[i], partner.type);
    const physics::ContactState state{row[column_overlap], row[column_vn], row[column_vt], row[column_xi],
                                      partner.reduced_radius};
    sum.normal_energy += NormalLaw::energy(p.normal_stiffness, state);
    sum.spring_energy += physics::spring_energy(p, state.xi);
    sum.dashpot_power += (row[column_fn] - NormalLaw::force(p.normal_stiffness, state)) * state.v_n;
    sum.tangential_power += physics::tangential_power(row[column_ft], state.v_t);
  }
  return sum;
}

FixEnergyDisc::Contacts FixEnergyDisc::evaluate() {
  rows_.clear();
  if (!append_contact_rows(*lmp, groupbit, rows_))
    stop(*lmp, style, "expected the contacts of this step; define it after the fixes with walls");
  find_walls();
  return physics::with_law(active_disc_law(*lmp)->effects().normal,
                           [this](auto law) { return sum_of_rows<decltype(law)>(); });
}

double FixEnergyDisc::kinetic_energy() const {
  double sum = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double *v = atom->v[i], rim = atom->omega[i][2] * atom->radius[i];
    sum += atom->rmass[i] / 2 * (v[0] * v[0] + v[1] * v[1] + rim * rim / 2);
  }
  return sum;
}

void FixEnergyDisc::update_values() {
  if (step_of_values_ == update->ntimestep) return;
  values_ = {kinetic_energy(), now_.normal_energy, now_.spring_energy, dashpot_heat_,
             tangential_work_ - (now_.spring_energy - first_spring_energy_)};
  MPI_Allreduce(MPI_IN_PLACE, values_.data(), 5, MPI_DOUBLE, MPI_SUM, world);
  step_of_values_ = update->ntimestep;
}

double FixEnergyDisc::compute_scalar() {
  update_values();
  return std::accumulate(values_.begin(), values_.end(), 0.0);
}

double FixEnergyDisc::compute_vector(int i) {
  update_values();
  return values_[i];
}

std::array<double, 5> FixEnergyDisc::tallies() const {
  return {dashpot_heat_, tangential_work_, first_spring_energy_, now_.dashpot_power, now_.tangential_power};
}

void FixEnergyDisc::set_tallies(const std::array<double, 5>& tallies) {
  dashpot_heat_ = tallies[0];
  tangential_work_ = tallies[1];
  first_spring_energy_ = tallies[2];
  now_.dashpot_power = tallies[3];
  now_.tangential_power = tallies[4];
}

// The sums over all ranks are assigned to the first one, here and in the continued run, so that both add the
// same numbers.
void FixEnergyDisc::write_restart(FILE* fp) {
  std::array<double, 5> sums = tallies();
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), 5, MPI_DOUBLE, MPI_SUM, world);
  set_tallies(comm->me == 0 ? sums : std::array<double, 5>{});
  if (comm->me != 0) return;
  write_state(fp, sums);
}

void FixEnergyDisc::restart(char* buffer) {
  auto sums = read_state<std::array<double, 5>>(*lmp, *this, buffer);
  if (comm->me != 0) sums.fill(0.0);
  set_tallies(sums);
  begun_ = true;
}

}  // namespace mikromakro::styles
