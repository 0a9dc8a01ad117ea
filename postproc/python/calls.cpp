// SPDX-License-Identifier: GPL-2.0-or-later
#include "python/calls.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "io/tables/csv_reader.h"
#include "python/given_fields.h"
#include "python/keywords.h"
#include "python/turn.h"
#include "verbs/audits.h"
#include "verbs/average.h"
#include "verbs/draw.h"
#include "verbs/fit.h"

namespace py = pybind11;

namespace mikromakro {
namespace {

py::array array_of(Rows rows) {
  auto held = std::make_unique<Rows>(std::move(rows));
  const Rows& numbers = *held;
  const py::capsule owner(held.release(), [](void* rows) { delete static_cast<Rows*>(rows); });
  return py::array_t<double>({numbers.rows(), numbers.cols()}, numbers.data(), owner);
}

py::list columns_of(const std::vector<Column>& columns) {
  py::list all;
  for (const Column& column : columns)
    all.append(py::make_tuple(column.name, column.unit, column.equation, column.text));
  return all;
}

// Header, columns (name, unit, equation, text), numbers (rows x columns).
py::tuple table_of(const Preamble& header, const Table& table) {
  return py::make_tuple(header, columns_of(table.columns), array_of(table.rows));
}

py::tuple average_call(const py::dict& keywords, const py::list& fields, py::object progress,
                       py::object warn) {
  AverageCommand command;
  CLI::App app;
  add_average_command_options(app, command);
  set_options(app, "average", keywords);
  command.returns_table = true;
  command.json = false;  // what it prints is returned
  const std::vector<PythonField> own = fields_from(fields);
  for (const PythonField& one : own) command.average.fields.numbers.given.push_back(one.field);
  if (!own.empty()) command.average.given = [&own](const Frame& frame) { return values_of(own, frame); };
  const AverageResult result = in_turn({std::move(progress), std::move(warn)},
                                       [&] { return average(command, Ranks(Ranks::Alone{})); });
  return table_of(result.table.lines, result.table.table) + py::make_tuple(text_of(result.error_report));
}

// A table of windows, or None.
py::object windows_of(const Preamble& header, const Table& table) {
  if (table.columns.empty()) return py::none();
  return table_of(header, table);
}

// JSON, the text that the program prints, the table of windows.
py::tuple fit_call(const py::dict& keywords, py::object warn) {
  FitOptions options;
  CLI::App app;
  add_fit_options(app, options);
  set_options(app, "fit", keywords);
  const FitResult result = in_turn({py::none(), std::move(warn)}, [&] { return fit(options); });
  return py::make_tuple(text_of(result.json), result.text, windows_of(result.lines, result.of_windows));
}

py::tuple audit_call(const py::dict& keywords, py::object progress, py::object warn) {
  AuditOptions options;
  CLI::App app;
  add_audit_options(app, options);
  set_options(app, "audit", keywords);
  const AuditReport report = in_turn({std::move(progress), std::move(warn)}, [&] { return audit(options); });
  check_bound(report, options.bound);
  py::list balances;
  for (const Balance& one : report.balances)
    balances.append(py::make_tuple(one.name, one.value, one.text, one.judged));
  return py::make_tuple(text_of(report.json), report.text, balances,
                        windows_of(report.lines, report.of_windows));
}

std::vector<std::string> draw_call(const py::dict& keywords, py::object progress, py::object warn) {
  DrawOptions options;
  CLI::App app;
  add_draw_options(app, options);
  set_options(app, "draw", keywords);
  return in_turn({std::move(progress), std::move(warn)}, [&] { return draw(options); });
}

template <typename Options>
py::list described(void (*add)(CLI::App&, Options&)) {
  CLI::App app;
  Options options;
  add(app, options);
  return describe_options(app);
}

py::list options_of_verb(const std::string& verb) {
  if (verb == "average") return described(add_average_command_options);
  if (verb == "audit") return described(add_audit_options);
  if (verb == "fit") return described(add_fit_options);
  if (verb == "draw") return described(add_draw_options);
  if (verb == "frames") return described(add_input_options);
  throw py::key_error(verb);
}

// Comment lines, names, numbers.
py::tuple read_csv(const std::string& file) {
  const CsvTable table(file);
  Rows numbers(table.rows(), std::ssize(table.names()));
  for (Eigen::Index i = 0; i < numbers.cols(); ++i)
    numbers.col(i) = table.column(table.names()[static_cast<std::size_t>(i)]);
  return py::make_tuple(table.comments(), table.names(), array_of(std::move(numbers)));
}

using NamedColumn = std::tuple<std::string, std::string, std::string, std::string>;

std::string text_of_table(const Preamble& header, const std::vector<NamedColumn>& columns,
                          const py::array_t<double, py::array::c_style | py::array::forcecast>& numbers) {
  Table table;
  for (const auto& [name, unit, equation, text] : columns)
    table.columns.push_back({name, unit, equation, text});
  table.rows = Eigen::Map<const Rows>(numbers.data(), numbers.shape(0), numbers.shape(1));
  return csv_text(header, table);
}

}  // namespace

void add_calls(py::module_& module) {
  module.def("average", average_call);
  module.def("fit", fit_call);
  module.def("audit", audit_call);
  module.def("draw", draw_call);
  module.def("options_of", options_of_verb);
  module.def("read_csv", read_csv);
  module.def("csv_text", text_of_table);
}

}  // namespace mikromakro
