// SPDX-License-Identifier: GPL-2.0-or-later
#include "python/number_array.h"

#include <string_view>

#include "model/error.h"

namespace py = pybind11;

namespace mikromakro {
namespace {

constexpr std::string_view number_kinds = "biuf";  // bool, int, unsigned int, float

}  // namespace

NumberArray number_array(const std::string& what, const py::object& given) {
  if (py::isinstance(given, py::module_::import("numpy.ma").attr("MaskedArray")))
    throw bad_input({what}, "the mask would be lost", "an array without one, as of filled(nan)",
                    "a masked array");
  const py::array array = py::array::ensure(given);
  if (!array) throw py::error_already_set();
  if (number_kinds.find(array.dtype().kind()) == std::string_view::npos)
    throw bad_input({what}, "these are no real numbers", "an array of bool, int or float",
                    py::str(array.dtype()).cast<std::string>());
  NumberArray numbers = NumberArray::ensure(array);
  if (!numbers) throw py::error_already_set();
  return numbers;
}

}  // namespace mikromakro
