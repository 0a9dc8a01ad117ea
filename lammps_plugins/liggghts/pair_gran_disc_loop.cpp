// The pair loop of the disc law: one instance for each combination of effects, each plain and observed.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "atom.h"
#include "error.h"
#include "neigh_list.h"
#include "pair_gran_disc.h"
#include "update.h"

namespace mikromakro::liggghts {

using namespace LAMMPS_NS;
using physics::Effects;
using physics::Tangential;

namespace {
using Vector3 = double[3];

// Columns of the contact history.
constexpr int history_xi = 0, history_slip_rate = 1;
}  // namespace

/// The engine's Error::one is silent on all ranks but the first, and loses its line where the output is a
/// pipe.
void PairGranDisc::stop_at_coincident_centres(int i, int j) const {
  const std::string text = "ERROR: pair_style gran model disc/linear: discs " + std::to_string(atom->tag[i]) +
                           " and " + std::to_string(atom->tag[j]) + " have the same centre in step " +
                           std::to_string(update->ntimestep) + ": their contact has no normal\n";
  if (logfile) std::fputs(text.c_str(), logfile);
  std::fflush(nullptr);
  std::fputs(text.c_str(), stderr);
  MPI_Abort(world, 1);
  std::abort();
}

/// Slip of a contact in this step; slip_rate is kept from step to step. The stock integrators let the atoms
/// carry half-step velocities, which need no correction.
double PairGranDisc::slip_of(const physics::ContactState& state, bool touched, double& slip_rate) const {
  if (!predicted_) return state.v_t * update->dt;
  if (!touched) return physics::slip_since_onset(state, update->dt);
  slip_rate = physics::slip_rate_of_half_step(slip_rate, state.v_t);
  return slip_rate * update->dt;
}

template <Effects effects, bool observed>
void PairGranDisc::loop(PairGran& pair, bool addflag) {
  // The engine keeps these arrays contiguous.
  const auto* x = reinterpret_cast<const Vector3*>(atom->x[0]);
  const auto* v = reinterpret_cast<const Vector3*>(atom->v[0]);
  const auto* omega = reinterpret_cast<const Vector3*>(atom->omega[0]);
  auto* f = reinterpret_cast<Vector3*>(atom->f[0]);
  auto* torque = reinterpret_cast<Vector3*>(atom->torque[0]);
  const double* radius = atom->radius;
  const int* type = atom->type;
  const int nlocal = atom->nlocal;
  const int types = atom->ntypes;
  const bool apply = pair.computeflag() != 0;
  const bool move_spring = apply && pair.shearupdate() != 0;
  const int history_size = pair.dnum();
  NeighList& list = *pair.list;

  for (int ii = 0; ii < list.inum; ++ii) {
    const int i = list.ilist[ii];
    const double x_i = x[i][0], y_i = x[i][1], a_i = radius[i];
    const int* neighbours = list.firstneigh[i];
    const int count = list.numneigh[i];
    const auto* parameters_i = &parameters_[static_cast<std::size_t>(type[i] - 1) * types];
    int* touching = effects.spring() ? pair.listgranhistory->firstneigh[i] : nullptr;
    double* history = effects.spring() ? pair.listgranhistory->firstdouble[i] : nullptr;
    double f_x = 0, f_y = 0, torque_i = 0;

    for (int jj = 0; jj < count; ++jj) {
      const int j = neighbours[jj] & NEIGHMASK;
      const double d_x = x[j][0] - x_i, d_y = x[j][1] - y_i;
      const double distance_squared = d_x * d_x + d_y * d_y;
      const double reach = a_i + radius[j];
      double* spring = effects.spring() ? &history[static_cast<std::ptrdiff_t>(history_size) * jj] : nullptr;
      if (distance_squared >= reach * reach) {
        if constexpr (effects.spring()) {
          if (touching[jj]) {
            touching[jj] = 0;
            spring[history_xi] = spring[history_slip_rate] = 0;
          }
        }
        continue;
      }
      if (distance_squared == 0) stop_at_coincident_centres(i, j);

      const double distance = std::sqrt(distance_squared);
      const double n_x = d_x / distance, n_y = d_y / distance;
      const double overlap = reach - distance;
      const double arm_i = a_i - overlap / 2, arm_j = radius[j] - overlap / 2;
      const double w_x = v[i][0] - v[j][0], w_y = v[i][1] - v[j][1];
      physics::ContactState state{overlap, w_x * n_x + w_y * n_y, 0, 0};
      if constexpr (effects.tangential != Tangential::none) {
        state.v_t = w_y * n_x - w_x * n_y + omega[i][2] * arm_i + omega[j][2] * arm_j;
      }
      double slip = 0;
      if constexpr (effects.spring()) {
        state.xi = spring[history_xi];
        if (move_spring) slip = slip_of(state, touching[jj], spring[history_slip_rate]);
      }

      const auto force = physics::contact_force<effects>(parameters_i[type[j] - 1], state, slip);
      if constexpr (effects.spring()) {
        if (move_spring) spring[history_xi] = force.xi;
        if (!touching[jj]) spring[history_slip_rate] = state.v_t;
        touching[jj] = 1;
      }
      // Force on i: -f_n n + f_t t.
      const double c_x = -force.f_n * n_x - force.f_t * n_y;
      const double c_y = -force.f_n * n_y + force.f_t * n_x;
      f_x += c_x;
      f_y += c_y;
      if constexpr (effects.tangential != Tangential::none) torque_i += arm_i * force.f_t;
      if (apply && j < nlocal) {
        f[j][0] -= c_x;
        f[j][1] -= c_y;
        if constexpr (effects.tangential != Tangential::none) torque[j][2] += arm_j * force.f_t;
      }
      if constexpr (observed) {
        observe<effects>(pair, {i, j, n_x, n_y, overlap, force, state.v_n, state.v_t}, spring, addflag);
      }
    }
    if (apply) {
      f[i][0] += f_x;
      f[i][1] += f_y;
      torque[i][2] += torque_i;
    }
  }
}

/// Hands one contact to whoever looks at it: our own record, `compute pair/gran/local`, the virial.
template <Effects effects>
void PairGranDisc::observe(PairGran& pair, const AppliedContact& c, double* history, bool addflag) {
  if (recording_) applied_.push_back(c);
  const double c_x = -c.force.f_n * c.n_x - c.force.f_t * c.n_y;
  const double c_y = -c.force.f_n * c.n_y + c.force.f_t * c.n_x;
  if (pair.cpl() && addflag) {
    LCM::SurfacesIntersectData data;
    LCM::ForceData force_on_i;
    data.i = c.i;
    data.j = c.j;
    data.deltan = c.overlap;
    data.contact_history = history;
    force_on_i.delta_F[0] = c_x;
    force_on_i.delta_F[1] = c_y;
    force_on_i.delta_torque[2] = (atom->radius[c.i] - c.overlap / 2) * c.force.f_t;
    pair.cpl_add_pair(data, force_on_i);
  }
  if (pair.evflag) {
    const double distance = atom->radius[c.i] + atom->radius[c.j] - c.overlap;
    pair.ev_tally_xyz(c.i, c.j, atom->nlocal, 0, 0.0, 0.0, c_x, c_y, 0.0, -c.n_x * distance,
                      -c.n_y * distance, 0.0);
  }
}

template <Effects effects>
void PairGranDisc::use_loops_of() {
  if (effects_ != effects) return;
  plain_loop_ = &PairGranDisc::loop<effects, false>;
  observed_loop_ = &PairGranDisc::loop<effects, true>;
}

void PairGranDisc::choose_loops() {
  use_loops_of<Effects{Tangential::none, false}>();
  use_loops_of<Effects{Tangential::none, true}>();
  use_loops_of<Effects{Tangential::viscous_coulomb, false}>();
  use_loops_of<Effects{Tangential::viscous_coulomb, true}>();
  use_loops_of<Effects{Tangential::spring, false}>();
  use_loops_of<Effects{Tangential::spring, true}>();
  use_loops_of<Effects{Tangential::damped_spring, false}>();
  use_loops_of<Effects{Tangential::damped_spring, true}>();
}

}  // namespace mikromakro::liggghts
