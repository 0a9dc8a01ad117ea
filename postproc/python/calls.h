// SPDX-License-Identifier: GPL-2.0-or-later
// The verbs for Python.
#pragma once

#include <pybind11/pybind11.h>

namespace mikromakro {

/// Adds average(), audit(), fit(), draw(), and what the package needs besides.
void add_calls(pybind11::module_& module);

}  // namespace mikromakro
