// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/memory_need.h"

#include <fmt/format.h>
#include <unistd.h>

#include "model/error.h"

namespace mikromakro {
namespace {

double memory_of_machine() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace

void check_memory(const MemoryNeed& need, std::string_view option) {
  // In units of the sums: the compensated total and the table with its text, in addition to sums of frames in
  // flight (see sum_in_order).
  constexpr double further = 6;
  const double bytes = sizeof(double) * need.numbers * (2.0 * need.threads + 2 + need.blocks + further);
  const double most = memory_of_machine();
  if (bytes <= most) return;
  constexpr double gigabyte = 1e9;
  throw bad_input(
      {option}, fmt::format("the sums would need {:.3g} GB of memory", bytes / gigabyte),
      fmt::format("at most {:.3g} GB, by fewer volumes, --error-blocks, --threads or --histogram",
                  most / gigabyte),
      fmt::format("{:.0f} numbers a frame, {} threads, {} blocks", need.numbers, need.threads, need.blocks));
}

}  // namespace mikromakro
