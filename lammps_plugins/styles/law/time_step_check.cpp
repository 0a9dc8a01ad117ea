// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/time_step_check.h"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "atom.h"
#include "engine/engine_lists.h"
#include "engine/first_rank.h"
#include "error.h"
#include "fix.h"
#include "law/contact_rows.h"
#include "modify.h"
#include "neigh_list.h"
#include "physics/contact/contact_duration.h"
#include "update.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

/// Group bits of the fixes that integrate the equations of motion; all other atoms, such as wall discs, have
/// prescribed motion and count as infinitely heavy in a contact.
int integrated_groups(const Modify& modify) {
  int bits = 0;
  for (const Fix* fix : fixes(modify))
    if (std::strncmp(fix->style, "nve", 3) == 0) bits |= fix->groupbit;
  return bits;
}

/// Per type, over all ranks: mass of the lightest freely moving disc, radius of the largest other disc (0 if
/// none), largest speed.
struct TypesAtHand {
  std::vector<double> mass, radius;  // infinite mass: no freely moving disc
  std::vector<double> carried_radius, speed;
};

void largest_of_all_ranks(std::vector<double>& values, MPI_Comm world) {
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_MAX, world);
}

/// Smooth walls have prescribed motion too. They enter as a disc more than a hundred times larger than the
/// others, whose exact radius does not affect time scales.
void carry_walls(const Modify& modify, std::vector<double>& carried_radius) {
  constexpr double large = 1e3;  // m
  for (const Fix* fix : fixes(modify)) {
    const auto* walls = dynamic_cast<const WallContactSource*>(fix);
    if (!walls) continue;
    for (const WallKind& wall : walls->wall_kinds()) carried_radius[wall.type - 1] = large;
  }
}

TypesAtHand types_at_hand(const Atom& atom, const Modify& modify, MPI_Comm world) {
  const int integrated = integrated_groups(modify);
  const std::vector<double> none(atom.ntypes, 0.0);
  TypesAtHand types{std::vector<double>(atom.ntypes, infinite), none, none, none};
  for (int i = 0; i < atom.nlocal; ++i) {
    const int t = atom.type[i] - 1;
    types.speed[t] = std::max(types.speed[t], std::hypot(atom.v[i][0], atom.v[i][1]));
    if (atom.mask[i] & integrated) {
      types.mass[t] = std::min(types.mass[t], atom.rmass[i]);
    } else {
      types.carried_radius[t] = std::max(types.carried_radius[t], atom.radius[i]);
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, types.mass.data(), atom.ntypes, MPI_DOUBLE, MPI_MIN, world);
  for (int i = 0; i < atom.nlocal; ++i) {
    const int t = atom.type[i] - 1;
    if (atom.rmass[i] == types.mass[t]) types.radius[t] = std::max(types.radius[t], atom.radius[i]);
  }
  carry_walls(modify, types.carried_radius);
  for (auto* values : {&types.radius, &types.carried_radius, &types.speed})
    largest_of_all_ranks(*values, world);
  return types;
}

/// Largest overlap of each pair of types over all ranks [m], 0 if none touch.
std::vector<double> largest_overlaps(const Atom& atom, const NeighList& list, MPI_Comm world) {
  const std::size_t types = atom.ntypes;
  std::vector<double> largest(types * types, 0.0);
  for (int ii = 0; ii < list.inum; ++ii) {
    const int i = list.ilist[ii];
    for (int jj = 0; jj < list.numneigh[i]; ++jj) {
      const int j = list.firstneigh[i][jj] & NEIGHMASK;
      const double distance = std::hypot(atom.x[j][0] - atom.x[i][0], atom.x[j][1] - atom.x[i][1]);
      const double overlap = atom.radius[i] + atom.radius[j] - distance;
      const std::size_t a = atom.type[i] - 1, b = atom.type[j] - 1;
      for (auto* value : {&largest[a * types + b], &largest[b * types + a]})
        *value = std::max(*value, overlap);
    }
  }
  largest_of_all_ranks(largest, world);
  return largest;
}

double duration(const physics::ContactParameters& p, const physics::Effects& effects,
                const physics::Collision& c) {
  physics::ContactParameters used = p;
  if (!effects.spring()) used.tangential_stiffness = 0;
  return physics::with_law(effects.normal, [&](auto law) { return law.duration(used, c); });
}

/// Over all pairs of types that can collide [s]; infinite if nothing moves.
struct ShortestTimes {
  double contact = infinite;                                        // t_c
  double slowing_down = infinite;                                   // m12/gamma_n
  double normal_dashpot = infinite, tangential_dashpot = infinite;  // largest stable time steps
};

void take_dashpots(const physics::ContactParameters& p, const TimeScales& law, double m12,
                   ShortestTimes& shortest) {
  const auto stable = [&](double rate) { return physics::stable_dashpot_step(rate, law.predicted); };
  if (law.effects.normal_dashpot && p.normal_damping > 0) {
    shortest.slowing_down = std::min(shortest.slowing_down, m12 / p.normal_damping);
    shortest.normal_dashpot =
        std::min(shortest.normal_dashpot, stable(physics::normal_dashpot_rate(p.normal_damping, m12)));
  }
  if (physics::has_dashpot(law.effects.tangential) && p.tangential_damping > 0)
    shortest.tangential_dashpot = std::min(
        shortest.tangential_dashpot, stable(physics::tangential_dashpot_rate(p.tangential_damping, m12)));
}

ShortestTimes shortest_times(const TypesAtHand& at_hand, const std::vector<double>& overlaps,
                             const TimeScales& law) {
  const std::size_t types = at_hand.mass.size();
  ShortestTimes shortest;
  for (std::size_t i = 0; i < types; ++i) {
    const double m_i = at_hand.mass[i], a_i = at_hand.radius[i];
    if (!std::isfinite(m_i)) continue;
    for (std::size_t j = 0; j < types; ++j) {
      const auto& p = law.materials.values()[i * types + j];
      const double m_j = at_hand.mass[j], overlap = overlaps[i * types + j];
      const double velocity = std::max(law.impact_velocity, at_hand.speed[i] + at_hand.speed[j]);
      const auto meet = [&](double m12, double a_j) {
        const physics::Collision meeting{m12, physics::reduced_radius(a_i, a_j), velocity, overlap};
        shortest.contact = std::min(shortest.contact, duration(p, law.effects, meeting));
        take_dashpots(p, law, m12, shortest);
      };
      if (std::isfinite(m_j)) meet(physics::reduced_mass(m_i, m_j), at_hand.radius[j]);
      if (at_hand.carried_radius[j] > 0) meet(m_i, at_hand.carried_radius[j]);
    }
  }
  return shortest;
}

bool any_moves(const TypesAtHand& types) {
  return std::any_of(types.mass.begin(), types.mass.end(), [](double m) { return std::isfinite(m); });
}

/// `constant`: name of the dashpot's constant in scripts; `stable`: largest stable time step.
void check_dashpot(LAMMPS& engine, const std::string& style, const std::string& constant, double stable,
                   double accurate) {
  const double dt = engine.update->dt;
  const std::string step = style + ": time step " + text_of(dt) + " s is above ";
  const std::string better =
      "; expected 'timestep " + text_of(accurate) + "' or less, or a smaller " + constant;
  if (dt > stable)
    engine.error->all(FLERR, (step + text_of(stable) + " s, where the dashpots of " + constant +
                              " make a dense packing unstable" + better)
                                 .c_str());
  if (dt > accurate)
    warn(engine, step + text_of(accurate) + " s, to which the dashpots of " + constant +
                     " are accurate (unstable in a dense packing above " + text_of(stable) + " s)" + better);
}

/// The dashpot alone slows a pair down by 1/e in m12/gamma_n.
void check_dashpots(LAMMPS& engine, const std::string& style, const ShortestTimes& times) {
  constexpr double accurate = 0.25, near = 0.75;
  check_dashpot(engine, style, "gamman", times.normal_dashpot,
                std::min(accurate * times.slowing_down, near * times.normal_dashpot));
  check_dashpot(engine, style, "gammat", times.tangential_dashpot, near * times.tangential_dashpot);
}

void check_contact(LAMMPS& engine, const std::string& style, double t_c) {
  const double dt = engine.update->dt;
  const std::string step = style + ": time step " + text_of(dt) + " s is ";
  const std::string contact = " of the shortest contact (t_c = " + text_of(t_c) + " s)";
  const std::string better = "'timestep " + text_of(t_c / physics::steps_per_contact) + "'";
  if (dt > t_c / physics::least_steps_per_contact)
    engine.error->all(FLERR, (step + "above a quarter" + contact +
                              ", the integration would be unstable; expected " + better + " (t_c/50) or less")
                                 .c_str());
  if (dt > t_c / physics::steps_per_contact * (1 + 1e-9))
    warn(engine, step + "above t_c/50" + contact + "; " + better + " would do");
  constexpr double many_steps = 5000;
  if (dt < t_c / many_steps)
    warn(engine, step + "below t_c/5000" + contact + " (was 'timestep' forgotten?); " + better + " would do");
}

}  // namespace

void check_time_step(LAMMPS& engine, const NeighList& list, const std::string& style, const TimeScales& law) {
  const Atom& atom = *engine.atom;
  const auto at_hand = types_at_hand(atom, *engine.modify, engine.world);
  const bool by_velocity = physics::depends_on_velocity(law.effects.normal);
  const std::vector<double> untouched(law.materials.values().size(), 0.0);
  const ShortestTimes times =
      shortest_times(at_hand, by_velocity ? largest_overlaps(atom, list, engine.world) : untouched, law);
  if (std::isfinite(times.contact))
    check_contact(engine, style, times.contact);
  else if (by_velocity && any_moves(at_hand))
    warn(engine, style +
                     ": nothing moves or touches yet, so the contact duration is unknown and the time step "
                     "is not checked; expected 'impact_velocity V' with the pair style");
  check_dashpots(engine, style, times);
}

}  // namespace mikromakro::styles
