// SPDX-License-Identifier: GPL-2.0-or-later
// Tables of how often the intervals of fitted profiles hold the truth.
#pragma once

namespace mikromakro::bench {

void print_fit_coverage(int trials);

}  // namespace mikromakro::bench
