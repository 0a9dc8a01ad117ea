// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/tables/table_hdf5.h"

#include <map>

namespace mikromakro {

void describe_column(Hdf5File& out, const Column& column) {
  const std::string path = "/table/" + column.name;
  out.attribute(path, "unit", column.unit);
  out.attribute(path, "equation", column.equation);
  out.attribute(path, "text", column.text);
}

void describe_table(Hdf5File& out, const Preamble& preamble, const std::vector<Column>& columns) {
  std::map<std::string, std::vector<std::string>> values;
  for (const auto& [name, value] : preamble) values[name].push_back(value);
  for (const auto& [name, list] : values)
    list.size() == 1 ? out.attribute("/", name, list.front()) : out.attribute("/", name, list);
  std::vector<std::string> names;
  names.reserve(columns.size());
  for (const Column& column : columns) names.push_back(column.name);
  out.attribute("/table", "columns", names);
}

void write_table_hdf5(const std::string& file, const Preamble& preamble, const Table& table) {
  Hdf5File out = Hdf5File::create(file);
  out.add_group("/table");
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const Column& column = table.columns[i];
    const Eigen::ArrayXd numbers = table.rows.col(static_cast<Eigen::Index>(i));
    const auto rows = static_cast<std::size_t>(numbers.size());
    out.add<double>("/table/" + column.name, {numbers.data(), rows}, {rows});
    describe_column(out, column);
  }
  describe_table(out, preamble, table.columns);
  out.close();
}

}  // namespace mikromakro
