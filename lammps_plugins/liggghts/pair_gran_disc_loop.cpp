// The pair loop of the disc law: one instance for each combination of effects, each plain and observed.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "atom.h"
#include "error.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair_gran_disc.h"
#include "physics/contact_batch.h"
#include "update.h"

namespace mikromakro::liggghts {

using namespace LAMMPS_NS;
using physics::ContactBatch;
using physics::Effects;
using physics::Tangential;

namespace {
using Vector3 = double[3];

// Columns of the contact history.
constexpr int history_xi = 0, history_slip_rate = 1;
}  // namespace

/// The engine's Error::one is silent on all ranks but the first, and loses its line where the output is a
/// pipe.
void PairGranDisc::stop_at_coincident_centres(const ContactBatch& c) const {
  int lane = 0;
  while (!std::isnan(c.n_x[lane])) ++lane;
  const auto [i, j] = pairs_[touching_[lane]];
  const std::string text = "ERROR: pair_style gran model disc/linear: discs " + std::to_string(atom->tag[i]) +
                           " and " + std::to_string(atom->tag[j]) + " have the same centre in step " +
                           std::to_string(update->ntimestep) + ": their contact has no normal\n";
  if (logfile) std::fputs(text.c_str(), logfile);
  std::fflush(nullptr);
  std::fputs(text.c_str(), stderr);
  MPI_Abort(world, 1);
  std::abort();
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
  springs_.clear();
  for (int ii = 0; ii < list.inum; ++ii) {
    const int i = list.ilist[ii];
    for (int jj = 0; jj < list.numneigh[i]; ++jj) {
      pairs_.push_back({i, list.firstneigh[i][jj] & NEIGHMASK});
      if constexpr (effects.spring()) {
        int* flag = &pair.listgranhistory->firstneigh[i][jj];
        springs_.push_back({flag, &pair.listgranhistory->firstdouble[i][history_size * jj]});
      }
    }
  }
  touched_.assign(pairs_.size(), 0);
  if constexpr (effects.spring()) {
    for (std::size_t k = 0; k < springs_.size(); ++k) touched_[k] = *springs_[k].flag != 0;
  }
}

/// Goes on through the pairs from `next` and puts those that overlap into the batch, until it is full or the
/// pairs end; returns their number. Which pairs overlap is as good as random to a processor, so there is no
/// branch on it; only the few pairs whose state changes take one.
template <Effects effects>
int PairGranDisc::find_contacts(ContactBatch& c, std::size_t& next) {
  const Place* places = places_.data();
  const NeighbourPair* pairs = pairs_.data();
  unsigned char* touched = touched_.data();
  const std::size_t end = pairs_.size();
  std::size_t pair = next;
  int count = 0;
  first_contacts_.clear();
  for (; pair < end && count < ContactBatch::lanes; ++pair) {
    const Place &a = places[pairs[pair].i], &b = places[pairs[pair].j];
    const double d_x = b.x - a.x, d_y = b.y - a.y, reach = a.radius + b.radius;
    const bool touch = d_x * d_x + d_y * d_y < reach * reach;
    c.d_x[count] = d_x;
    c.d_y[count] = d_y;
    c.a_1[count] = a.radius;
    c.a_2[count] = b.radius;
    touching_[count] = static_cast<int>(pair);
    if constexpr (effects.spring()) {
      if (touch != (touched[pair] != 0)) begin_or_end(pair, touch, count);
    }
    count += touch;
  }
  next = pair;
  return count;
}

/// A spring starts and ends with zero; contacts that begin are noted by their lane.
void PairGranDisc::begin_or_end(std::size_t pair, bool touch, int lane) {
  touched_[pair] = touch;
  *springs_[pair].flag = touch;
  springs_[pair].history[history_xi] = springs_[pair].history[history_slip_rate] = 0;
  if (touch) first_contacts_.push_back(lane);
}

/// Velocities, springs and material constants of the contacts in the batch.
template <Effects effects>
void PairGranDisc::load(ContactBatch& c, int count) const {
  for (int k = 0; k < count; ++k) {
    const auto [i, j] = pairs_[touching_[k]];
    const Motion &m = motions_[i], &n = motions_[j];
    c.w_x[k] = m.v_x - n.v_x;
    c.w_y[k] = m.v_y - n.v_y;
    if constexpr (effects.tangential != Tangential::none) {
      c.omega_1[k] = m.omega;
      c.omega_2[k] = n.omega;
    }
    if constexpr (effects.spring()) {
      c.xi[k] = springs_[touching_[k]].history[history_xi];
      c.slip_rate[k] = springs_[touching_[k]].history[history_slip_rate];
    }
  }
  if (one_material_) return;  // it is in all lanes already
  const std::size_t types = atom->ntypes;
  for (int k = 0; k < count; ++k) {
    const auto [i, j] = pairs_[touching_[k]];
    c.set_material(k, parameters_[places_[i].type * types + places_[j].type]);
  }
}

namespace {

// Compiled for AVX2 and for any x86-64; the processor decides. Without fused multiply-add, so that both give
// the same.
template <Effects effects>
__attribute__((target_clones("avx2", "default"))) bool batch_geometry(ContactBatch& c, int count,
                                                                      bool predicted, double dt) {
  const bool defined = physics::contact_geometry<effects>(c, count);
  if constexpr (effects.spring()) physics::contact_slip(c, count, predicted, dt);
  return defined;
}
template <Effects effects>
__attribute__((target_clones("avx2", "default"))) void batch_forces(ContactBatch& c, int count) {
  physics::contact_forces<effects>(c, count);
}

}  // namespace

/// With predicted velocities, contacts that begin in this step slip from the moment when they touched.
void PairGranDisc::slip_of_first_contacts(ContactBatch& c, double dt) const {
  for (const int k : first_contacts_) {
    c.slip_rate[k] = c.v_t[k];
    if (predicted_ && dt > 0)
      c.slip[k] = physics::slip_since_onset({c.overlap[k], c.v_n[k], c.v_t[k], 0}, dt);
  }
}

/// Adds the forces and torques to both discs and keeps the springs.
template <Effects effects>
void PairGranDisc::store(const ContactBatch& c, int count, bool move_spring) {
  for (int k = 0; k < count; ++k) {
    const auto [i, j] = pairs_[touching_[k]];
    Load &on_i = loads_[i], &on_j = loads_[j];
    on_i.f_x += c.f_x[k];
    on_i.f_y += c.f_y[k];
    on_j.f_x -= c.f_x[k];
    on_j.f_y -= c.f_y[k];
    if constexpr (effects.tangential != Tangential::none) {
      on_i.torque += c.torque_1[k];
      on_j.torque += c.torque_2[k];
    }
  }
  if constexpr (effects.spring()) {
    if (!move_spring) return;
    for (int k = 0; k < count; ++k) {
      double* history = springs_[touching_[k]].history;
      history[history_xi] = c.xi[k];
      history[history_slip_rate] = c.slip_rate[k];
    }
  }
}

template <Effects effects, bool observed>
void PairGranDisc::loop(PairGran& pair, bool addflag) {
  gather();
  if (neighbor->ago == 0 || pairs_.empty()) flatten<effects>(pair);
  const bool move_spring = pair.computeflag() && pair.shearupdate();
  const double dt = move_spring ? update->dt : 0.0;
  ContactBatch& c = *batch_;
  for (int k = 0; k < ContactBatch::lanes; ++k) c.set_material(k, parameters_.front());

  for (std::size_t next = 0; next < pairs_.size();) {
    const int count = find_contacts<effects>(c, next);
    load<effects>(c, count);
    if (!batch_geometry<effects>(c, count, predicted_, dt)) stop_at_coincident_centres(c);
    if constexpr (effects.spring()) slip_of_first_contacts(c, dt);
    batch_forces<effects>(c, count);
    store<effects>(c, count, move_spring);
    if constexpr (observed) {
      for (int k = 0; k < count; ++k) observe(pair, c, k, addflag);
    }
  }
  if (pair.computeflag()) scatter();
}

/// Hands one contact to whoever looks at it: our own record, `compute pair/gran/local`, the virial.
void PairGranDisc::observe(PairGran& pair, const ContactBatch& c, int k, bool addflag) {
  const auto [i, j] = pairs_[touching_[k]];
  if (recording_) {
    const double xi = effects_.spring() ? c.xi[k] : 0.0;
    applied_.push_back(
        {i, j, c.n_x[k], c.n_y[k], c.overlap[k], {c.f_n[k], c.f_t[k], xi}, c.v_n[k], c.v_t[k]});
  }
  if (pair.cpl() && addflag) {
    LCM::SurfacesIntersectData data;
    LCM::ForceData force_on_i;
    data.i = i;
    data.j = j;
    data.deltan = c.overlap[k];
    data.contact_history = effects_.spring() ? springs_[touching_[k]].history : nullptr;
    force_on_i.delta_F[0] = c.f_x[k];
    force_on_i.delta_F[1] = c.f_y[k];
    force_on_i.delta_torque[2] = c.torque_1[k];
    pair.cpl_add_pair(data, force_on_i);
  }
  if (pair.evflag) {
    pair.ev_tally_xyz(i, j, atom->nlocal, 0, 0.0, 0.0, c.f_x[k], c.f_y[k], 0.0, -c.d_x[k], -c.d_y[k], 0.0);
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
