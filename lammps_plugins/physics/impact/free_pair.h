// SPDX-License-Identifier: GPL-2.0-or-later
// Collision of two free discs: contact law and time integration of fix nve/disc without an engine, to measure
// the time-step error.
#pragma once

#include <array>
#include <cmath>

#include "physics/walls/smooth_wall.h"

namespace mikromakro::physics {

/// Which velocities enter the contact law, and how contact onset and release within a step are treated.
enum class Scheme {
  half_step,      // mid-step velocities, as from the stock integrators
  same_instant,   // velocities predicted for the time of the positions
  share_of_step,  // as same_instant, with force_of_step()
};

template <Effects effects>
class FreePair {
 public:
  struct Disc : MovingDisc {
    double mass;  // kg
  };

  FreePair(const ContactParameters& parameters, const std::array<Disc, 2>& discs, double dt, Scheme scheme)
      : parameters_(parameters), discs_(discs), dt_(dt), scheme_(scheme) {}

  /// One velocity Verlet step, as in fix nve/disc.
  void step() {
    kick();
    for (auto& disc : discs_) {
      disc.position.x += dt_ * disc.velocity.x;
      disc.position.y += dt_ * disc.velocity.y;
    }
    const auto half_step = discs_;
    if (scheme_ != Scheme::half_step) kick();
    const ContactState seen = state();
    evaluate(seen);
    for (int k = 0; k < 2; ++k) {
      discs_[k].velocity = half_step[k].velocity;
      discs_[k].spin = half_step[k].spin;
    }
    kick();
  }

  const std::array<Disc, 2>& discs() const { return discs_; }
  const WallSpring& spring() const { return spring_; }

  /// Current overlap and relative velocities.
  ContactState state() const {
    const auto& [one, two] = discs_;
    const auto [n, distance] = normal();
    const double w_x = one.velocity.x - two.velocity.x, w_y = one.velocity.y - two.velocity.y;
    const double overlap = one.radius + two.radius - distance;
    const double rolling = one.spin * (one.radius - overlap / 2) + two.spin * (two.radius - overlap / 2);
    return {overlap, w_x * n.x + w_y * n.y, w_y * n.x - w_x * n.y + rolling, spring_.xi,
            reduced_radius(one.radius, two.radius)};
  }

  /// Kinetic energy of both discs, without elastic energy [J].
  double kinetic_energy() const {
    double sum = 0;
    for (const auto& d : discs_) {
      const double rim = d.radius * d.spin;
      sum += d.mass / 2 * (d.velocity.x * d.velocity.x + d.velocity.y * d.velocity.y + rim * rim / 2);
    }
    return sum;
  }

 private:
  struct Normal {
    PlaneVector n;
    double distance;
  };

  Normal normal() const {
    const auto& [one, two] = discs_;
    const double d_x = two.position.x - one.position.x, d_y = two.position.y - one.position.y;
    const double distance = std::hypot(d_x, d_y);
    return {{d_x / distance, d_y / distance}, distance};
  }

  void kick() {
    for (int k = 0; k < 2; ++k) {
      const double of_mass = dt_ / 2 / discs_[k].mass, sign = k == 0 ? 1 : -1;
      discs_[k].velocity.x += sign * of_mass * force_.x;
      discs_[k].velocity.y += sign * of_mass * force_.y;
      // The torque c_i f_t has the same sign on both discs; moment of inertia m a^2 / 2.
      const double radius = discs_[k].radius;
      discs_[k].spin += 2 * of_mass / (radius * radius) * (radius - short_arm_) * f_t_;
    }
  }

  void evaluate(const ContactState& seen) {
    if (seen.overlap <= 0) {
      spring_ = {};
      force_ = {};
      f_t_ = 0;
      return;
    }
    const StepOfSlip step{dt_, scheme_ != Scheme::half_step};
    ContactForce force = wall_contact_force<effects>(parameters_, seen, step, spring_);
    const double frequency = frequency_of_steps(scheme_ == Scheme::share_of_step, dt_);
    force = force_of_step<effects>(parameters_, seen, force, frequency);
    const auto [n, distance] = normal();
    force_ = {-force.f_n * n.x - force.f_t * n.y, -force.f_n * n.y + force.f_t * n.x};
    f_t_ = force.f_t;
    short_arm_ = seen.overlap / 2;
  }

  ContactParameters parameters_;
  std::array<Disc, 2> discs_;
  double dt_;
  Scheme scheme_;
  WallSpring spring_;
  PlaneVector force_;  // on the first disc
  double f_t_ = 0, short_arm_ = 0;
};

}  // namespace mikromakro::physics
