// Access to the engine's tables of styles. LIGGGHTS 3.8 has no plugin command and keeps these tables private
// or protected; naming a private member in an explicit template instantiation is allowed by the standard
// ([temp.spec]), so no header has to be altered.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "input.h"
#include "modify.h"

namespace LAMMPS_NS {
class Comm;
class Compute;
class Fix;
class Integrate;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace mikromakro::liggghts {

using FixCreator = LAMMPS_NS::Fix* (*)(LAMMPS_NS::LAMMPS*, int, char**);
using ComputeCreator = LAMMPS_NS::Compute* (*)(LAMMPS_NS::LAMMPS*, int, int, char**);
using CommandCreator = void (*)(LAMMPS_NS::LAMMPS*, int, char**);

std::map<std::string, FixCreator>& fix_styles(LAMMPS_NS::Modify& modify);
std::map<std::string, ComputeCreator>& compute_styles(LAMMPS_NS::Modify& modify);
std::map<std::string, CommandCreator>& command_styles(LAMMPS_NS::Input& input);

/// Not zero: the engine leaves forces and torques as they are before pair styles and fixes add theirs.
int& forces_are_not_cleared(LAMMPS_NS::Integrate& integrate);

/// Local numbers of the owned atoms that other ranks, or the other sides of a periodic box, see as ghosts;
/// since the neighbour lists were built.
std::vector<int> atoms_with_ghosts(const LAMMPS_NS::Comm& comm, int nlocal);

}  // namespace mikromakro::liggghts
