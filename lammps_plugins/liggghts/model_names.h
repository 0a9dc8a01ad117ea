// SPDX-License-Identifier: GPL-2.0-or-later
// Names of contact models that do not go together.
#pragma once

namespace mikromakro::styles {

/// Has the engine ask us first which model a pair style or a wall names: what is wrong with a combination
/// that has a model of discs is told in one line, with the names that exist. Other combinations are the
/// engine's own.
void watch_model_names();

}  // namespace mikromakro::styles
