// SPDX-License-Identifier: GPL-2.0-or-later
// File names of a sequence.
#pragma once

#include <cstdint>
#include <string>

namespace mikromakro {

/// Name of file `index` out of `count`: a %d in the name (%04d: zero-padded to 4 digits) is replaced by the
/// index; without one, _0000, _0001, ... is inserted before the extension if count > 1.
std::string numbered_name(const std::string& name, std::int64_t index, std::int64_t count);

}  // namespace mikromakro
