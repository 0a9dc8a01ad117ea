// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/commands.h"
#include "io/tables/json.h"
#include "model/error.h"
#include "physics/contact/contact_duration.h"
#include "physics/impact/impact.h"
#include "verbs/warnings.h"

namespace mikromakro {
namespace {

struct TimestepOptions {
  double radius = std::nan(""), density = std::nan("");
  double kn = std::nan(""), gamman = std::nan(""), restitution = std::nan("");
  double kt = std::nan(""), gammat = 0, mu = std::nan("");
  double velocity = std::nan(""), error = std::nan("");
  bool hertz = false, json = false;
};

void require(bool holds, std::string_view option, std::string_view expected, double got) {
  if (!holds) throw bad_input({option}, "invalid value", expected, fmt::format("{}", got));
}

// Without friction there is no tangential force.
void require_friction(bool given, std::string_view option, const TimestepOptions& o) {
  if (given && !(o.mu > 0))
    throw bad_input({option}, "without friction it has no effect", "--mu above 0",
                    std::isnan(o.mu) ? "none" : fmt::format("{}", o.mu));
}

void check(const TimestepOptions& o) {
  require(o.radius > 0, "--radius", "a length above 0 (m)", o.radius);
  require(o.density > 0, "--density", "an areal density rho h above 0 (kg/m^2)", o.density);
  constexpr double metals = 20000, highest = 5;  // kg/m^3, diameters
  if (o.density > metals * highest * 2 * o.radius)
    tell(
        fmt::format("--density {}: heavier than metal discs five diameters thick (it is the areal density, "
                    "rho h, in kg/m^2)",
                    o.density));
  require(o.kn > 0, "--kn", "a stiffness above 0", o.kn);
  require(std::isnan(o.gamman) || o.gamman >= 0, "--gamman", "a number >= 0 (kg/s)", o.gamman);
  require(std::isnan(o.restitution) || (o.restitution > 0 && o.restitution <= 1), "--restitution",
          "a number above 0, at most 1", o.restitution);
  require(std::isnan(o.kt) || o.kt > 0, "--kt", "a stiffness above 0 (N/m)", o.kt);
  require_friction(!std::isnan(o.kt), "--kt", o);
  require_friction(o.gammat > 0, "--gammat", o);
  require(o.gammat >= 0, "--gammat", "a number >= 0 (kg/s)", o.gammat);
  require(std::isnan(o.mu) || o.mu >= 0, "--mu", "a number >= 0", o.mu);
  if (o.mu > 0 && std::isnan(o.kt) && !(o.gammat > 0))
    throw bad_input({"--mu"}, "there is no tangential force for it to limit",
                    "--kt (a spring) or --gammat above 0 (Eq. 1) as well", "neither");
  require(std::isnan(o.velocity) || o.velocity > 0, "--velocity", "a speed above 0 (m/s)", o.velocity);
  require(std::isnan(o.error) || o.error > 0, "--error", "a number above 0", o.error);
}

/// Impact of two discs of the smallest size; with friction, at 45 degrees.
physics::Impact impact_of(const TimestepOptions& o) {
  const double mass = o.density * std::numbers::pi * o.radius * o.radius, m12 = mass / 2;
  const double gamma_n = !std::isnan(o.gamman) ? o.gamman
                         : std::isnan(o.restitution)
                             ? 0.0
                             : physics::damping_of_restitution(o.kn, o.restitution, m12);
  // The error of the linear law does not depend on velocity; a slow impact hardly rotates the normal.
  const double slow = 1e-3 * o.radius * std::sqrt(o.kn / m12);
  const double v_n = o.hertz ? o.velocity : slow, k_h = physics::hertz_stiffness(o.kn, o.radius / 2);
  const double duration = o.hertz ? physics::hertz_contact_duration(k_h, m12, v_n)
                                  : physics::contact_duration(o.kn, gamma_n, m12);
  const double mu = std::isnan(o.mu) ? 0.0 : o.mu;
  return {{o.kn, gamma_n, o.kt, o.gammat, mu}, o.radius, mass, v_n, mu > 0 ? v_n : 0.0, duration};
}

struct Finding {
  double restitution, steps;  // restitution of the impact; time steps in its duration for the requested error
};

template <physics::Tangential tangential, physics::Normal normal>
Finding find(const physics::Impact& impact, double wanted) {
  constexpr physics::Effects effects{tangential, false, normal};
  Finding found{physics::exact_rebound<effects>(impact)[physics::restitution_of_impact], std::nan("")};
  if (std::isnan(found.restitution)) {
    throw bad_input({"--gamman"}, "the discs do not separate", "a weaker dashpot",
                    fmt::format("{}", impact.law.normal_damping));
  }
  if (std::isnan(wanted)) return found;
  found.steps = physics::steps_for_error<effects>(impact, wanted);
  if (std::isnan(found.steps)) {
    throw bad_input({"--error"}, "no time step of t_c/4000 or more is that accurate", "a larger error",
                    fmt::format("{}", wanted));
  }
  return found;
}

template <physics::Normal normal>
Finding find_with_friction(const TimestepOptions& o, const physics::Impact& impact) {
  using physics::Tangential;
  if (impact.law.friction == 0) return find<Tangential::none, normal>(impact, o.error);
  if (std::isnan(o.kt)) return find<Tangential::viscous_coulomb, normal>(impact, o.error);
  if (o.gammat > 0) return find<Tangential::damped_spring, normal>(impact, o.error);
  return find<Tangential::spring, normal>(impact, o.error);
}

/// Largest time step for the dashpots of a dense packing, with predicted velocities; infinite without.
double stable_step(const physics::Impact& impact) {
  const auto& law = impact.law;
  const double m12 = impact.mass / 2;
  const double approach =
      physics::normal_rate_of_lattice * physics::normal_dashpot_rate(law.normal_damping, m12);
  const double slip =
      physics::tangential_rate_of_lattice * physics::tangential_dashpot_rate(law.tangential_damping, m12);
  const double rate = std::max(approach, law.friction > 0 ? slip : 0);
  return physics::stable_dashpot_step(rate, true);
}

void print(const TimestepOptions& o, const physics::Impact& impact, const Finding& found) {
  const double rule = impact.duration / physics::steps_per_contact, dt = impact.duration / found.steps;
  const double stable = stable_step(impact);
  if (o.json) {
    Json json = Json::object();
    json["t_c"] = impact.duration;
    json["e_n"] = found.restitution;
    json["gamma_n"] = impact.law.normal_damping;
    json["rule"] = rule;
    json["steps_per_contact"] = found.steps;
    json["dt"] = dt;
    json["stable"] = std::isinf(stable) ? Json() : Json(stable);
    fmt::print("{}\n", text_of(json));
    return;
  }
  fmt::print("t_c = {:.6g} s, e_n = {:.6g}, t_c/50 = {:.6g} s\n", impact.duration, found.restitution, rule);
  if (!std::isnan(o.restitution)) fmt::print("gamma_n = {:.6g} kg/s\n", impact.law.normal_damping);
  constexpr double near = 0.75;
  if (near * stable < std::max(rule, std::isnan(dt) ? 0 : dt))
    fmt::print(
        "use dt = {:.6g} s or less: above {:.6g} s the dashpots of a dense packing of such discs are "
        "unstable\n",
        near * stable, stable);
  if (std::isnan(o.error)) return;
  fmt::print(
      "dt = {:.6g} s = t_c/{:.1f}: the rms error of velocities after {} impact is {:g} of the velocity "
      "before\n",
      dt, found.steps, impact.v_t > 0 ? "an oblique" : "a head-on", o.error);
  if (dt > rule) fmt::print("the engine warns above t_c/50\n");
}

}  // namespace

void add_timestep_command(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("timestep", "duration and restitution of a contact, time step for an error");
  auto options = std::make_shared<TimestepOptions>();
  app->add_option("--radius", options->radius, "of the smallest discs (m)")->required();
  app->add_option("--density", options->density, "areal density rho h (kg/m^2): m = rho h pi a^2")
      ->required();
  app->add_option("--kn", options->kn, "normal stiffness (N/m; with --hertz N/m^2)")->required();
  auto* gamman = app->add_option("--gamman", options->gamman, "normal dashpot (kg/s), default 0");
  auto* restitution =
      app->add_option("--restitution", options->restitution, "e_n in place of --gamman")->excludes(gamman);
  app->add_option("--mu", options->mu, "friction: the impact is oblique, at 45 degrees");
  app->add_option("--kt", options->kt, "tangential spring (N/m); without it friction is Eq. 1");
  app->add_option("--gammat", options->gammat, "tangential dashpot (kg/s)");
  auto* velocity = app->add_option("--velocity", options->velocity, "of the impact (m/s), for --hertz");
  auto* hertz =
      app->add_flag("--hertz", options->hertz, "Hertz's law")->needs(velocity)->excludes(restitution);
  velocity->needs(hertz);
  app->add_option("--error", options->error,
                  "target: rms error of velocities after an impact over the velocity before");
  app->add_flag("--json", options->json, "print JSON");
  app->callback([options] {
    check(*options);
    const physics::Impact impact = impact_of(*options);
    const bool hertz = options->hertz;
    print(*options, impact,
          hertz ? find_with_friction<physics::Normal::hertz>(*options, impact)
                : find_with_friction<physics::Normal::linear>(*options, impact));
  });
}

}  // namespace mikromakro
