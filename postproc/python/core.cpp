// SPDX-License-Identifier: GPL-2.0-or-later
// The part of the Python module that is compiled; the package mikromakro is its interface.
#include <pybind11/pybind11.h>

#include "io/hdf5/hdf5_file.h"
#include "model/error.h"
#include "python/calls.h"
#include "python/frames.h"

namespace py = pybind11;

PYBIND11_MODULE(_core, module) {
  mikromakro::leave_hdf5_open_at_exit();
  auto& error = py::register_exception<mikromakro::Error>(module, "Error", PyExc_RuntimeError);
  error.attr("__module__") = "mikromakro";
  error.attr("__doc__") = "What a verb refuses, or why it failed; the text is that of the program.";
  module.attr("version") = MIKROMAKRO_VERSION;
  mikromakro::add_frames(module);
  mikromakro::add_calls(module);
}
