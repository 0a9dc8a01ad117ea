// SPDX-License-Identifier: GPL-2.0-or-later
// What the styles ask of an engine, and LIGGGHTS and LAMMPS answer differently: implemented once for each.
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

/// The disc law that is active in this engine, or nullptr.
DiscLaw* active_disc_law(LAMMPS_NS::LAMMPS& engine);

/// The command that activates one, for error lines.
extern const char* const disc_pair_style;

/// Makes the law known to an engine; calling it twice changes nothing.
void register_disc_laws(LAMMPS_NS::LAMMPS& engine);

/// "LIGGGHTS" or "LAMMPS"; with its version, for files.
extern const char* const engine_family;
std::string engine_name(const LAMMPS_NS::LAMMPS& engine);

/// The law as -help shows it.
extern const char* const law_styles;

// Tables of the engine: what a name in a script stands for.
std::map<std::string, FixCreator>& fix_styles(LAMMPS_NS::Modify& modify);
std::map<std::string, ComputeCreator>& compute_styles(LAMMPS_NS::Modify& modify);
std::map<std::string, CommandCreator>& command_styles(LAMMPS_NS::Input& input);

/// Not zero: the engine leaves forces and torques as they are before pair styles and fixes add theirs.
int& forces_are_not_cleared(LAMMPS_NS::Integrate& integrate);

/// Local numbers of the owned atoms that other ranks, or the other sides of a periodic box, see as ghosts;
/// since the neighbour lists were built.
std::vector<int> atoms_with_ghosts(const LAMMPS_NS::Comm& comm, int nlocal);

/// Whether the engine writes a restart file in this step, before which it builds its neighbour lists;
/// `next_restart_step` is the next that a script has asked for.
bool writes_restart_at(const LAMMPS_NS::LAMMPS& engine, LAMMPS_NS::bigint step);
LAMMPS_NS::bigint next_restart_step(const LAMMPS_NS::LAMMPS& engine);

/// Not zero: the engine asks outputs, fixes and signals whether they want new neighbour lists.
int& asks_for_lists(LAMMPS_NS::Neighbor& neighbor);

/// How far a disc may move before the engine builds new neighbour lists [m]; below zero: not at all.
void set_trigger(LAMMPS_NS::Neighbor& neighbor, double distance);

/// The largest radius that discs of a type will have which the fix inserts [m]; 0: it inserts none.
double radius_to_come(LAMMPS_NS::Fix& fix, int type);

/// Simulated since the engine began [s].
double time_now(const LAMMPS_NS::LAMMPS& engine);

/// For the launcher: runs the engine, and gives 1 where it ends by an exception of all ranks; one of a single
/// rank ends the others.
int exit_code_of(const std::function<void()>& run);

/// For the launcher: what signals mean to the engine's own program.
void handle_signals();

/// Somebody outside has asked the engine to end the run, or for a restart file.
bool is_asked_to_stop();

/// Whether a fix may be called, and for nothing but these things, while nobody has put discs into the
/// engine's arrays: for what happens between steps only, and for what the fix that keeps the engine's springs
/// does with them. Callbacks that are not known here are harmful.
bool leaves_discs_alone(const LAMMPS_NS::Fix& fix, int mask);

/// A disc's areal density, where the atom style keeps it beside the mass.
void store_density(LAMMPS_NS::Atom& atom, int i, double areal_density);
/// Whether atoms have a radius, a mass and what store_density() needs; the atom style that has, for error
/// lines.
bool stores_discs(const LAMMPS_NS::Atom& atom);
extern const char* const disc_atom_style;

/// Whether the fix turns discs with the moment of inertia of spheres, 2/5 m a^2 for 1/2 m a^2.
bool turns_spheres(const LAMMPS_NS::Fix& fix);

/// The command that gives discs an areal density, for error lines.
extern const char* const set_density;

/// What the engine does for a fix before set_arrays() of new atoms.
void announce_set_arrays(LAMMPS_NS::Fix& fix);

}  // namespace mikromakro::styles
