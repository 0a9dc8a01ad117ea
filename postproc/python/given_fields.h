// SPDX-License-Identifier: GPL-2.0-or-later
// Fields written in Python.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <memory>
#include <vector>

#include "fields/given_quantity.h"
#include "model/frame.h"

namespace mikromakro {

/// A field, and the function of a Frame that returns its values, discs x columns.
struct PythonField {
  GivenField field;
  pybind11::object function;
};

/// From objects of the class mikromakro.Field.
std::vector<PythonField> fields_from(const pybind11::list& objects);

/// The values of all these fields for the discs of a frame, side by side. Called by any thread without
/// Python's lock; `fields` must outlive it.
Rows values_of(const std::vector<PythonField>& fields, const Frame& frame);

}  // namespace mikromakro
