// SPDX-License-Identifier: GPL-2.0-or-later
// For LD_PRELOAD: the time that a program sees, from FIXED_TIME.
#include <cstdlib>
#include <ctime>

extern "C" std::time_t time(std::time_t* out) noexcept {
  const std::time_t now = std::atol(std::getenv("FIXED_TIME"));
  if (out) *out = now;
  return now;
}
