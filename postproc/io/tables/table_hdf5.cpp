// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/tables/table_hdf5.h"

#include <map>

#include "io/hdf5/hdf5_file.h"

namespace mikromakro {

void write_table_hdf5(const std::string& file, const Preamble& preamble, const Table& table) {
  Hdf5File out = Hdf5File::create(file);
  std::map<std::string, std::vector<std::string>> values;
  for (const auto& [name, value] : preamble) values[name].push_back(value);
  for (const auto& [name, list] : values)
    list.size() == 1 ? out.attribute("/", name, list.front()) : out.attribute("/", name, list);
  out.add_group("/table");
  std::vector<std::string> names;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const Column& column = table.columns[i];
    names.push_back(column.name);
    const std::string path = "/table/" + column.name;
    const Eigen::ArrayXd numbers = table.rows.col(static_cast<Eigen::Index>(i));
    const auto rows = static_cast<std::size_t>(numbers.size());
    out.add<double>(path, {numbers.data(), rows}, {rows});
    out.attribute(path, "unit", column.unit);
    out.attribute(path, "equation", column.equation);
    out.attribute(path, "text", column.text);
  }
  out.attribute("/table", "columns", names);
  out.close();
}

}  // namespace mikromakro
