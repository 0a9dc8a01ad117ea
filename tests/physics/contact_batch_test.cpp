// SPDX-License-Identifier: GPL-2.0-or-later
// The batch of pairs against the scalar law pair by pair: every combination of effects, every number of
// pairs, every width of vectors that the processor has.
#include "physics/contact/contact_batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "physics/contact/contact_energy.h"

namespace mikromakro::physics {
namespace {

// Coordinates, velocities and constants are of order 1, so that errors are a number of roundings, epsilon
// = 2.2e-16. Root and products make up to 6 epsilon of the overlap, whose error the law multiplies by
// constants up to 2, a torque by the radius, a power by the velocity; slip since onset multiplies it by v_t /
// v_n; fused multiply-add leaves some roundings out. Worst seen: 25 epsilon.
constexpr double tolerance = 50 * std::numeric_limits<double>::epsilon();

/// Pair k is discs k and k + 1 of a chain, in either order; each disc but the ends is in two pairs.
struct Chain {
  std::vector<DiscRow> discs;
  std::vector<DiscPair> pairs;
  std::vector<ContactParameters> materials;
  SpringLanes springs{};
  StepOfSlip step{};
};

/// Overlaps from -0.1 to 0.2 m, any relative motion, springs stretched either way by up to what friction
/// holds and more, contacts that are old, new, just ended, or absent.
Chain random_chain(int count, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto between = [&](double low, double high) {
    return low + (high - low) * (1 + uniform(random)) / 2;
  };
  Chain chain;
  double x = 0, y = 0, radius = 1;
  for (int k = 0; k <= count; ++k) {
    const double next = between(0.5, 1.5), angle = between(-3.2, 3.2);
    const double distance = k == 0 ? 0 : radius + next - between(-0.1, 0.2);
    x += distance * std::cos(angle);
    y += distance * std::sin(angle);
    radius = next;
    chain.discs.push_back(DiscRow::of(x, y, radius));
    chain.discs.back().set_motion(uniform(random), uniform(random), uniform(random));
  }
  for (int k = 0; k < count; ++k) {
    chain.pairs.push_back(uniform(random) > 0 ? DiscPair{k, k + 1} : DiscPair{k + 1, k});
    chain.materials.push_back(
        {between(1, 2), between(0, 1), between(0.5, 1.5), between(0, 1), between(0, 1)});
    chain.springs.touched[k] = uniform(random) > 0 ? 1 : 0;
    // Left over where discs did not touch: a new spring must not start from it.
    chain.springs.xi[k] = between(-0.2, 0.2);
    chain.springs.slip_rate[k] = uniform(random);
  }
  const std::array<StepOfSlip, 3> steps{{{0.1, true}, {0.1, false}, {0, true}}};
  chain.step = steps[random() % steps.size()];
  return chain;
}

/// What a batch leaves behind.
struct Outcome {
  std::unique_ptr<ContactBatch> batch = std::make_unique<ContactBatch>();
  SpringLanes springs{};
  std::vector<DiscLoad> loads;
  BatchState state{};
};

/// As in the pair loop (styles/law/pair_loop.cpp).
template <Effects effects>
[[gnu::always_inline]] inline void evaluate(const Chain& chain, Outcome& outcome) {
  const int count = static_cast<int>(chain.pairs.size());
  ContactBatch& c = *outcome.batch;
  load_discs<effects>(c, chain.discs.data(), chain.pairs.data(), count);
  outcome.state = contact_geometry<effects>(c, count);
  if constexpr (effects.spring()) {
    contact_slip(c, count, chain.step);
    for (int k = 0; k < count; ++k)
      if (c.touches(k) != (c.springs->touched[k] != 0)) begin_or_end_contact(c, k, chain.step);
  }
  contact_forces<effects>(c, count);
  add_loads<effects>(c, chain.pairs.data(), count, outcome.loads.data());
}

template <Effects effects>
[[gnu::flatten]] void on_any_processor(const Chain& chain, Outcome& outcome) {
  evaluate<effects>(chain, outcome);
}
// The processors of styles/processor_clones.h; the last one fuses multiplications and additions.
#if defined(__x86_64__) && !defined(__clang__)
template <Effects effects>
[[gnu::flatten, gnu::target("avx2")]] void on_avx2(const Chain& chain, Outcome& outcome) {
  evaluate<effects>(chain, outcome);
}
template <Effects effects>
[[gnu::flatten, gnu::target("arch=x86-64-v4")]] void on_avx512(const Chain& chain, Outcome& outcome) {
  evaluate<effects>(chain, outcome);
}
#endif

enum class Processor { any, avx2, avx512 };

bool is_here(Processor processor) {
  if (processor == Processor::any) return true;
#if defined(__x86_64__) && !defined(__clang__)
  return processor == Processor::avx2 ? __builtin_cpu_supports("avx2") != 0
                                      : __builtin_cpu_supports("x86-64-v4") != 0;
#else
  return false;
#endif
}

template <Effects effects>
void evaluate_on([[maybe_unused]] Processor processor, const Chain& chain, Outcome& outcome) {
#if defined(__x86_64__) && !defined(__clang__)
  if (processor == Processor::avx2) return on_avx2<effects>(chain, outcome);
  if (processor == Processor::avx512) return on_avx512<effects>(chain, outcome);
#endif
  on_any_processor<effects>(chain, outcome);
}

template <Effects effects>
Outcome outcome_on(Processor processor, const Chain& chain) {
  Outcome outcome;
  ContactBatch& c = *outcome.batch;
  // What the law reads and nobody has loaded shows as nan.
  for (auto* lanes : {&c.d_x, &c.d_y, &c.radius_sum, &c.radius_difference, &c.w_x, &c.w_y, &c.spin,
                      &c.rim_speed, &c.slip, &c.short_torque, &c.v_t})
    std::fill(std::begin(*lanes), std::end(*lanes), std::nan(""));
  for (int k = 0; k < ContactBatch::lanes; ++k) c.set_material(k, chain.materials.front());
  for (std::size_t k = 0; k < chain.materials.size(); ++k)
    c.set_material(static_cast<int>(k), chain.materials[k]);
  outcome.springs = chain.springs;
  c.springs = &outcome.springs;
  outcome.loads.resize(chain.discs.size());
  evaluate_on<effects>(processor, chain, outcome);
  return outcome;
}

/// One pair by the formulas of contact_law.h and the scalar law.
struct ScalarContact {
  double n_x, n_y;
  ContactState state;  // xi of before
  double slip_rate = 0;
  ContactForce force{0, 0, 0};
  bool touches = false, touched = false;
};

template <Effects effects>
ScalarContact scalar_contact(const Chain& chain, int k) {
  const DiscRow &one = chain.discs[chain.pairs[k].i], &two = chain.discs[chain.pairs[k].j];
  const double d_x = two.x() - one.x(), d_y = two.y() - one.y(), distance = std::sqrt(d_x * d_x + d_y * d_y);
  const double w_x = one.velocity().x - two.velocity().x, w_y = one.velocity().y - two.velocity().y;
  ScalarContact s{d_x / distance, d_y / distance, {}};
  const double overlap = one.radius() + two.radius() - distance;
  const double rolling =
      one.spin() * (one.radius() - overlap / 2) + two.spin() * (two.radius() - overlap / 2);
  s.touches = overlap > 0;
  s.touched = chain.springs.touched[k] != 0;
  s.state = {overlap, w_x * s.n_x + w_y * s.n_y, w_y * s.n_x - w_x * s.n_y + rolling,
             s.touched ? chain.springs.xi[k] : 0, reduced_radius(one.radius(), two.radius())};
  if (!s.touches) return s;
  const SpringStep step = s.touched ? step_of_old_contact(chain.springs.slip_rate[k], s.state.v_t, chain.step)
                                    : step_of_new_contact(s.state, chain.step);
  s.slip_rate = step.slip_rate;
  s.force = contact_force<effects>(chain.materials[k], s.state, step.slip);
  return s;
}

/// How many contacts of each kind were compared.
using Kinds = std::map<std::string, int>;

template <Effects effects>
void count_kinds(const ContactParameters& p, const ScalarContact& s, Kinds& kinds) {
  if (!s.touches) {
    ++kinds[s.touched ? "ended" : "not touching"];
    return;
  }
  const double cap = p.friction * std::abs(s.force.f_n);
  ++kinds[s.touched ? "old" : "begun"];
  ++kinds[s.state.v_n < 0 ? "separating" : "approaching"];
  if (s.force.f_n < 0) ++kinds["attracting"];
  if (s.force.f_n == 0) ++kinds["attraction cut off"];
  ++kinds[std::abs(s.force.f_t) < cap ? "sticking" : "sliding"];
  if (s.touched && s.state.xi * s.state.v_t < 0) ++kinds["rolling back"];
}

void expect_near(double value, double expected, const char* what, int pair) {
  // not EXPECT_NEAR: fails for nan as well, and is quicker
  if (!(std::abs(value - expected) <= tolerance))
    ADD_FAILURE() << what << " of pair or disc " << pair << ": " << value << ", expected " << expected;
}

template <Effects effects>
void expect_same_contact(const ContactBatch& c, const Chain& chain, int k, const ScalarContact& s) {
  const ContactParameters& p = chain.materials[k];
  EXPECT_EQ(c.touches(k), s.touches);
  expect_near(c.overlap[k], s.state.overlap, "overlap", k);
  expect_near(c.f_n[k], s.force.f_n, "f_n", k);
  expect_near(c.f_t[k], s.force.f_t, "f_t", k);
  expect_near(c.f_x[k], -s.force.f_n * s.n_x - s.force.f_t * s.n_y, "f_x", k);
  expect_near(c.f_y[k], -s.force.f_n * s.n_y + s.force.f_t * s.n_x, "f_y", k);
  if constexpr (effects.spring()) {
    expect_near(c.springs->xi[k], s.force.xi, "xi", k);
    expect_near(c.springs->slip_rate[k], s.slip_rate, "slip rate", k);
    expect_near(spring_energy(p, c.springs->xi[k]), spring_energy(p, s.force.xi), "energy of the spring", k);
  }
  const ContactState in_batch{c.overlap[k], c.v_n[k], 0, 0, s.state.reduced_radius};
  expect_near(normal_energy<effects>(p, in_batch), normal_energy<effects>(p, s.state), "normal energy", k);
  expect_near(dashpot_power<effects>(p, in_batch, c.f_n[k]), dashpot_power<effects>(p, s.state, s.force.f_n),
              "power of the dashpot", k);
  if constexpr (effects.tangential != Tangential::none) {
    expect_near(c.v_t[k], s.state.v_t, "v_t", k);
    expect_near(tangential_power(c.f_t[k], c.v_t[k]), tangential_power(s.force.f_t, s.state.v_t),
                "tangential power", k);
  }
}

template <Effects effects>
void expect_same(Processor processor, const Chain& chain, Kinds& kinds) {
  const Outcome outcome = outcome_on<effects>(processor, chain);
  const std::size_t discs = chain.discs.size();
  std::vector<double> f_x(discs), f_y(discs), torque(discs);
  bool changed = false;
  for (int k = 0; k < static_cast<int>(chain.pairs.size()); ++k) {
    const auto s = scalar_contact<effects>(chain, k);
    expect_same_contact<effects>(*outcome.batch, chain, k, s);
    count_kinds<effects>(chain.materials[k], s, kinds);
    changed = changed || s.touches != s.touched;
    for (const int sign : {1, -1}) {
      const int disc = sign > 0 ? chain.pairs[k].i : chain.pairs[k].j;
      f_x[disc] += sign * (-s.force.f_n * s.n_x - s.force.f_t * s.n_y);
      f_y[disc] += sign * (-s.force.f_n * s.n_y + s.force.f_t * s.n_x);
      torque[disc] += (chain.discs[disc].radius() - s.state.overlap / 2) * s.force.f_t;
    }
  }
  for (int i = 0; i < static_cast<int>(discs); ++i) {
    expect_near(outcome.loads[i].f_x(), f_x[i], "load f_x", i);
    expect_near(outcome.loads[i].f_y(), f_y[i], "load f_y", i);
    expect_near(outcome.loads[i].torque(chain.discs[i].radius()), torque[i], "torque", i);
  }
  EXPECT_EQ(outcome.state.any_changed, effects.spring() && changed);
  EXPECT_FALSE(outcome.state.any_undefined);
}

/// Kinds of contacts that the combination knows.
std::vector<std::string> kinds_of(const Effects& effects) {
  std::vector<std::string> kinds{"ended",      "not touching", "old",         "begun",
                                 "separating", "approaching",  "rolling back"};
  if (effects.tangential != Tangential::none) kinds.insert(kinds.end(), {"sticking", "sliding"});
  if (effects.normal_dashpot) kinds.emplace_back(effects.no_attraction ? "attraction cut off" : "attracting");
  return kinds;
}

template <Effects effects>
void compare(Processor processor) {
  std::mt19937_64 random(20010101);
  Kinds kinds;
  for (int count = 1; count <= ContactBatch::lanes; ++count) {
    SCOPED_TRACE(std::to_string(count) + " pairs");
    for (int draw = 0; draw < 5; ++draw) expect_same<effects>(processor, random_chain(count, random), kinds);
  }
  for (const auto& kind : kinds_of(effects)) EXPECT_GT(kinds[kind], 50) << kind;
}

template <int... numbers>
void compare_combination(int number, Processor processor, std::integer_sequence<int, numbers...> /*all*/) {
  ((numbers == number ? compare<effects_of_combination(numbers)>(processor) : void()), ...);
}

class BatchOfPairs : public testing::TestWithParam<std::tuple<int, Processor>> {};

TEST_P(BatchOfPairs, IsTheScalarLawPairByPair) {
  const auto [number, processor] = GetParam();
  if (!is_here(processor)) GTEST_SKIP() << "this processor has no such vectors";
  compare_combination(number, processor, std::make_integer_sequence<int, effect_combinations>{});
}

std::string name_of(const testing::TestParamInfo<std::tuple<int, Processor>>& info) {
  const auto [number, processor] = info.param;
  const Effects effects = effects_of_combination(number);
  constexpr std::array tangential{"frictionless", "viscous", "spring", "damped_spring"};
  constexpr std::array processors{"any", "avx2", "avx512"};
  return std::string(effects.normal == Normal::hertz ? "hertz_" : "linear_") +
         (effects.normal_dashpot ? "dashpot_" : "") + (effects.no_attraction ? "no_attraction_" : "") +
         tangential[static_cast<std::size_t>(effects.tangential)] + "_" +
         processors[static_cast<std::size_t>(processor)];
}

INSTANTIATE_TEST_SUITE_P(OfEachLaw, BatchOfPairs,
                         testing::Combine(testing::Range(0, effect_combinations),
                                          testing::Values(Processor::any, Processor::avx2,
                                                          Processor::avx512)),
                         name_of);

/// Coincident centres leave the normal undefined; the last pair of a batch that is not full is found too.
TEST(ContactBatch, FindsCoincidentCentres) {
  std::mt19937_64 random(1);
  for (const int count : {1, 7, 64}) {
    Chain chain = random_chain(count, random);
    chain.discs.back().move_to(chain.discs[count - 1].x(), chain.discs[count - 1].y());
    EXPECT_TRUE(outcome_on<Effects{}>(Processor::any, chain).state.any_undefined);
  }
}

}  // namespace
}  // namespace mikromakro::physics
