// SPDX-License-Identifier: GPL-2.0-or-later
// What the files that call HDF5 share; for hdf5_file.cpp and hdf5_attributes.cpp only.
#pragma once

#include <hdf5.h>

#include <string>
#include <vector>

#include "io/hdf5/hdf5_file.h"

namespace mikromakro {

/// The same numbers; which of two types hsize_t is depends on the version of HDF5.
inline std::vector<hsize_t> sizes(const Hdf5Shape& shape) {
  return {shape.begin(), shape.end()};
}

inline Hdf5Id space_of(const Hdf5Shape& shape) {
  return {H5Screate_simple(static_cast<int>(shape.size()), sizes(shape).data(), nullptr), H5Sclose};
}

/// The innermost reason that HDF5 has for its last failure, in quotes.
std::string last_reason();
/// Throw, with that reason.
[[noreturn]] void cannot_read(const std::string& place);
[[noreturn]] void cannot_write(const std::string& place);

}  // namespace mikromakro
