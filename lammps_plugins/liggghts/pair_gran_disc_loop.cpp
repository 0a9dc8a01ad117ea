// The pair loop of the disc law: one instance for each combination of effects, each plain and observed.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "atom.h"
#include "error.h"
#include "neigh_list.h"
#include "neighbor.h"
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

/// What the pair loop reads of each disc, owned or ghost, side by side: the engine's arrays would cost a
/// cache line each for every neighbour.
void PairGranDisc::gather() {
  const int count = atom->nlocal + atom->nghost;
  places_.resize(count);
  motions_.resize(count);
  const auto* x = reinterpret_cast<const Vector3*>(atom->x[0]);
  const auto* v = reinterpret_cast<const Vector3*>(atom->v[0]);
  const auto* omega = reinterpret_cast<const Vector3*>(atom->omega[0]);
  for (int i = 0; i < count; ++i) {
    places_[i] = {x[i][0], x[i][1], atom->radius[i], atom->type[i] - 1};
    motions_[i] = {v[i][0], v[i][1], omega[i][2]};
  }
  loads_.assign(count, {0, 0, 0});
}

/// Adds the loads of the owned discs to the engine's forces and torques.
void PairGranDisc::scatter() const {
  auto* f = reinterpret_cast<Vector3*>(atom->f[0]);
  auto* torque = reinterpret_cast<Vector3*>(atom->torque[0]);
  for (int i = 0; i < atom->nlocal; ++i) {
    f[i][0] += loads_[i].f_x;
    f[i][1] += loads_[i].f_y;
    torque[i][2] += loads_[i].torque;
  }
}

/// Copies the engine's neighbour list, which it has just built, into one flat list of pairs.
template <Effects effects>
void PairGranDisc::flatten(PairGran& pair) {
  const NeighList& list = *pair.list;
  const std::ptrdiff_t history_size = pair.dnum();
  pairs_.clear();
  for (int ii = 0; ii < list.inum; ++ii) {
    const int i = list.ilist[ii];
    for (int jj = 0; jj < list.numneigh[i]; ++jj) {
      NeighbourPair p{i, list.firstneigh[i][jj] & NEIGHMASK, Touch::no, nullptr, nullptr};
      if constexpr (effects.spring()) {
        p.flag = &pair.listgranhistory->firstneigh[i][jj];
        p.history = &pair.listgranhistory->firstdouble[i][history_size * jj];
        p.touch = *p.flag ? Touch::yes : Touch::no;
      }
      pairs_.push_back(p);
    }
  }
  touching_.resize(pairs_.size());
}

/// Fills touching_ with the pairs that overlap and returns their number. Which pairs do is as good as random
/// to a processor, so the loop has no branch on it; only the few pairs whose state changes take one.
template <Effects effects>
std::size_t PairGranDisc::find_contacts() {
  std::size_t count = 0;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    NeighbourPair& p = pairs_[k];
    const Place &a = places_[p.i], &b = places_[p.j];
    const double d_x = b.x - a.x, d_y = b.y - a.y, reach = a.radius + b.radius;
    const bool touch = d_x * d_x + d_y * d_y < reach * reach;
    touching_[count] = static_cast<int>(k);
    count += touch;
    if constexpr (effects.spring()) {
      if (touch == (p.touch == Touch::no)) {
        p.touch = touch ? Touch::first : Touch::no;
        *p.flag = touch;
        if (!touch) p.history[history_xi] = p.history[history_slip_rate] = 0;
      }
    }
  }
  return count;
}

template <Effects effects, bool observed>
void PairGranDisc::loop(PairGran& pair, bool addflag) {
  gather();
  if (neighbor->ago == 0 || pairs_.empty()) flatten<effects>(pair);
  const bool move_spring = pair.computeflag() && pair.shearupdate();
  const std::size_t types = atom->ntypes, contacts = find_contacts<effects>();

  for (std::size_t k = 0; k < contacts; ++k) {
    NeighbourPair& p = pairs_[touching_[k]];
    const Place &a = places_[p.i], &b = places_[p.j];
    const Motion &m = motions_[p.i], &n = motions_[p.j];
    const double d_x = b.x - a.x, d_y = b.y - a.y;
    const double distance = std::sqrt(d_x * d_x + d_y * d_y);
    if (distance == 0) stop_at_coincident_centres(p.i, p.j);
    const double inverse = 1 / distance, n_x = d_x * inverse, n_y = d_y * inverse;
    const double overlap = a.radius + b.radius - distance;
    const double arm_i = a.radius - overlap / 2, arm_j = b.radius - overlap / 2;
    const double w_x = m.v_x - n.v_x, w_y = m.v_y - n.v_y;
    physics::ContactState state{overlap, w_x * n_x + w_y * n_y, 0, 0};
    if constexpr (effects.tangential != Tangential::none) {
      state.v_t = w_y * n_x - w_x * n_y + m.omega * arm_i + n.omega * arm_j;
    }
    double slip = 0;
    if constexpr (effects.spring()) {
      state.xi = p.history[history_xi];
      if (move_spring) slip = slip_of(state, p.touch != Touch::first, p.history[history_slip_rate]);
    }

    const auto force = physics::contact_force<effects>(parameters_[a.type * types + b.type], state, slip);
    if constexpr (effects.spring()) {
      if (move_spring) p.history[history_xi] = force.xi;
      if (p.touch == Touch::first) {
        p.history[history_slip_rate] = state.v_t;
        p.touch = Touch::yes;
      }
    }
    // Force on i: -f_n n + f_t t.
    const double f_x = -force.f_n * n_x - force.f_t * n_y, f_y = -force.f_n * n_y + force.f_t * n_x;
    Load &on_i = loads_[p.i], &on_j = loads_[p.j];
    on_i.f_x += f_x;
    on_i.f_y += f_y;
    on_j.f_x -= f_x;
    on_j.f_y -= f_y;
    if constexpr (effects.tangential != Tangential::none) {
      on_i.torque += arm_i * force.f_t;
      on_j.torque += arm_j * force.f_t;
    }
    if constexpr (observed) {
      observe<effects>(pair, {p.i, p.j, n_x, n_y, overlap, force, state.v_n, state.v_t}, p.history, addflag);
    }
  }
  if (pair.computeflag()) scatter();
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
