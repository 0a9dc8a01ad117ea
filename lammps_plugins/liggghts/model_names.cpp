// SPDX-License-Identifier: GPL-2.0-or-later
#include "model_names.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "contact_models.h"
#include "engine/arguments.h"
#include "engine/private_member.h"
#include "force.h"
#include "granular_pair_style.h"
#include "granular_wall.h"
#include "law/law_names.h"
#include "model/nearest_name.h"

namespace mikromakro::styles {

using LAMMPS_NS::Custom_contact_models;
using LAMMPS_NS::LAMMPS;
namespace models = LIGGGHTS::ContactModels;

// The engine's factory tables are private, and the public function for replacing an entry prints a message.
using PairFactory = LIGGGHTS::Utils::AbstractFactory<LIGGGHTS::PairStyles::IGranularPairStyle>;
using WallFactory = LIGGGHTS::Utils::AbstractFactory<LIGGGHTS::Walls::IGranularWall>;
struct PairSelectors {
  friend auto member(PairSelectors);
};
struct WallSelectors {
  friend auto member(WallSelectors);
};

template struct PrivateMember<PairSelectors, &PairFactory::variantSelectorTable>;
template struct PrivateMember<WallSelectors, &WallFactory::variantSelectorTable>;

namespace {

using Words = std::vector<std::string>;

/// Models that may be combined with a disc model, and their wording in error messages.
struct Choice {
  Words names;
  std::string text;
};
const std::map<std::string, Choice>& choices() {
  static const std::map<std::string, Choice> all = {
      {"model", {normal_names(), alternatives(normal_names())}},
      {"tangential", {tangential_names(), alternatives(tangential_names())}},
      {"cohesion", {{"off"}, "off"}},
      {"rolling_friction", {{"off"}, "off"}},
      {"surface", {{"default"}, "default"}}};
  return all;
}

/// True for disc models, even if misspelt.
bool names_discs(const std::string& word) {
  if (word.starts_with("disc/")) return true;
  std::vector<std::string> names = normal_names();
  for (const std::string& name : tangential_names())
    if (name.starts_with("disc/")) names.push_back(name);
  return !nearest_name(word, std::vector<std::string_view>(names.begin(), names.end())).empty();
}

/// Leading arguments: pairs of model kind and model name.
std::vector<std::pair<std::string, std::string>> models_in(const Words& words) {
  std::vector<std::pair<std::string, std::string>> named;
  for (std::size_t k = 0; k + 1 < words.size() && choices().contains(words[k]); k += 2)
    named.emplace_back(words[k], words[k + 1]);
  return named;
}

std::string models_of_discs() {
  Words quoted;
  for (const std::string& name : normal_names()) quoted.push_back("'model " + name + "'");
  return alternatives(quoted);
}

std::string fault_of(const Words& words) {
  if (std::none_of(words.begin(), words.end(), names_discs)) return "";
  if (words.front() != "model")
    return "expected " + models_of_discs() + " first, got " + quoted_with_guess(words.front(), "model");
  for (const auto& [kind, name] : models_in(words)) {
    const Choice& choice = choices().at(kind);
    if (std::find(choice.names.begin(), choice.names.end(), name) == choice.names.end())
      return kind + ": expected " + choice.text + " with a disc model, got " +
             quoted_with_guess(name, choice.text);
  }
  return "";
}

/// Placeholder for an invalid combination; no model has these ids.
const int64_t faulty = LIGGGHTS::Utils::generate_gran_hashcode(63, 63, 63, 63, 63);
/// Error message for `faulty`: the engine requests the model right after its id.
std::string fault;

int64_t select_pair_models(int& count, char**& words, Custom_contact_models custom) {
  fault = fault_of({words, words + count});
  return fault.empty() ? models::Factory::select(count, words, std::move(custom)) : faulty;
}

int64_t select_wall_models(int& count, char**& words, Custom_contact_models custom) {
  const auto named = models_in({words, words + count});
  const bool ours =
      std::any_of(named.begin(), named.end(), [](const auto& model) { return names_discs(model.second); });
  return ours ? faulty : models::Factory::select(count, words, std::move(custom));
}

LIGGGHTS::PairStyles::IGranularPairStyle* refuse_pair(LAMMPS* engine, LAMMPS_NS::PairGran* /*parent*/,
                                                      int64_t /*hash*/) {
  stop(*engine, "pair_style gran", fault);
}

LIGGGHTS::Walls::IGranularWall* refuse_wall(LAMMPS* engine, LAMMPS_NS::FixWallGran* /*parent*/,
                                            int64_t /*hash*/) {
  stop(*engine, "fix wall/gran",
       "it has no walls for disc models; expected 'fix ID group wall/disc type T plane NX NY OFFSET' or '... "
       "circle X Y R inside/outside'");
}

}  // namespace

void watch_model_names() {
  auto& pairs = LIGGGHTS::PairStyles::Factory::instance();
  auto& walls = LIGGGHTS::Walls::Factory::instance();
  (pairs.*member(PairSelectors{}))["gran"] = select_pair_models;
  (walls.*member(WallSelectors{}))["gran"] = select_wall_models;
  pairs.addStyle("gran", static_cast<int>(faulty), refuse_pair);
  walls.addStyle("gran", static_cast<int>(faulty), refuse_wall);
}

}  // namespace mikromakro::styles
