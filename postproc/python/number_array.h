// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers that functions of the caller return.
#pragma once

#include <pybind11/numpy.h>

#include <string>

namespace mikromakro {

using NumberArray = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// The array, or list, `given`, as doubles. Throws (bad input, in the name of `what`) unless it is of bool,
/// int or float, and if it is masked: other kinds would lose a part or their meaning.
NumberArray number_array(const std::string& what, const pybind11::object& given);

}  // namespace mikromakro
