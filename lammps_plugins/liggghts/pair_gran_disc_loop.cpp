// The pair loop of the disc law: one instance for each combination of effects, each plain and observed.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string>
#include <utility>

#include "atom.h"
#include "error.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair_gran_disc.h"
#include "physics/contact_batch.h"
#include "update.h"

// Compiled for AVX2 and for any x86-64; the processor decides. Without fused multiply-add, so that both give
// the same. Clang does not clone templates.
#ifdef __clang__
#define FOR_EACH_PROCESSOR
#else
#define FOR_EACH_PROCESSOR __attribute__((target_clones("avx2", "default")))
#endif

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
void PairGranDisc::stop_at_coincident_centres(const ContactBatch& c, const Lanes& lanes) const {
  int lane = 0;
  while (!std::isnan(c.n_x[lane])) ++lane;
  const auto [i, j] = pairs_[lanes[lane]];
  const std::string text = "ERROR: " + style() + ": discs " + std::to_string(atom->tag[i]) + " and " +
                           std::to_string(atom->tag[j]) + " have the same centre in step " +
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
    places_[i] = {x[i][0], x[i][1], atom->radius[i]};
    motions_[i] = {v[i][0], v[i][1], omega[i][2]};
  }
  loads_.resize(count);
}

/// Adds the loads of the owned discs to the engine's forces and torques, and leaves none for the next step.
void PairGranDisc::scatter() {
  auto* f = reinterpret_cast<Vector3*>(atom->f[0]);
  auto* torque = reinterpret_cast<Vector3*>(atom->torque[0]);
  const int nlocal = atom->nlocal;
  for (int i = 0; i < nlocal; ++i) {
    f[i][0] += loads_[i].f_x;
    f[i][1] += loads_[i].f_y;
    torque[i][2] += loads_[i].torque;
    loads_[i] = {0, 0, 0};
  }
  std::fill(loads_.begin() + nlocal, loads_.end(), Load{0, 0, 0});
}

/// Copies the engine's neighbour list, which it has just built, into one flat list of pairs.
template <Effects effects>
void PairGranDisc::flatten(PairGran& pair) {
  const NeighList& list = *pair.list;
  pairs_.clear();
  touching_.clear();
  apart_.clear();
  first_pair_.resize(atom->nlocal);
  history_size_ = pair.dnum();
  for (int ii = 0; ii < list.inum; ++ii) {
    const int i = list.ilist[ii];
    first_pair_[i] = static_cast<int>(pairs_.size());
    for (int jj = 0; jj < list.numneigh[i]; ++jj) {
      bool touched = false;
      if constexpr (effects.spring()) touched = pair.listgranhistory->firstneigh[i][jj] != 0;
      (touched ? touching_ : apart_).push_back(static_cast<int>(pairs_.size()));
      pairs_.push_back({i, list.firstneigh[i][jj] & NEIGHMASK});
    }
  }
  if constexpr (effects.spring()) {
    flags_ = pair.listgranhistory->firstneigh;
    histories_ = pair.listgranhistory->firstdouble;
  }
}

/// Where the engine keeps the history of a pair: xi [m] and slip rate [m/s].
inline double* PairGranDisc::history_of(int index) const {
  const int i = pairs_[index].i;
  return histories_[i] + history_size_ * (index - first_pair_[i]);
}

namespace {

/// Moves the few sorted `moved` from one sorted list to another, in place.
void move_sorted(std::vector<int>& from, std::vector<int>& to, const std::vector<int>& moved) {
  auto next = moved.begin();
  auto kept = std::lower_bound(from.begin(), from.end(), *next);
  for (auto read = kept; read != from.end(); ++read) {
    if (next != moved.end() && *read == *next) {
      ++next;
    } else {
      *kept++ = *read;
    }
  }
  from.erase(kept, from.end());

  // From the end, until all that is new has found its place.
  auto old = static_cast<std::ptrdiff_t>(to.size()) - 1;
  to.resize(to.size() + moved.size());
  auto write = static_cast<std::ptrdiff_t>(to.size()) - 1;
  for (auto left = static_cast<std::ptrdiff_t>(moved.size()) - 1; left >= 0;) {
    to[write--] = old >= 0 && to[old] > moved[left] ? to[old--] : moved[left--];
  }
}

}  // namespace

/// Looks through the pairs that were apart; those that overlap now begin with a spring of zero.
template <Effects effects>
void PairGranDisc::find_first_contacts() {
  const Place* places = places_.data();
  first_contacts_.clear();
  for (const int index : apart_) {
    const Place &a = places[pairs_[index].i], &b = places[pairs_[index].j];
    const double d_x = b.x - a.x, d_y = b.y - a.y;
    if (a.radius + b.radius - std::sqrt(d_x * d_x + d_y * d_y) > 0) first_contacts_.push_back(index);
  }
  if (first_contacts_.empty()) return;
  move_sorted(apart_, touching_, first_contacts_);
  if constexpr (effects.spring()) {
    for (const int index : first_contacts_) start_spring(index, 1);
  }
}

void PairGranDisc::start_spring(int index, int flag) {
  const int i = pairs_[index].i;
  flags_[i][index - first_pair_[i]] = flag;
  double* history = history_of(index);
  history[history_xi] = history[history_slip_rate] = 0;
}

/// Places, velocities, springs and material constants of the pairs in the lanes.
template <Effects effects>
void PairGranDisc::load(ContactBatch& c, const int* lanes, int count) const {
  for (int k = 0; k < count; ++k) {
    const auto [i, j] = pairs_[lanes[k]];
    const Place &a = places_[i], &b = places_[j];
    const Motion &m = motions_[i], &n = motions_[j];
    c.d_x[k] = b.x - a.x;
    c.d_y[k] = b.y - a.y;
    c.a_1[k] = a.radius;
    c.a_2[k] = b.radius;
    c.w_x[k] = m.v_x - n.v_x;
    c.w_y[k] = m.v_y - n.v_y;
    if constexpr (effects.tangential != Tangential::none) {
      c.omega_1[k] = m.omega;
      c.omega_2[k] = n.omega;
    }
    if constexpr (effects.spring()) {
      const double* history = history_of(lanes[k]);
      c.xi[k] = history[history_xi];
      c.slip_rate[k] = history[history_slip_rate];
    }
  }
  if (one_material_) return;  // it is in all lanes already
  const std::size_t types = atom->ntypes;
  for (int k = 0; k < count; ++k) {
    const auto [i, j] = pairs_[lanes[k]];
    c.set_material(k, parameters_[(atom->type[i] - 1) * types + atom->type[j] - 1]);
  }
}

namespace {

template <Effects effects>
FOR_EACH_PROCESSOR physics::BatchState batch_geometry(ContactBatch& c, int count, bool predicted, double dt) {
  const auto state = physics::contact_geometry<effects>(c, count);
  if constexpr (effects.spring()) physics::contact_slip(c, count, predicted, dt);
  return state;
}
template <Effects effects>
FOR_EACH_PROCESSOR void batch_forces(ContactBatch& c, int count) {
  physics::contact_forces<effects>(c, count);
}

}  // namespace

/// With predicted velocities, contacts that begin in this step slip from the moment when they touched.
void PairGranDisc::slip_of_first_contacts(ContactBatch& c, const int* lanes, int count, double dt) const {
  auto first = std::lower_bound(first_contacts_.begin(), first_contacts_.end(), lanes[0]);
  for (int k = 0; k < count && first != first_contacts_.end(); ++k) {
    if (lanes[k] != *first) continue;
    ++first;
    c.slip_rate[k] = c.v_t[k];
    if (predicted_ && dt > 0)
      c.slip[k] = physics::slip_since_onset({c.overlap[k], c.v_n[k], c.v_t[k], 0}, dt);
  }
}

/// Takes the lanes that overlap no more out of the batch and notes their pairs; returns how many stay.
template <Effects effects>
int PairGranDisc::drop_ended(const ContactBatch& c, Lanes& lanes, int count) {
  int stay = 0;
  for (int k = 0; k < count; ++k) {
    if (c.overlap[k] <= 0) {
      ended_.push_back(lanes[k]);
      if constexpr (effects.spring()) start_spring(lanes[k], 0);
    } else {
      lanes[stay++] = lanes[k];
    }
  }
  return stay;
}

/// Adds the forces and torques to both discs and keeps the springs.
template <Effects effects>
void PairGranDisc::store(const ContactBatch& c, const int* lanes, int count, bool move_spring) {
  for (int k = 0; k < count; ++k) {
    const auto [i, j] = pairs_[lanes[k]];
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
      double* history = history_of(lanes[k]);
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

  find_first_contacts<effects>();
  ended_.clear();
  Lanes lanes;
  for (std::size_t next = 0; next < touching_.size(); next += ContactBatch::lanes) {
    int count = static_cast<int>(std::min<std::size_t>(ContactBatch::lanes, touching_.size() - next));
    std::copy_n(touching_.begin() + static_cast<std::ptrdiff_t>(next), count, lanes.begin());
    load<effects>(c, lanes.data(), count);
    auto state = batch_geometry<effects>(c, count, predicted_, dt);
    if (!state.all_defined) stop_at_coincident_centres(c, lanes);
    if (!state.all_touch) {
      count = drop_ended<effects>(c, lanes, count);
      load<effects>(c, lanes.data(), count);
      batch_geometry<effects>(c, count, predicted_, dt);
    }
    if (effects.spring() && !first_contacts_.empty()) slip_of_first_contacts(c, lanes.data(), count, dt);
    batch_forces<effects>(c, count);
    store<effects>(c, lanes.data(), count, move_spring);
    if constexpr (observed) {
      for (int k = 0; k < count; ++k) observe(pair, c, k, lanes[k], addflag);
    }
  }
  if (!ended_.empty()) move_sorted(touching_, apart_, ended_);
  if (pair.computeflag()) {
    scatter();
  } else {
    std::fill(loads_.begin(), loads_.end(), Load{0, 0, 0});
  }
}

/// Hands one contact to whoever looks at it: our own record, `compute pair/gran/local`, the virial.
void PairGranDisc::observe(PairGran& pair, const ContactBatch& c, int k, int index, bool addflag) {
  const auto [i, j] = pairs_[index];
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
    data.contact_history = effects_.spring() ? history_of(index) : nullptr;
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

template <int... numbers>
void PairGranDisc::choose_among(std::integer_sequence<int, numbers...> /*combinations*/) {
  (use_loops_of<physics::effects_of_combination(numbers)>(), ...);
}

void PairGranDisc::choose_loops() {
  choose_among(std::make_integer_sequence<int, physics::effect_combinations>{});
}

}  // namespace mikromakro::liggghts
