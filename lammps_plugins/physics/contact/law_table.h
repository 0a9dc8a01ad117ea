// SPDX-License-Identifier: GPL-2.0-or-later
// The normal and tangential laws. A new law is a file in laws/ and its name in one of the two lists: both
// engines, walls, energies, the check of the time step, restart files and the line of effects take it from
// there (docs/add_a_contact_law.md).
#pragma once

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

#include "physics/contact/laws/cundall_strack.h"
#include "physics/contact/laws/frictionless.h"
#include "physics/contact/laws/hertz.h"
#include "physics/contact/laws/linear.h"
#include "physics/contact/laws/viscous_coulomb.h"

namespace mikromakro::physics {

// New laws go to the end: restart files name a law by its place.
using NormalLaws = std::tuple<LinearNormal, HertzNormal>;
using TangentialLaws = std::tuple<Frictionless, ViscousCoulomb, CundallStrack<false>, CundallStrack<true>>;

/// Places in the lists; those that have a name here are spoken of in code.
enum class Normal { linear, hertz };
enum class Tangential { none, viscous_coulomb, spring, damped_spring };

inline constexpr std::size_t normal_laws = std::tuple_size_v<NormalLaws>;
inline constexpr std::size_t tangential_laws = std::tuple_size_v<TangentialLaws>;

template <Normal normal>
using NormalLaw = std::tuple_element_t<static_cast<std::size_t>(normal), NormalLaws>;
template <Tangential tangential>
using TangentialLaw = std::tuple_element_t<static_cast<std::size_t>(tangential), TangentialLaws>;

static_assert(std::is_same_v<NormalLaw<Normal::hertz>, HertzNormal> &&
              std::is_same_v<TangentialLaw<Tangential::viscous_coulomb>, ViscousCoulomb> &&
              std::is_same_v<TangentialLaw<Tangential::damped_spring>, CundallStrack<true>>);

namespace detail {

/// Calls `act` with the law at this place of the list.
template <class Laws, class Act, std::size_t... places>
constexpr auto with_law_at(std::size_t place, Act act, std::index_sequence<places...> /*all*/) {
  using Result = std::common_type_t<decltype(act(std::tuple_element_t<places, Laws>{}))...>;
  Result result{};
  ((place == places ? void(result = act(std::tuple_element_t<places, Laws>{})) : void()), ...);
  return result;
}

}  // namespace detail

/// The value of `act` for the law, with_law(normal, [](auto law) { return law.name; }) say.
template <class Act>
constexpr auto with_law(Normal normal, Act act) {
  return detail::with_law_at<NormalLaws>(static_cast<std::size_t>(normal), act,
                                         std::make_index_sequence<normal_laws>{});
}
template <class Act>
constexpr auto with_law(Tangential tangential, Act act) {
  return detail::with_law_at<TangentialLaws>(static_cast<std::size_t>(tangential), act,
                                             std::make_index_sequence<tangential_laws>{});
}

constexpr const char* name_of(Normal normal) {
  return with_law(normal, [](auto law) { return law.name; });
}
constexpr const char* name_of(Tangential tangential) {
  return with_law(tangential, [](auto law) { return law.name; });
}
constexpr bool depends_on_velocity(Normal normal) {
  return with_law(normal, [](auto law) { return law.depends_on_velocity; });
}
constexpr bool has_spring(Tangential tangential) {
  return with_law(tangential, [](auto law) { return law.has_spring; });
}
constexpr bool has_dashpot(Tangential tangential) {
  return with_law(tangential, [](auto law) { return law.has_dashpot; });
}

/// All of them, in the order of the lists.
constexpr std::array<Normal, normal_laws> all_normal_laws() {
  std::array<Normal, normal_laws> all{};
  for (std::size_t k = 0; k < normal_laws; ++k) all[k] = static_cast<Normal>(k);
  return all;
}
constexpr std::array<Tangential, tangential_laws> all_tangential_laws() {
  std::array<Tangential, tangential_laws> all{};
  for (std::size_t k = 0; k < tangential_laws; ++k) all[k] = static_cast<Tangential>(k);
  return all;
}

}  // namespace mikromakro::physics
