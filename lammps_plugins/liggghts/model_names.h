// SPDX-License-Identifier: GPL-2.0-or-later
// Checks for incompatible contact models.
#pragma once

namespace mikromakro::styles {

/// Makes the engine pass the model names of a pair style or wall to us first. An invalid combination with a
/// disc model is reported in one line, with the valid names; other combinations are left to the engine.
void watch_model_names();

}  // namespace mikromakro::styles
