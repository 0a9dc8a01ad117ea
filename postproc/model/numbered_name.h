// SPDX-License-Identifier: GPL-2.0-or-later
// Names of the files of a sequence.
#pragma once

#include <cstdint>
#include <string>

namespace mikromakro {

/// The name of file `index` of `count`: a %d in the name (%04d: with leading zeros to 4 digits) becomes the
/// index; without one, _0000, _0001, ... comes before the ending where count > 1.
std::string numbered_name(const std::string& name, std::int64_t index, std::int64_t count);

}  // namespace mikromakro
