// SPDX-License-Identifier: GPL-2.0-or-later
#include "disc_reference.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace mikromakro::bench {

using physics::ContactBatch;
using physics::DiscRow;
using physics::Four;

namespace {

constexpr physics::Effects effects{physics::Tangential::spring, false};

}  // namespace

/// Square cells as wide as the farthest neighbours are apart, row after row.
struct DiscReference::Cells {
  double width, low;
  int per_side;

  explicit Cells(const DiscScene& scene) : low(-scene.box()) {
    double largest = 0;
    for (const auto& disc : scene.discs) largest = std::max(largest, disc.radius);
    width = 2 * largest + scene.skin;
    per_side = static_cast<int>(2 * scene.box() / width) + 1;
  }
  int along(double x) const { return static_cast<int>((x - low) / width); }
  int of(double x, double y) const { return along(y) * per_side + along(x); }
};

DiscReference::DiscReference(const DiscScene& scene) : scene_(scene) {
  for (int k = 0; k < 2; ++k) {
    const double radius = k == 0 ? scene.r_inner : scene.r_outer;
    rings_[k].course = {radius, radius, 0};
    rings_[k].rotation_rate = k == 0 ? scene.omega : 0.0;
  }
  const Cells cells(scene);
  std::stable_sort(scene_.discs.begin(), scene_.discs.end(),
                   [&](const auto& a, const auto& b) { return cells.of(a.x, a.y) < cells.of(b.x, b.y); });
  for (const auto& disc : scene_.discs) add(disc);
  loads_.resize(discs_.size());
  for (int k = 0; k < ContactBatch::lanes; ++k) batch_.set_material(k, scene.material);
  near_gap_ = physics::inner_gap(0, scene.skin);
  build_pairs();
  find_near_pairs();
  evaluate_contacts(0);
}

void DiscReference::add(const test::Disc& disc) {
  const int number = static_cast<int>(discs_.size());
  discs_.push_back(DiscRow::of(disc.x, disc.y, disc.radius));
  discs_.back().set_motion(disc.v_x, disc.v_y, disc.omega);
  half_step_.push_back(Four{disc.v_x, disc.v_y, disc.omega, 0});
  kick_.push_back(Four{0, 0, 0, 0});
  if (disc.type < type_of_wheel) {
    const double area = std::numbers::pi * disc.radius * disc.radius;
    const double kick = scene_.time_step / 2 / (scene_.density * area);
    kick_.back() = Four{kick, kick, 2 * kick / (disc.radius * disc.radius), 0};
    free_.push_back(number);
  } else {
    const int ring = disc.type == type_of_wheel ? 0 : 1;
    walls_.push_back({number, ring, physics::reference_direction(rings_[ring].at(0), {disc.x, disc.y})});
    const auto state = physics::wall_disc_state(rings_[ring].at(0), walls_.back().reference);
    discs_.back().set_motion(state.velocity.x, state.velocity.y, rings_[ring].rotation_rate);
  }
}

void DiscReference::run(int steps) {
  for (int k = 0; k < steps; ++k) {
    move_discs(step_ == 0 ? 1 : 2);
    ++step_;
    move_walls(static_cast<double>(step_) * scene_.time_step);
    update_pairs();
    evaluate_contacts(scene_.time_step);
  }
}

Four DiscReference::force(int i) const {
  const auto& load = loads_[i];
  return Four{load.f_x(), load.f_y(), load.torque(discs_[i].radius()), 0};
}

/// Velocity Verlet: the final half kick of the last step, the first one of this, and the velocity predicted
/// for its end.
void DiscReference::move_discs(int kicks) {
  const double dt = scene_.time_step;
  const Four in_the_plane = {dt, dt, 0, 0};
  double fastest = 0;
  for (const int i : free_) {
    const Four dv = kick_[i] * force(i);
    Four half = half_step_[i] + dv;
    if (kicks == 2) half += dv;
    half_step_[i] = half;
    fastest = std::max(fastest, half[0] * half[0] + half[1] * half[1]);
    discs_[i].place += in_the_plane * half;
    const Four now = half + dv;
    discs_[i].set_motion(now[0], now[1], now[2]);
    loads_[i] = {};
  }
  moved_ += std::max(std::sqrt(fastest), std::abs(scene_.omega) * scene_.r_inner) * dt;
}

void DiscReference::move_walls(double time) {
  const physics::RingState states[2] = {rings_[0].at(time), rings_[1].at(time)};
  for (const auto& wall : walls_) {
    const auto state = physics::wall_disc_state(states[wall.ring], wall.reference);
    discs_[wall.disc].move_to(state.position.x, state.position.y);
    discs_[wall.disc].set_motion(state.velocity.x, state.velocity.y, rings_[wall.ring].rotation_rate);
    loads_[wall.disc] = {};
  }
}

void DiscReference::update_pairs() {
  ++steps_of_near_;
  if (2 * moved_ <= near_gap_) return;
  put_springs_away();
  near_gap_ = std::min(physics::inner_gap(moved_ / steps_of_near_, scene_.skin), scene_.skin / 2);
  if (moved_too_far()) build_pairs();
  find_near_pairs();
}

/// Whether pairs that are not in the neighbour list could meet before the next look at it.
bool DiscReference::moved_too_far() const {
  const double limit = (scene_.skin - near_gap_) / 2;
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    const double d_x = discs_[i].x() - built_at_[i].x, d_y = discs_[i].y() - built_at_[i].y;
    if (d_x * d_x + d_y * d_y > limit * limit) return true;
  }
  return false;
}

/// Pairs (i, j) with i < j, sorted; springs go with their pairs.
void DiscReference::build_pairs() {
  const Cells cells(scene_);
  std::vector<int> first(cells.per_side * cells.per_side + 1), order(discs_.size());
  for (const auto& d : discs_) ++first[cells.of(d.x(), d.y()) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  auto next = first;
  for (int i = 0; i < static_cast<int>(discs_.size()); ++i)
    order[next[cells.of(discs_[i].x(), discs_[i].y())]++] = i;

  const auto old_pairs = std::move(pairs_);
  const auto old_springs = std::move(springs_);
  const auto old_contacts = std::move(in_contact_);
  pairs_ = {}, springs_ = {}, in_contact_ = {};
  std::size_t old = 0;
  std::vector<int> partners;
  for (int i = 0; i < static_cast<int>(discs_.size()); ++i) {
    partners.clear();
    const int column = cells.along(discs_[i].x()), row = cells.along(discs_[i].y());
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, cells.per_side - 1); ++r) {
      const int from = first[r * cells.per_side + std::max(column - 1, 0)];
      const int to = first[r * cells.per_side + std::min(column + 1, cells.per_side - 1) + 1];
      for (int k = from; k < to; ++k) {
        const int j = order[k];
        if (j <= i || (kick_[i][0] == 0 && kick_[j][0] == 0)) continue;
        const Four d = discs_[j].place + physics::sign_of_place * discs_[i].place;
        const double reach = d[2] + scene_.skin;
        if (d[0] * d[0] + d[1] * d[1] < reach * reach) partners.push_back(j);
      }
    }
    std::sort(partners.begin(), partners.end());
    for (const int j : partners) {
      while (old < old_pairs.size() && std::pair(old_pairs[old].i, old_pairs[old].j) < std::pair(i, j)) ++old;
      const bool known = old < old_pairs.size() && old_pairs[old].i == i && old_pairs[old].j == j;
      pairs_.push_back({i, j});
      springs_.push_back(known ? old_springs[old] : Spring{});
      in_contact_.push_back(known && old_contacts[old]);
    }
  }
  built_at_.clear();
  for (const auto& d : discs_) built_at_.push_back({d.x(), d.y()});
  ++builds_;
}

/// Pairs that may touch before the discs have moved by a small part of the skin. Springs wait in springs_.
void DiscReference::find_near_pairs() {
  moved_ = 0;
  steps_of_near_ = 0;
  near_.prune(pairs_, discs_.data(), in_contact_, near_gap_,
              physics::rows_exceed_cache(discs_.size()) ? ContactBatch::lanes : 0);
  for (int k = 0; k < near_.size(); ++k) {
    const int number = near_.number(k);
    near_.set_spring(k, in_contact_[number] != 0, springs_[number].xi, springs_[number].slip_rate);
  }
}

void DiscReference::put_springs_away() {
  for (int k = 0; k < near_.size(); ++k) springs_[near_.number(k)] = {near_.xi(k), near_.slip_rate(k)};
}

void DiscReference::begin_and_end_contacts(int first, int count, double dt) {
  for (int k = 0; k < count; ++k) {
    const bool touches = batch_.touches(k);
    if (touches == (batch_.springs->touched[k] != 0)) continue;
    in_contact_[near_.number(first + k)] = touches;
    physics::begin_or_end_contact(batch_, k, {dt, true});
    near_.set_spring(first + k, touches, 0, batch_.springs->slip_rate[k]);
  }
}

/// dt = 0: forces of the first instant, no spring is stretched.
void DiscReference::evaluate_contacts(double dt) {
  auto& c = batch_;
  physics::SpringLanes unmoved;
  for (int first = 0; first < near_.size(); first += ContactBatch::lanes) {
    const int count = std::min(ContactBatch::lanes, near_.size() - first);
    const auto* pairs = near_.from(first);
    const int ahead =
        physics::rows_exceed_cache(discs_.size()) ? std::min(count, near_.size() - first - count) : 0;
    c.springs = &near_.springs(first);
    if (dt == 0) c.springs = &(unmoved = *c.springs);
    near_.prefetch_springs(first + count, ahead);
    physics::load_discs<effects>(c, discs_.data(), pairs, count, loads_.data(), ahead);
    const auto state = physics::contact_geometry<effects>(c, count);
    physics::contact_slip(c, count, {dt, true});
    if (state.any_changed) begin_and_end_contacts(first, count, dt);
    physics::contact_forces<effects>(c, count);
    physics::add_loads<effects>(c, pairs, count, loads_.data());
  }
}

double DiscReference::kinetic_energy() const {
  double energy = 0;
  for (const int i : free_) {
    const Four v = half_step_[i] + (step_ == 0 ? 0.0 : 1.0) * (kick_[i] * force(i));
    const double m = scene_.time_step / 2 / kick_[i][0], inertia = scene_.time_step / 2 / kick_[i][2];
    energy += (m * (v[0] * v[0] + v[1] * v[1]) + inertia * v[2] * v[2]) / 2;
  }
  return energy;
}

std::size_t DiscReference::contacts() const {
  return std::count(in_contact_.begin(), in_contact_.end(), 1);
}

}  // namespace mikromakro::bench
