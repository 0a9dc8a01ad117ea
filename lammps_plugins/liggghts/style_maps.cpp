#include "style_maps.h"

#include <algorithm>
#include <iterator>

#include "comm.h"
#include "integrate.h"

namespace mikromakro::liggghts {
namespace {

// Instantiating Grant<Tag, &Class::member> defines member(Tag), through which the private member is reached.
template <class Tag, typename Tag::Type Member>
struct Grant {
  friend typename Tag::Type member(Tag /*tag*/) { return Member; }
};

struct FixMap {
  using Type = std::map<std::string, FixCreator>* LAMMPS_NS::Modify::*;
  friend Type member(FixMap tag);
};
struct ComputeMap {
  using Type = std::map<std::string, ComputeCreator>* LAMMPS_NS::Modify::*;
  friend Type member(ComputeMap tag);
};
struct CommandMap {
  using Type = std::map<std::string, CommandCreator>* LAMMPS_NS::Input::*;
  friend Type member(CommandMap tag);
};

struct ExternalForceClear {
  using Type = int LAMMPS_NS::Integrate::*;
  friend Type member(ExternalForceClear tag);
};
struct SwapCount {
  using Type = int LAMMPS_NS::Comm::*;
  friend Type member(SwapCount tag);
};
struct SendCounts {
  using Type = int* LAMMPS_NS::Comm::*;
  friend Type member(SendCounts tag);
};
struct SendLists {
  using Type = int** LAMMPS_NS::Comm::*;
  friend Type member(SendLists tag);
};

template struct Grant<ExternalForceClear, &LAMMPS_NS::Integrate::external_force_clear>;
template struct Grant<SwapCount, &LAMMPS_NS::Comm::nswap>;
template struct Grant<SendCounts, &LAMMPS_NS::Comm::sendnum>;
template struct Grant<SendLists, &LAMMPS_NS::Comm::sendlist>;
template struct Grant<FixMap, &LAMMPS_NS::Modify::fix_map>;
template struct Grant<ComputeMap, &LAMMPS_NS::Modify::compute_map>;
template struct Grant<CommandMap, &LAMMPS_NS::Input::command_map>;

}  // namespace

std::map<std::string, FixCreator>& fix_styles(LAMMPS_NS::Modify& modify) {
  return *(modify.*member(FixMap{}));
}
std::map<std::string, ComputeCreator>& compute_styles(LAMMPS_NS::Modify& modify) {
  return *(modify.*member(ComputeMap{}));
}
std::map<std::string, CommandCreator>& command_styles(LAMMPS_NS::Input& input) {
  return *(input.*member(CommandMap{}));
}

int& forces_are_not_cleared(LAMMPS_NS::Integrate& integrate) {
  return integrate.*member(ExternalForceClear{});
}

std::vector<int> atoms_with_ghosts(const LAMMPS_NS::Comm& comm, int nlocal) {
  std::vector<int> atoms;
  for (int swap = 0; swap < comm.*member(SwapCount{}); ++swap) {
    const int* sent = (comm.*member(SendLists{}))[swap];
    std::copy_if(sent, sent + (comm.*member(SendCounts{}))[swap], std::back_inserter(atoms),
                 [nlocal](int i) { return i < nlocal; });
  }
  std::sort(atoms.begin(), atoms.end());
  atoms.erase(std::unique(atoms.begin(), atoms.end()), atoms.end());
  return atoms;
}

}  // namespace mikromakro::liggghts
