// SPDX-License-Identifier: GPL-2.0-or-later
// One thread at a time in the HDF5 library, which Debian builds without locks of its own.
#pragma once

#include <mutex>

namespace mikromakro {

/// Held by every function that calls the library, as frames may be read while windows are written. A thread
/// that has the turn may take it again.
class Hdf5Turn {
 public:
  Hdf5Turn() : lock_(library()) {}

 private:
  static std::recursive_mutex& library() {
    static std::recursive_mutex mutex;
    return mutex;
  }

  std::lock_guard<std::recursive_mutex> lock_;
};

}  // namespace mikromakro
