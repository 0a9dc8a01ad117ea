// SPDX-License-Identifier: GPL-2.0-or-later
// Errors end the run with one line. Where the version calls itself PUBLIC, LIGGGHTS adds a joke to every
// fifth error, read from freed memory, so that arbitrary bytes appear on screen. Messages from ranks other
// than the first are lost.
//
// The engine calls these functions through the dynamic symbol table, where these definitions take precedence,
// as for post_create() in registration.cpp.
#include <dlfcn.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string_view>

#include "error.h"
#include "universe.h"

namespace {

void spare_the_joke(const LAMMPS_NS::Universe& universe) {
  constexpr std::string_view shown = "Public";
  if (char* name = std::strstr(universe.version, "PUBLIC")) std::copy(shown.begin(), shown.end(), name);
}

template <class... Arguments>
void engines_own(const char* symbol, Arguments... arguments) {
  reinterpret_cast<void (*)(Arguments...)>(dlsym(RTLD_NEXT, symbol))(arguments...);
}

}  // namespace

namespace LAMMPS_NS {

void Error::all(const char* file, int line, const char* text) {
  spare_the_joke(*universe);
  engines_own("_ZN9LAMMPS_NS5Error3allEPKciS2_", this, file, line, text);
}

void Error::one(const char* file, int line, const char* text) {
  spare_the_joke(*universe);
  if (!screen) std::fprintf(stderr, "ERROR on proc %d: %s (%s:%d)\n", universe->me, text, file, line);
  engines_own("_ZN9LAMMPS_NS5Error3oneEPKciS2_", this, file, line, text);
}

void Error::universe_all(const char* file, int line, const char* text) {
  spare_the_joke(*universe);
  engines_own("_ZN9LAMMPS_NS5Error12universe_allEPKciS2_", this, file, line, text);
}

void Error::universe_one(const char* file, int line, const char* text) {
  spare_the_joke(*universe);
  engines_own("_ZN9LAMMPS_NS5Error12universe_oneEPKciS2_", this, file, line, text);
}

void Error::fix_error(const char* file, int line, Fix* fix, const char* text) {
  spare_the_joke(*universe);
  engines_own("_ZN9LAMMPS_NS5Error9fix_errorEPKciPNS_3FixES2_", this, file, line, fix, text);
}

void Error::fix_error(const char* file, int line, Fix* fix, const char* style, const char* text) {
  spare_the_joke(*universe);
  engines_own("_ZN9LAMMPS_NS5Error9fix_errorEPKciPNS_3FixES2_S2_", this, file, line, fix, style, text);
}

void Error::compute_error(const char* file, int line, Compute* compute, const char* text) {
  spare_the_joke(*universe);
  engines_own("_ZN9LAMMPS_NS5Error13compute_errorEPKciPNS_7ComputeES2_", this, file, line, compute, text);
}

}  // namespace LAMMPS_NS
