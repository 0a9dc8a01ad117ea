// SPDX-License-Identifier: GPL-2.0-or-later
// Engine interface: operations in which LIGGGHTS and LAMMPS differ, implemented once for each.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "dialect.h"
#include "input.h"
#include "modify.h"

namespace LAMMPS_NS {
class Atom;
class Comm;
class Integrate;
class LAMMPS;
class Neighbor;
}  // namespace LAMMPS_NS

namespace mikromakro::styles {

class DiscLaw;

/// The active disc law of the engine, or nullptr.
DiscLaw* active_disc_law(LAMMPS_NS::LAMMPS& engine);

/// The command that activates a disc law, for error messages.
extern const char* const disc_pair_style;

/// Registers the disc laws with an engine; idempotent.
void register_disc_laws(LAMMPS_NS::LAMMPS& engine);

/// "LIGGGHTS" or "LAMMPS"; engine_name() adds the version, for output files.
extern const char* const engine_family;
std::string engine_name(const LAMMPS_NS::LAMMPS& engine);

/// What -help puts before the names of the normal and of the tangential laws.
extern const char* const law_styles[2];

// The engine's style tables, by name in scripts.
std::map<std::string, FixCreator>& fix_styles(LAMMPS_NS::Modify& modify);
std::map<std::string, ComputeCreator>& compute_styles(LAMMPS_NS::Modify& modify);
std::map<std::string, CommandCreator>& command_styles(LAMMPS_NS::Input& input);

/// Non-zero: the engine does not clear forces and torques before pair styles and fixes add theirs.
int& forces_are_not_cleared(LAMMPS_NS::Integrate& integrate);

/// Local indices of owned atoms that are ghosts on other ranks or across periodic boundaries, as of the last
/// neighbour list build.
std::vector<int> atoms_with_ghosts(const LAMMPS_NS::Comm& comm, int nlocal);

/// True if the engine writes a restart file in this step, for which it rebuilds its neighbour lists.
/// `next_restart_step` is the next one requested by the script.
bool writes_restart_at(const LAMMPS_NS::LAMMPS& engine, LAMMPS_NS::bigint step);
LAMMPS_NS::bigint next_restart_step(const LAMMPS_NS::LAMMPS& engine);

/// Non-zero: the engine checks whether outputs, fixes or signals require new neighbour lists.
int& asks_for_lists(LAMMPS_NS::Neighbor& neighbor);

/// Sets the displacement of a disc that triggers a neighbour list build [m]; negative: even none.
void set_trigger(LAMMPS_NS::Neighbor& neighbor, double distance);

/// Largest radius of the discs of a type that the fix will insert [m]; 0 if it inserts none.
double radius_to_come(LAMMPS_NS::Fix& fix, int type);

/// Simulated time since the start of the engine [s].
double time_now(const LAMMPS_NS::LAMMPS& engine);

/// For the launcher: runs the engine. Returns 1 if it ends with an exception on all ranks; an exception on a
/// single rank aborts the others.
int exit_code_of(const std::function<void()>& run);

/// For the launcher: handles signals as the engine's own program does.
void handle_signals();

/// True if a signal has asked the engine to end the run or write a restart file.
bool is_asked_to_stop();

/// True if the fix, called at `mask`, never touches per-atom arrays within a step: it acts between steps
/// only, or is the engine's own contact history fix. Unknown callbacks count as touching them.
bool leaves_discs_alone(const LAMMPS_NS::Fix& fix, int mask);

/// Stores a disc's areal density, if the atom style keeps it in addition to the mass.
void store_density(LAMMPS_NS::Atom& atom, int i, double areal_density);
/// True if atoms have radius, mass and what store_density() needs. disc_atom_style is such an atom style, for
/// error messages.
bool stores_discs(const LAMMPS_NS::Atom& atom);
extern const char* const disc_atom_style;

/// True if the fix integrates spins with the moment of inertia of spheres, 2/5 m a^2 instead of 1/2 m a^2.
bool turns_spheres(const LAMMPS_NS::Fix& fix);

/// The command that sets the areal density of discs, for error messages.
extern const char* const set_density;

/// Does what the engine does for a fix before set_arrays() of new atoms.
void announce_set_arrays(LAMMPS_NS::Fix& fix);

}  // namespace mikromakro::styles
