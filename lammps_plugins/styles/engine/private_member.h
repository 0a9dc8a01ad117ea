// SPDX-License-Identifier: GPL-2.0-or-later
// Access to private and protected members of the engines' classes. Naming such a member in an explicit
// template instantiation is allowed by the standard ([temp.spec]), so no header of an engine needs to be
// changed.
#pragma once

namespace mikromakro::styles {

/// In this namespace, not an unnamed one inside it:
///
///     struct NextRestart {
///       friend auto member(NextRestart);
///     };
///     template struct PrivateMember<NextRestart, &LAMMPS_NS::Output::next_restart>;
///
/// The instantiation defines member(NextRestart), which returns the pointer to member: then
/// `output.*member(NextRestart{})` is the member of `output`.
template <class Tag, auto pointer>
struct PrivateMember {
  friend auto member(Tag /*tag*/) { return pointer; }
};

}  // namespace mikromakro::styles
