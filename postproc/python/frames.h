// SPDX-License-Identifier: GPL-2.0-or-later
// Frames for Python.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "model/frame.h"

namespace mikromakro {

/// Adds the classes Frame and Frames, and the function frames().
void add_frames(pybind11::module_& module);

/// A frame whose arrays are views of `frame`.
pybind11::object python_frame(std::shared_ptr<const Frame> frame);

}  // namespace mikromakro
