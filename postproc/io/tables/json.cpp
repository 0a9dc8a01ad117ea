// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/tables/json.h"

#include <vector>

namespace mikromakro {

Json json_of(const Table& table) {
  Json json = Json::object();
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const Eigen::ArrayXd numbers = table.rows.col(static_cast<Eigen::Index>(i));
    json[table.columns[i].name] = std::vector<double>(numbers.begin(), numbers.end());
  }
  return json;
}

std::string text_of(const Json& json) {
  constexpr int one_line = -1;
  return json.dump(one_line, ' ', false, Json::error_handler_t::replace);
}

}  // namespace mikromakro
