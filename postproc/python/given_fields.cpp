// SPDX-License-Identifier: GPL-2.0-or-later
#include "python/given_fields.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <string>
#include <tuple>

#include "model/error.h"
#include "model/nearest_name.h"
#include "python/frames.h"
#include "python/number_array.h"
#include "python/turn.h"

namespace py = pybind11;

namespace mikromakro {
namespace {

template <typename Names>
ColumnSet bit_of(const std::string& name, const Names& names) {
  const auto found = std::find(std::begin(names), std::end(names), name);
  return found == std::end(names) ? 0 : ColumnSet{1} << (found - std::begin(names));
}

void add_needed(const std::string& name, GivenField& field) {
  const ColumnSet of_discs = bit_of(name, particle_column_names);
  const ColumnSet of_contacts = bit_of(name, contact_column_names);
  if (of_discs == 0 && of_contacts == 0) {
    std::vector<std::string_view> known(std::begin(particle_column_names), std::end(particle_column_names));
    known.insert(known.end(), std::begin(contact_column_names), std::end(contact_column_names));
    throw bad_input({field.name}, "no such column in needs=", "names of dump columns",
                    in_quotes_with_guess(name, known));
  }
  field.particles_needed |= of_discs;
  field.contacts_needed |= of_contacts;
  field.needs_contacts = field.needs_contacts || of_contacts != 0;
}

// Rows by discs, as many as there are; a field of one column may have one dimension.
void check_shape(const NumberArray& values, const GivenField& field, std::size_t discs) {
  const auto columns = static_cast<py::ssize_t>(field.columns.size());
  const auto rows = static_cast<py::ssize_t>(discs);
  const bool flat = values.ndim() == 1 && columns == 1 && values.shape(0) == rows;
  const bool full = values.ndim() == 2 && values.shape(0) == rows && values.shape(1) == columns;
  if (flat || full) return;
  throw bad_input({field.name}, "the function returned an array of another shape",
                  columns == 1 ? fmt::format("({},), a value for each disc", rows)
                               : fmt::format("({}, {}), values for each disc", rows, columns),
                  py::str(values.attr("shape")).cast<std::string>());
}

}  // namespace

std::vector<PythonField> fields_from(const py::list& objects) {
  std::vector<PythonField> fields;
  for (const py::handle& object : objects) {
    GivenField field;
    field.name = object.attr("name").cast<std::string>();
    field.over_discs = object.attr("mean").cast<std::string>() == "discs";
    const auto unit = object.attr("unit").cast<std::string>();
    const auto equation = object.attr("equation").cast<std::string>();
    const auto text = object.attr("text").cast<std::string>();
    for (const py::handle& name : object.attr("columns"))
      field.columns.push_back({name.cast<std::string>(), unit, equation, text});
    for (const py::handle& name : object.attr("needs")) add_needed(name.cast<std::string>(), field);
    fields.push_back({std::move(field), object.attr("function")});
  }
  return fields;
}

Rows values_of(const std::vector<PythonField>& fields, const Frame& frame) {
  Eigen::Index columns = 0;
  for (const PythonField& one : fields) columns += std::ssize(one.field.columns);
  Rows values(std::ssize(frame.particles), columns);
  // The function may keep its arrays, but the frame is overwritten by the next one.
  auto copy = std::make_shared<const Frame>(frame);
  const InPython lock;
  const py::object given = python_frame(std::move(copy));
  Eigen::Index first = 0;
  for (const auto& [field, function] : fields) {
    const NumberArray own = number_array(field.name, function(given));
    check_shape(own, field, frame.particles.size());
    const auto width = std::ssize(field.columns);
    values.middleCols(first, width) = Eigen::Map<const Rows>(own.data(), values.rows(), width);
    first += width;
  }
  return values;
}

}  // namespace mikromakro
