// The pair loop of the disc law: one instance for each combination of effects, each plain and observed.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
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
#define FOR_EACH_PROCESSOR __attribute__((flatten))
#else
#define FOR_EACH_PROCESSOR __attribute__((flatten, target_clones("arch=x86-64-v4", "avx2", "default")))
#endif

namespace mikromakro::liggghts {

using namespace LAMMPS_NS;
using physics::ContactBatch;
using physics::DiscLoad;
using physics::DiscPair;
using physics::DiscRow;
using physics::Effects;
using physics::Tangential;

namespace {

using Vector3 = double[3];

/// A pair that was further apart than this fraction of the neighbour list's skin is not looked at again
/// before discs have moved as far.
constexpr double near_fraction = 0.2;

/// What a batch of pairs reads and writes.
struct BatchOfPairs {
  const DiscRow* discs;
  DiscLoad* loads;
  const DiscPair* pairs;
  const double* touched;
  int count;
  bool predicted;
  double dt;
};

template <Effects effects>
FOR_EACH_PROCESSOR physics::BatchState batch_geometry(ContactBatch& c, const BatchOfPairs& b) {
  physics::load_discs<effects>(c, b.discs, b.pairs, b.count);
  if constexpr (effects.spring()) physics::load_springs(c, b.pairs, b.touched, b.count);
  const auto state = physics::contact_geometry<effects>(c, b.count);
  if constexpr (effects.spring()) physics::contact_slip(c, b.count, b.predicted, b.dt);
  return state;
}

template <Effects effects>
FOR_EACH_PROCESSOR void batch_forces(ContactBatch& c, const BatchOfPairs& b) {
  physics::contact_forces<effects>(c, b.count);
  physics::add_loads<effects>(c, b.pairs, b.count, b.loads);
}

FOR_EACH_PROCESSOR void batch_springs(const ContactBatch& c, const BatchOfPairs& b) {
  physics::store_springs(c, b.pairs, b.count);
}

}  // namespace

/// The engine's Error::one is silent on all ranks but the first, and loses its line where the output is a
/// pipe.
void PairGranDisc::stop_at_coincident_centres(const ContactBatch& c, const DiscPair* pairs) const {
  int lane = 0;
  while (!std::isnan(c.n_x[lane])) ++lane;
  const auto& pair = pairs[lane];
  const std::string text = "ERROR: " + style() + ": discs " + std::to_string(atom->tag[pair.i]) + " and " +
                           std::to_string(atom->tag[pair.j]) + " have the same centre in step " +
                           std::to_string(update->ntimestep) + ": their contact has no normal\n";
  if (logfile) std::fputs(text.c_str(), logfile);
  std::fflush(nullptr);
  std::fputs(text.c_str(), stderr);
  MPI_Abort(world, 1);
  std::abort();
}

/// Rows of all discs, owned or ghost, from the engine's arrays, which would cost a cache line each for every
/// neighbour. Notes how far any disc has moved.
void PairGranDisc::gather() {
  const int count = atom->nlocal + atom->nghost;
  discs_.resize(count);
  loads_.resize(count);
  const auto* x = reinterpret_cast<const Vector3*>(atom->x[0]);
  const auto* v = reinterpret_cast<const Vector3*>(atom->v[0]);
  const auto* omega = reinterpret_cast<const Vector3*>(atom->omega[0]);
  double furthest = 0;
  for (int i = 0; i < count; ++i) {
    const double d_x = x[i][0] - discs_[i].x(), d_y = x[i][1] - discs_[i].y();
    furthest = std::max(furthest, d_x * d_x + d_y * d_y);
    discs_[i] = DiscRow::of(x[i][0], x[i][1], atom->radius[i]);
    discs_[i].set_motion(v[i][0], v[i][1], omega[i][2]);
  }
  moved_ += std::sqrt(furthest);
}

/// Adds the loads of the owned discs to the engine's forces and torques, and leaves none for the next step.
void PairGranDisc::scatter() {
  auto* f = reinterpret_cast<Vector3*>(atom->f[0]);
  auto* torque = reinterpret_cast<Vector3*>(atom->torque[0]);
  const int nlocal = atom->nlocal;
  for (int i = 0; i < nlocal; ++i) {
    f[i][0] += loads_[i].f_x();
    f[i][1] += loads_[i].f_y();
    torque[i][2] += loads_[i].torque(discs_[i].radius());
  }
  std::fill(loads_.begin(), loads_.end(), DiscLoad{});
}

/// Copies the engine's neighbour list, which it has just built, into one flat list of pairs.
template <Effects effects>
void PairGranDisc::flatten(PairGran& pair) {
  const NeighList& list = *pair.list;
  pairs_.clear();
  in_contact_.clear();
  first_pair_.resize(atom->nlocal);
  const std::ptrdiff_t history_size = pair.dnum();
  if constexpr (effects.spring()) flags_ = pair.listgranhistory->firstneigh;
  for (int ii = 0; ii < list.inum; ++ii) {
    const int i = list.ilist[ii];
    first_pair_[i] = static_cast<int>(pairs_.size());
    for (int jj = 0; jj < list.numneigh[i]; ++jj) {
      double* history = nullptr;
      if constexpr (effects.spring()) history = pair.listgranhistory->firstdouble[i] + history_size * jj;
      pairs_.push_back({i, list.firstneigh[i][jj] & NEIGHMASK, history});
      in_contact_.push_back(effects.spring() && flags_[i][jj] != 0);
    }
  }
}

/// Lists the pairs that may touch before the discs have moved by a small part of the skin.
void PairGranDisc::find_near_pairs() {
  near_gap_ = near_fraction * neighbor->skin;
  moved_ = 0;
  near_.clear();
  near_index_.clear();
  touched_.clear();
  const DiscRow* discs = discs_.data();
  for (int index = 0; index < static_cast<int>(pairs_.size()); ++index) {
    const auto& pair = pairs_[index];
    const auto d = discs[pair.j].place + physics::sign_of_place * discs[pair.i].place;
    const double limit = d[2] + near_gap_;
    if (d[0] * d[0] + d[1] * d[1] > limit * limit && !in_contact_[index]) continue;
    near_.push_back(pair);
    near_index_.push_back(index);
    touched_.push_back(in_contact_[index] ? 1.0 : 0.0);
  }
}

/// Of the pairs from `first` on, one batch, those that began to touch get a spring of zero, and those that
/// ceased to lose theirs.
void PairGranDisc::begin_and_end_contacts(ContactBatch& c, std::size_t first, int count, double dt) {
  for (int k = 0; k < count; ++k) {
    if (c.touches(k) == (c.touched[k] != 0)) continue;
    const int index = near_index_[first + k], i = pairs_[index].i;
    touched_[first + k] = c.touches(k) ? 1.0 : 0.0;
    in_contact_[index] = c.touches(k);
    flags_[i][index - first_pair_[i]] = c.touches(k);
    pairs_[index].history[physics::history_xi] = pairs_[index].history[physics::history_slip_rate] = 0;
    physics::begin_or_end_contact(c, k, predicted_, dt);
  }
}

template <Effects effects, bool observed>
void PairGranDisc::loop(PairGran& pair, bool addflag) {
  gather();
  const bool new_pairs = neighbor->ago == 0 || pairs_.empty();
  if (new_pairs) flatten<effects>(pair);
  if (new_pairs || 2 * moved_ > near_gap_) find_near_pairs();
  const bool move_spring = pair.computeflag() && pair.shearupdate();
  const double dt = move_spring ? update->dt : 0.0;
  ContactBatch& c = *batch_;
  for (int k = 0; k < ContactBatch::lanes; ++k) c.set_material(k, parameters_.front());

  for (std::size_t first = 0; first < near_.size(); first += ContactBatch::lanes) {
    const int count = static_cast<int>(std::min<std::size_t>(ContactBatch::lanes, near_.size() - first));
    const BatchOfPairs batch{
        discs_.data(), loads_.data(), &near_[first], &touched_[first], count, predicted_, dt};
    if (!one_material_) set_materials(c, batch.pairs, count);
    const auto state = batch_geometry<effects>(c, batch);
    if (state.any_undefined) stop_at_coincident_centres(c, batch.pairs);
    if (state.any_changed) begin_and_end_contacts(c, first, count, dt);
    batch_forces<effects>(c, batch);
    if (effects.spring() && move_spring) batch_springs(c, batch);
    if constexpr (observed) {
      for (int k = 0; k < count; ++k) {
        if (c.touches(k)) observe(pair, c, k, batch.pairs[k], addflag);
      }
    }
  }
  if (pair.computeflag()) {
    scatter();
  } else {
    std::fill(loads_.begin(), loads_.end(), DiscLoad{});
  }
}

void PairGranDisc::set_materials(ContactBatch& c, const DiscPair* pairs, int count) const {
  const std::size_t types = atom->ntypes;
  for (int k = 0; k < count; ++k) {
    const auto& pair = pairs[k];
    c.set_material(k, parameters_[(atom->type[pair.i] - 1) * types + atom->type[pair.j] - 1]);
  }
}

/// Hands one contact to whoever looks at it: our own record, `compute pair/gran/local`, the virial.
void PairGranDisc::observe(PairGran& pair, const ContactBatch& c, int k, const DiscPair& discs,
                           bool addflag) {
  const int i = discs.i, j = discs.j;
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
    data.contact_history = discs.history;
    force_on_i.delta_F[0] = c.f_x[k];
    force_on_i.delta_F[1] = c.f_y[k];
    force_on_i.delta_torque[2] = discs_[i].radius() * c.f_t[k] - c.short_torque[k];
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
