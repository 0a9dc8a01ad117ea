// Access to the engine's tables of styles. LIGGGHTS 3.8 has no plugin command and keeps these tables private
// or protected; naming a private member in an explicit template instantiation is allowed by the standard
// ([temp.spec]), so no header has to be altered.
#pragma once

#include <map>
#include <string>

#include "input.h"
#include "modify.h"

namespace LAMMPS_NS {
class Compute;
class Fix;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace mikromakro::liggghts {

using FixCreator = LAMMPS_NS::Fix* (*)(LAMMPS_NS::LAMMPS*, int, char**);
using ComputeCreator = LAMMPS_NS::Compute* (*)(LAMMPS_NS::LAMMPS*, int, int, char**);
using CommandCreator = void (*)(LAMMPS_NS::LAMMPS*, int, char**);

std::map<std::string, FixCreator>& fix_styles(LAMMPS_NS::Modify& modify);
std::map<std::string, ComputeCreator>& compute_styles(LAMMPS_NS::Modify& modify);
std::map<std::string, CommandCreator>& command_styles(LAMMPS_NS::Input& input);

}  // namespace mikromakro::liggghts
