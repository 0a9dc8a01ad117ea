#include "style_maps.h"

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

}  // namespace mikromakro::liggghts
