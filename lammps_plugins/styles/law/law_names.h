// SPDX-License-Identifier: GPL-2.0-or-later
// Names of the laws in scripts, from the lists of physics/contact/law_table.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physics/contact/law_table.h"

namespace mikromakro::styles {

/// The laws that a script names; the damped spring has the name of the spring, and a switch.
std::vector<std::string> normal_names();
std::vector<std::string> tangential_names();
/// The first one of this name.
std::optional<physics::Normal> normal_named(const std::string& word);
std::optional<physics::Tangential> tangential_named(const std::string& word);
/// "a, b or c", for messages.
std::string alternatives(const std::vector<std::string>& names);

}  // namespace mikromakro::styles
