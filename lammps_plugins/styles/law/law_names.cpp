// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/law_names.h"

#include <algorithm>

namespace mikromakro::styles {

namespace {

template <class Laws>
std::vector<std::string> names_of(const Laws& laws) {
  std::vector<std::string> names;
  for (const auto law : laws) {
    const std::string name = physics::name_of(law);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

template <class Laws>
auto law_named(const Laws& laws, const std::string& word) -> std::optional<typename Laws::value_type> {
  const auto found =
      std::find_if(laws.begin(), laws.end(), [&](const auto law) { return word == physics::name_of(law); });
  if (found == laws.end()) return {};
  return *found;
}

}  // namespace

std::vector<std::string> normal_names() {
  return names_of(physics::all_normal_laws());
}
std::vector<std::string> tangential_names() {
  return names_of(physics::all_tangential_laws());
}
std::optional<physics::Normal> normal_named(const std::string& word) {
  return law_named(physics::all_normal_laws(), word);
}
std::optional<physics::Tangential> tangential_named(const std::string& word) {
  return law_named(physics::all_tangential_laws(), word);
}

std::string alternatives(const std::vector<std::string>& names) {
  std::string text = names.front();
  for (std::size_t k = 1; k < names.size(); ++k) text += (k + 1 < names.size() ? ", " : " or ") + names[k];
  return text;
}

}  // namespace mikromakro::styles
