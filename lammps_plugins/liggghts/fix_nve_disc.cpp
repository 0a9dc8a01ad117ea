#include "fix_nve_disc.h"

#include <string>

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "update.h"

namespace mikromakro::liggghts {

using namespace LAMMPS_NS;

FixNveDisc::FixNveDisc(LAMMPS* engine, int narg, char** arg) : Fix(engine, narg, arg), last_forces_(*engine) {
  time_integrate = 1;
  restart_global = restart_peratom = 1;
  create_attribute = 1;
  just_created = 0;
  for (int k = 3; k < narg; k += 2) {
    const std::string key = arg[k], value = k + 1 < narg ? arg[k + 1] : "nothing";
    if (key != "velocity" || (value != "predicted" && value != "half_step")) {
      error->all(FLERR, ("fix nve/disc: expected 'velocity predicted' or 'velocity half_step', got '" + key +
                         " " + value + "'")
                            .c_str());
    }
    predicted_ = value == "predicted";
  }
  if (!atom->sphere_flag) error->all(FLERR, "fix nve/disc: needs 'atom_style granular' or 'sphere'");
  grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
}

FixNveDisc::~FixNveDisc() {
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
}

int FixNveDisc::setmask() {
  return FixConst::INITIAL_INTEGRATE | FixConst::FINAL_INTEGRATE;
}

void FixNveDisc::init() {
  if (domain->dimension != 2)
    error->all(FLERR, "fix nve/disc: discs live in two dimensions; put 'dimension 2' before the box");
  step_complete_ = false;
}

void FixNveDisc::initial_integrate(int /*vflag*/) {
  begin_step();
  const double dt = update->dt;
  const int nlocal = atom->nlocal;
  for (int i = 0; i < nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    double *x = atom->x[i], *v = atom->v[i], *omega = atom->omega[i];
    const double kick = dt / 2 / atom->rmass[i];
    const double spin_kick = 2 * kick / (atom->radius[i] * atom->radius[i]);
    const double dv_x = kick * atom->f[i][0], dv_y = kick * atom->f[i][1],
                 domega = spin_kick * atom->torque[i][2];
    v[0] += dv_x;
    v[1] += dv_y;
    omega[2] += domega;
    x[0] += dt * v[0];
    x[1] += dt * v[1];
    if (predicted_) {
      half_step_[i] = {v[0], v[1], omega[2]};
      v[0] += dv_x;
      v[1] += dv_y;
      omega[2] += domega;
    }
  }
}

void FixNveDisc::final_integrate() {
  const double dt = update->dt;
  const int nlocal = atom->nlocal;
  for (int i = 0; i < nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    double *v = atom->v[i], *omega = atom->omega[i];
    const double kick = dt / 2 / atom->rmass[i];
    const double spin_kick = 2 * kick / (atom->radius[i] * atom->radius[i]);
    const HalfStep half = predicted_ ? half_step_[i] : HalfStep{v[0], v[1], omega[2]};
    v[0] = half.v_x + kick * atom->f[i][0];
    v[1] = half.v_y + kick * atom->f[i][1];
    omega[2] = half.omega + spin_kick * atom->torque[i][2];
  }
  end_step();
}

}  // namespace mikromakro::liggghts
