// SPDX-License-Identifier: GPL-2.0-or-later
// Global state of a fix in a restart file: a header, then the bytes of a plain struct. A file with the state
// of another version of the styles is refused.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <type_traits>

#include "engine/arguments.h"
#include "fix.h"

namespace mikromakro::styles {

/// To be raised whenever the state of any style changes its meaning or its size.
inline constexpr std::int32_t version_of_states = 1;

struct StateHeader {
  std::int64_t mark = 0x6d696b726f6d616b;  // "mikromak"
  std::int32_t version = version_of_states;
  std::int32_t size = 0;  // of the state [bytes]

  bool operator==(const StateHeader&) const = default;
};

/// Call on the first rank alone, from Fix::write_restart.
template <class State>
void write_state(std::FILE* file, const State& state) {
  static_assert(std::is_trivially_copyable_v<State>);
  const StateHeader header{.size = sizeof state};
  const int size = sizeof header + sizeof state;
  std::fwrite(&size, sizeof size, 1, file);
  std::fwrite(&header, sizeof header, 1, file);
  std::fwrite(&state, sizeof state, 1, file);
}

/// From Fix::restart. Stops the engine if the state is that of another version.
template <class State>
State read_state(LAMMPS_NS::LAMMPS& engine, const LAMMPS_NS::Fix& fix, const char* buffer) {
  StateHeader header;
  std::memcpy(&header, buffer, sizeof header);
  const StateHeader expected{.size = sizeof(State)};
  if (header.mark != expected.mark || header.version != expected.version || header.size != expected.size)
    stop(engine, std::string("fix ") + fix.id + " (" + fix.style + ")",
         "the restart file was written by another version of the styles: expected states of version " +
             std::to_string(expected.version) + ", got " +
             (header.mark == expected.mark ? std::to_string(header.version) : "a file without a version") +
             "; read it with the version that wrote it, or give the fix another id to start afresh");
  State state;
  std::memcpy(&state, buffer + sizeof header, sizeof state);
  return state;
}

}  // namespace mikromakro::styles
