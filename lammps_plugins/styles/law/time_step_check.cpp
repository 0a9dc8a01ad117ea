// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/time_step_check.h"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>

#include "atom.h"
#include "engine/engine_lists.h"
#include "engine/first_rank.h"
#include "error.h"
#include "fix.h"
#include "law/contact_rows.h"
#include "law/damped_contacts.h"
#include "law/moving_atoms.h"
#include "modify.h"
#include "neigh_list.h"
#include "physics/contact/contact_duration.h"
#include "update.h"

namespace mikromakro::styles {

using namespace LAMMPS_NS;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// Of time steps that messages recommend with four digits.
constexpr double rounded = 1e-3;

std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
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

TypesAtHand types_at_hand(const Atom& atom, const Modify& modify, const MovingAtoms& moving, MPI_Comm world) {
  const std::vector<double> none(atom.ntypes, 0.0);
  TypesAtHand types{std::vector<double>(atom.ntypes, infinite), none, none, none};
  for (int i = 0; i < atom.nlocal; ++i) {
    const int t = atom.type[i] - 1;
    types.speed[t] = std::max(types.speed[t], std::hypot(atom.v[i][0], atom.v[i][1]));
    if (moving.include(atom, i)) {
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
  double contact = infinite;  // t_c
  // Those in which a dashpot slows a pair down by 1/e.
  double normal_dashpot = infinite, tangential_dashpot = infinite;
};

void take_dashpots(const physics::ContactParameters& p, const physics::Effects& effects, double m12,
                   ShortestTimes& shortest) {
  if (effects.normal_dashpot && p.normal_damping > 0)
    shortest.normal_dashpot =
        std::min(shortest.normal_dashpot, 1 / physics::normal_dashpot_rate(p.normal_damping, m12));
  if (physics::has_dashpot(effects.tangential) && p.tangential_damping > 0 && p.friction > 0)
    shortest.tangential_dashpot = std::min(shortest.tangential_dashpot,
                                           1 / physics::tangential_dashpot_rate(p.tangential_damping, m12));
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
        take_dashpots(p, law.effects, m12, shortest);
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

bool has_bodies(const Modify& modify) {
  const auto all = fixes(modify);
  return std::any_of(all.begin(), all.end(),
                     [](const Fix* fix) { return std::string_view(fix->style).starts_with("rigid"); });
}

/// The words for a time step that is above another one.
std::string above(const LAMMPS& engine, const std::string& style, double bound) {
  return style + ": time step " + text_of(engine.update->dt) + " s is above " + text_of(bound) + " s, ";
}

/// A pair whose dashpots slow it down in these times is unstable by itself. Friction limits what that of
/// gammat does: an error only of contacts that do not slide.
void check_pair(LAMMPS& engine, const std::string& style, const ShortestTimes& times, bool predicted,
                Told& told) {
  constexpr double accurate = 0.25;
  const double stable_n = physics::stable_dashpot_step(1 / times.normal_dashpot, predicted),
               stable_t = physics::stable_dashpot_step(1 / times.tangential_dashpot, predicted);
  if (engine.update->dt > stable_n)
    engine.error->all(FLERR, (above(engine, style, stable_n) +
                              "where the dashpot of gamman is unstable; expected 'timestep " +
                              text_of(accurate * times.normal_dashpot) + "' or less, or a smaller gamman")
                                 .c_str());
  if (engine.update->dt > stable_t && told.insert("gammat").second)
    warn(engine, above(engine, style, stable_t) +
                     "where the dashpot of gammat is unstable: contacts that should come to rest chatter "
                     "between the limits of friction; expected 'timestep " +
                     text_of(accurate * times.tangential_dashpot) + "' or less, or a smaller gammat");
}

/// e_n of a pair, in m12/gamma_n. That of gammat matters only where discs do not slide.
void check_accuracy(LAMMPS& engine, const std::string& style, double time, Told& told) {
  constexpr double accurate = 0.25;
  if (engine.update->dt > accurate * time * (1 + rounded) && told.insert("gamman").second)
    warn(engine, above(engine, style, accurate * time) +
                     "a quarter of the shortest time in which a dashpot of gamman acts; expected 'timestep " +
                     text_of(accurate * time) + "' or less, or a smaller gamman");
}

/// Of all present contacts [s].
struct StableSteps {
  double normal = infinite, all = infinite;  // of the dashpots of gamman, and of both
};

/// Infinite where a bound of their rates shows that they do not matter. Collective.
StableSteps stable_steps_of_contacts(LAMMPS& engine, const NeighList& list, const TimeScales& law) {
  constexpr double safe_part = 0.75;
  const double safe = safe_part * physics::stable_dashpot_step(1, law.predicted) / engine.update->dt;
  physics::Effects normal = law.effects;
  normal.tangential = physics::Tangential::none;
  const MovingAtoms moving(*engine.modify, law.held);
  const auto rate = [&](const physics::Effects& effects) {
    return largest_dashpot_rate(engine, list, moving, effects, law.materials, safe);
  };
  const double of_normal = rate(normal);
  double rates[] = {of_normal, physics::has_dashpot(law.effects.tangential) ? rate(law.effects) : of_normal};
  MPI_Allreduce(MPI_IN_PLACE, rates, 2, MPI_DOUBLE, MPI_MAX, engine.world);
  return {physics::stable_dashpot_step(rates[0], law.predicted),
          physics::stable_dashpot_step(rates[1], law.predicted)};
}

std::string smaller_step(double time_step) {
  return "; expected 'timestep " + text_of(time_step) + "' or less, or a smaller gamman or gammat";
}

/// The present contacts together.
void check_packing(LAMMPS& engine, const std::string& style, const StableSteps& stable, Told& told) {
  constexpr double near = 0.75;
  const double dt = engine.update->dt;
  if (dt > stable.normal)
    engine.error->all(FLERR, (above(engine, style, stable.normal) +
                              "where the dashpots of the present contacts make the integration unstable" +
                              smaller_step(near * stable.normal))
                                 .c_str());
  if (dt > near * stable.all * (1 + rounded) && told.insert("packing").second)
    warn(engine, above(engine, style, near * stable.all) + "near that of " + text_of(stable.all) +
                     " s at which dashpots make the integration unstable" + smaller_step(near * stable.all));
}

void check_contact(LAMMPS& engine, const std::string& style, double t_c, Told& told) {
  const double dt = engine.update->dt;
  const std::string step = style + ": time step " + text_of(dt) + " s is ";
  const std::string contact = " of the shortest contact (t_c = " + text_of(t_c) + " s)";
  const std::string better = "'timestep " + text_of(t_c / physics::steps_per_contact) + "'";
  if (dt > t_c / physics::least_steps_per_contact)
    engine.error->all(FLERR, (step + "above a quarter" + contact +
                              ", the integration would be unstable; expected " + better + " (t_c/50) or less")
                                 .c_str());
  if (dt > t_c / physics::steps_per_contact * (1 + rounded) && told.insert("long").second)
    warn(engine, step + "above t_c/50" + contact + "; " + better + " would do");
  constexpr double many_steps = 5000;
  if (dt < t_c / many_steps && told.insert("short").second)
    warn(engine, step + "below t_c/5000" + contact + " (was 'timestep' forgotten?); " + better + " would do");
}

}  // namespace

namespace {

ShortestTimes times_of(LAMMPS& engine, const NeighList& list, const TimeScales& law,
                       const TypesAtHand& at_hand) {
  const std::vector<double> untouched(law.materials.values().size(), 0.0);
  const bool by_velocity = physics::depends_on_velocity(law.effects.normal);
  return shortest_times(at_hand, by_velocity ? largest_overlaps(*engine.atom, list, engine.world) : untouched,
                        law);
}

}  // namespace

void check_time_step(LAMMPS& engine, const NeighList& list, const std::string& style, const TimeScales& law,
                     Told& told) {
  const MovingAtoms moving(*engine.modify, law.held);
  const auto at_hand = types_at_hand(*engine.atom, *engine.modify, moving, engine.world);
  const ShortestTimes times = times_of(engine, list, law, at_hand);
  if (std::isfinite(times.contact))
    check_contact(engine, style, times.contact, told);
  else if (physics::depends_on_velocity(law.effects.normal) && any_moves(at_hand) &&
           told.insert("unknown").second)
    warn(engine, style +
                     ": nothing moves or touches yet, so the contact duration is unknown and the time step "
                     "is not checked; expected 'impact_velocity V' with the pair style");
  else if (!any_moves(at_hand) && has_bodies(*engine.modify) && told.insert("bodies").second)
    warn(engine, style + ": only the bodies of 'fix rigid' move; the time step is not checked for them");
  constexpr int minimisation = 2;
  if (engine.update->whichflag == minimisation) return;
  check_pair(engine, style, times, law.predicted, told);
  check_accuracy(engine, style, times.normal_dashpot, told);
  check_packing(engine, style, stable_steps_of_contacts(engine, list, law), told);
}

void check_time_step_of_run(LAMMPS& engine, const NeighList& list, const std::string& style,
                            const TimeScales& law) {
  const double stable = stable_steps_of_contacts(engine, list, law).all;
  if (engine.update->dt > stable)
    warn(engine,
         above(engine, style, stable) +
             "where the dashpots of the contacts at the end of the run make the integration unstable: "
             "its results are wrong" +
             smaller_step(stable / 2));
}

}  // namespace mikromakro::styles
