// SPDX-License-Identifier: GPL-2.0-or-later
// Shared by the files that call HDF5; for hdf5_file.cpp and hdf5_attributes.cpp only.
#pragma once

#include <hdf5.h>

#include <string>
#include <vector>

#include "io/hdf5/hdf5_file.h"

namespace mikromakro {

/// The same numbers as hsize_t, whose underlying type depends on the version of HDF5.
inline std::vector<hsize_t> sizes(const Hdf5Shape& shape) {
  return {shape.begin(), shape.end()};
}

inline Hdf5Id space_of(const Hdf5Shape& shape) {
  return {H5Screate_simple(static_cast<int>(shape.size()), sizes(shape).data(), nullptr), H5Sclose};
}

/// The innermost reason for HDF5's last failure, in quotes.
std::string last_reason();
/// Throw, giving that reason.
[[noreturn]] void cannot_read(const std::string& place);
[[noreturn]] void cannot_write(const std::string& place);

}  // namespace mikromakro
