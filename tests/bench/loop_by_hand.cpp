// SPDX-License-Identifier: GPL-2.0-or-later
#include "loop_by_hand.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "atom.h"
#include "contact_models.h"
#include "engine/processor_clones.h"
#include "fix_property_global.h"
#include "granular_pair_style.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair_gran.h"
#include "physics/rows/disc_rows.h"
#include "pointers.h"
#include "update.h"

namespace mikromakro::bench {
namespace {

using namespace LAMMPS_NS;
using physics::Four;

constexpr int model_id = 40, lanes = 64;

struct Pair {
  int i, j;
};
struct alignas(64) Row {
  Four place;     // x, y, radius, 0
  Four velocity;  // v_x, v_y, 0, 0
};
struct alignas(32) Load {
  Four force{0, 0, 0, 0};  // f_x, f_y, 0, 0
};
struct alignas(64) Columns {
  double d_x[lanes], d_y[lanes], reach[lanes], w_x[lanes], w_y[lanes], f_x[lanes], f_y[lanes];
};

constexpr Four from_1_to_2 = {-1, -1, 1, 1};

FOR_EACH_PROCESSOR void load(Columns& c, const Row* rows, const Pair* pairs, int count) {
  for (int k = 0; k < count; k += 4) {
    Four d[4], w[4];
    for (int m = 0; m < 4; ++m) {
      const Pair& pair = pairs[std::min(k + m, count - 1)];
      d[m] = rows[pair.j].place + from_1_to_2 * rows[pair.i].place;
      w[m] = rows[pair.i].velocity - rows[pair.j].velocity;
    }
    physics::transpose(d[0], d[1], d[2], d[3]);
    physics::transpose(w[0], w[1], w[2], w[3]);
    __builtin_memcpy(c.d_x + k, &d[0], sizeof(Four));
    __builtin_memcpy(c.d_y + k, &d[1], sizeof(Four));
    __builtin_memcpy(c.reach + k, &d[2], sizeof(Four));
    __builtin_memcpy(c.w_x + k, &w[0], sizeof(Four));
    __builtin_memcpy(c.w_y + k, &w[1], sizeof(Four));
  }
}

FOR_EACH_PROCESSOR void evaluate(Columns& c, int count, double k_n, double gamma_n) {
  const int all = (count + 7) / 8 * 8;
  for (int k = 0; k < all; ++k) {
    const double distance = std::sqrt(c.d_x[k] * c.d_x[k] + c.d_y[k] * c.d_y[k]);
    const double inverse = 1 / distance;
    const double n_x = c.d_x[k] * inverse, n_y = c.d_y[k] * inverse;
    const double overlap = c.reach[k] - distance;
    const double f = k_n * overlap + gamma_n * (c.w_x[k] * n_x + c.w_y[k] * n_y);
    const double f_n = overlap > 0 ? f : 0.0;
    c.f_x[k] = -f_n * n_x;
    c.f_y[k] = -f_n * n_y;
  }
}

FOR_EACH_PROCESSOR void add(const Columns& c, const Pair* pairs, int count, Load* loads) {
  for (int k = 0; k < count; k += 4) {
    Four f[4] = {};
    __builtin_memcpy(&f[0], c.f_x + k, sizeof(Four));
    __builtin_memcpy(&f[1], c.f_y + k, sizeof(Four));
    physics::transpose(f[0], f[1], f[2], f[3]);
    for (int m = 0; m < 4 && k + m < count; ++m) {
      loads[pairs[k + m].i].force += f[m];
      loads[pairs[k + m].j].force -= f[m];
    }
  }
}

class LoopByHand : public LIGGGHTS::PairStyles::IGranularPairStyle, protected Pointers {
 public:
  LoopByHand(LAMMPS* engine, std::int64_t hash) : Pointers(engine), hash_(hash) {}

  void settings(int, char**, LIGGGHTS::IContactHistorySetup*) override {}
  void init_granular() override {
    k_n_ = constant("kn");
    gamma_n_ = constant("gamman_abs");
  }
  void write_restart_settings(FILE*) override {}
  void read_restart_settings(FILE*, std::int64_t) override {}
  int get_history_offset(const std::string) override { return -1; }
  double stressStrainExponent() override { return 1; }
  std::int64_t hashcode() override { return hash_; }
  bool contact_match(const std::string, const std::string) override { return true; }

  void compute_force(PairGran* pair, int, int, int) override {
    pair->evflag = pair->vflag_fdotr = 0;
    gather();
    if (neighbor->ago == 0 || pairs_.empty()) flatten(*pair->list);
    if (neighbor->ago == 0 || 2 * moved_ > near_gap_) find_near_pairs();
    for (std::size_t first = 0; first < near_.size(); first += lanes) {
      const int count = static_cast<int>(std::min<std::size_t>(lanes, near_.size() - first));
      load(columns_, rows_.data(), &near_[first], count);
      evaluate(columns_, count, k_n_, gamma_n_);
      add(columns_, &near_[first], count, loads_.data());
    }
    for (int i = 0; i < atom->nlocal; ++i) {
      atom->f[i][0] += loads_[i].force[0];
      atom->f[i][1] += loads_[i].force[1];
    }
    std::fill(loads_.begin(), loads_.end(), Load{});
  }

 private:
  double constant(const char* name) {
    auto* fix = modify->find_fix_property(name, "property/global", "peratomtypepair", atom->ntypes,
                                          atom->ntypes, "bench/by_hand");
    return static_cast<FixPropertyGlobal*>(fix)->compute_array(0, 0);
  }
  void gather() {
    const std::size_t count = atom->nlocal + atom->nghost;
    rows_.resize(count);
    loads_.resize(count);
    double furthest = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double *x = atom->x[i], *v = atom->v[i];
      const double d_x = x[0] - rows_[i].place[0], d_y = x[1] - rows_[i].place[1];
      furthest = std::max(furthest, d_x * d_x + d_y * d_y);
      rows_[i] = {Four{x[0], x[1], atom->radius[i], 0}, Four{v[0], v[1], 0, 0}};
    }
    moved_ += std::sqrt(furthest);
    ++steps_;
  }
  void flatten(const NeighList& list) {
    pairs_.clear();
    for (int ii = 0; ii < list.inum; ++ii) {
      const int i = list.ilist[ii];
      for (int jj = 0; jj < list.numneigh[i]; ++jj) pairs_.push_back({i, list.firstneigh[i][jj] & NEIGHMASK});
    }
  }
  void find_near_pairs() {
    near_.clear();
    const double skin = neighbor->skin;
    if (neighbor->ago != 0) path_ = moved_ / steps_;  // else discs have got other numbers
    near_gap_ = std::clamp(std::cbrt(23.5 * path_ * path_ * skin), skin / 100, skin);
    moved_ = 0;
    steps_ = 0;
    for (const auto& pair : pairs_) {
      const Four d = rows_[pair.j].place + from_1_to_2 * rows_[pair.i].place;
      const double limit = d[2] + near_gap_;
      if (d[0] * d[0] + d[1] * d[1] <= limit * limit) near_.push_back(pair);
    }
  }

  std::int64_t hash_;
  double k_n_ = 0, gamma_n_ = 0, near_gap_ = 0, moved_ = 0, path_ = 0;
  int steps_ = 0;
  std::vector<Row> rows_;
  std::vector<Load> loads_;
  std::vector<Pair> pairs_, near_;
  Columns columns_{};
};

LIGGGHTS::PairStyles::IGranularPairStyle* create(LAMMPS* engine, PairGran*, std::int64_t hash) {
  return new LoopByHand(engine, hash);
}

}  // namespace

void register_loop_by_hand() {
  namespace models = LIGGGHTS::ContactModels;
  models::Factory::instance().addNormalModel("bench/by_hand", model_id);
  const auto hash = LIGGGHTS::Utils::generate_gran_hashcode(
      model_id, models::TANGENTIAL_OFF, models::COHESION_OFF, models::ROLLING_OFF, models::SURFACE_DEFAULT);
  LIGGGHTS::PairStyles::Factory::instance().addStyle("gran", static_cast<int>(hash), create);
}

}  // namespace mikromakro::bench
