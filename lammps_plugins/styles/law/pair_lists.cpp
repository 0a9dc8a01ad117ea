// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/pair_lists.h"

#include <algorithm>

#include "engine/processor_clones.h"
#include "neigh_list.h"

namespace mikromakro::styles {

using physics::ContactBatch;
using physics::DiscPair;
using physics::DiscRow;

namespace {

FOR_EACH_PROCESSOR void prune_pairs(physics::InnerList& near, const std::vector<DiscPair>& all,
                                    const DiscRow* discs, const std::vector<char>& touched, double gap,
                                    std::size_t ahead) {
  near.prune(all, discs, touched, gap, ahead);
}

}  // namespace

void PairLists::rebuild(const LAMMPS_NS::NeighList& list, int nlocal, const ContactHistory* history) {
  built_ = sorted_ = true;
  pairs_.clear();
  histories_.clear();
  in_contact_.clear();
  first_pair_.resize(nlocal);
  flags_ = history ? history->touching : nullptr;
  for (int ii = 0; ii < list.inum; ++ii) {
    const int i = list.ilist[ii];
    first_pair_[i] = static_cast<int>(pairs_.size());
    sorted_ = sorted_ && i == ii;
    for (int jj = 0; jj < list.numneigh[i]; ++jj) {
      pairs_.push_back({i, list.firstneigh[i][jj] & NEIGHMASK});
      sorted_ = sorted_ && pairs_.back().j > i;
      if (!history) continue;
      histories_.push_back(history->values[i] + static_cast<std::ptrdiff_t>(history->stride) * jj);
      in_contact_.push_back(history->touching[i][jj] != 0);
    }
  }
}

void PairLists::prune(const std::vector<DiscRow>& discs, double gap, bool prefetch) {
  write_history();
  prune_pairs(inner_, pairs_, discs.data(), in_contact_, gap, prefetch ? ContactBatch::lanes : 0);
  if (histories_.empty()) return;
  for (int k = 0; k < inner_.size(); ++k) {
    const int number = inner_.number(k);
    const double* history = histories_[number];
    inner_.set_spring(k, in_contact_[number] != 0, history[history_xi], history[history_slip_rate]);
  }
}

std::size_t PairLists::contacts(const std::vector<DiscRow>& discs) const {
  return std::count_if(pairs_.begin(), pairs_.end(), [&](const DiscPair& pair) {
    return physics::are_near(discs[pair.i], discs[pair.j], 0);
  });
}

void PairLists::change_contact(int k, bool touches, double slip_rate) {
  const int number = inner_.number(k), i = pairs_[number].i;
  in_contact_[number] = touches;
  flags_[i][number - first_pair_[i]] = touches;
  inner_.set_spring(k, touches, 0, slip_rate);
  histories_[number][history_xi] = 0;
  histories_[number][history_slip_rate] = slip_rate;
}

void PairLists::write_history() {
  if (!history_is_behind_) return;
  for (int k = 0; k < inner_.size(); ++k) {
    double* history = histories_[inner_.number(k)];
    history[history_xi] = inner_.xi(k);
    history[history_slip_rate] = inner_.slip_rate(k);
  }
  history_is_behind_ = false;
}

std::size_t PairLists::bytes() const {
  return pairs_.size() * sizeof(DiscPair) + histories_.size() * sizeof(double*) + in_contact_.size() +
         inner_.bytes();
}

std::size_t PairLists::bytes_in_engine() const {
  return histories_.size() * (2 * sizeof(double) + sizeof(int));
}

}  // namespace mikromakro::styles
