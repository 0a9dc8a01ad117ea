// SPDX-License-Identifier: GPL-2.0-or-later
#include "audit/normal_forces.h"

#include <algorithm>
#include <cmath>

namespace mikromakro {

void NormalForces::add(const Frame& frame) {
  for (const Contact& contact : frame.contacts) {
    if (contact.with_wall()) continue;
    const double f_n = -contact.force.dot(contact.normal);
    force_ += f_n;
    magnitude_ += std::abs(f_n);
    pulling_ += std::max(0.0, -f_n);
    overlap_ += contact.overlap;
    deviation_ += std::abs(f_n - k_n_ * contact.overlap);
  }
}

}  // namespace mikromakro
