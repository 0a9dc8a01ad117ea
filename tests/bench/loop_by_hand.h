// SPDX-License-Identifier: GPL-2.0-or-later
// A pair loop without friction, written by hand for comparison: `pair_style gran model bench/by_hand
// tangential off`. Linear spring and dashpot, one material, and nothing else: no spin, no torque, no
// observer. Packed, vectorised, with the same short list of pairs that may touch; what `tangential off` of
// the disc law must cost.
#pragma once

namespace mikromakro::bench {

/// Makes the style known to the engine.
void register_loop_by_hand();

}  // namespace mikromakro::bench
