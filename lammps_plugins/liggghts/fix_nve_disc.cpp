#include "fix_nve_disc.h"

#include <cstring>
#include <string>

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "update.h"

namespace mikromakro::liggghts {

using namespace LAMMPS_NS;

FixNveDisc::FixNveDisc(LAMMPS* engine, int narg, char** arg) : Fix(engine, narg, arg) {
  time_integrate = 1;
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
}

FixNveDisc::~FixNveDisc() {
  atom->delete_callback(id, 0);
}

int FixNveDisc::setmask() {
  return FixConst::INITIAL_INTEGRATE | FixConst::FINAL_INTEGRATE;
}

void FixNveDisc::init() {
  if (domain->dimension != 2)
    error->all(FLERR, "fix nve/disc: discs live in two dimensions; put 'dimension 2' before the box");
}

void FixNveDisc::initial_integrate(int /*vflag*/) {
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
}

void FixNveDisc::grow_arrays(int nmax) {
  half_step_.resize(nmax);
}

void FixNveDisc::copy_arrays(int from, int to, int /*delflag*/) {
  half_step_[to] = half_step_[from];
}

int FixNveDisc::pack_exchange(int i, double* buffer) {
  std::memcpy(buffer, &half_step_[i], sizeof(HalfStep));
  return 3;
}

int FixNveDisc::unpack_exchange(int i, double* buffer) {
  std::memcpy(&half_step_[i], buffer, sizeof(HalfStep));
  return 3;
}

double FixNveDisc::memory_usage() {
  return static_cast<double>(half_step_.size() * sizeof(HalfStep));
}

}  // namespace mikromakro::liggghts
