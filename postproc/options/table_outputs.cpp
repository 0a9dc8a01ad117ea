// SPDX-License-Identifier: GPL-2.0-or-later
#include "options/table_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "averaging/volumes/volume_outlines.h"
#include "io/tables/table_hdf5.h"
#include "io/tables/vtkhdf.h"
#include "model/error.h"

namespace mikromakro {
namespace {

constexpr std::array<std::string_view, 4> endings = {".csv", ".h5", ".vtkhdf", ".hdf"};

}  // namespace

OutputFiles::OutputFiles(const std::vector<std::string>& names, const std::vector<std::string>& inputs)
    : to_stdout(names.empty()) {
  for (const std::string& name : names) {
    const bool known =
        std::any_of(endings.begin(), endings.end(), [&](auto ending) { return name.ends_with(ending); });
    if (name != "-" && !known)
      throw bad_input({"--out"}, "unknown kind of output file",
                      "a name ending in .csv, .h5, .vtkhdf or .hdf, or -", in_quotes(name));
  }
  check_outputs(names.empty() ? std::vector<std::string>{"-"} : names, inputs);
  for (const std::string& name : names) {
    if (name == "-") {
      to_stdout = true;
    } else {
      files.push_back({name, std::make_unique<OutputFile>(name)});
      if (!name.ends_with(".csv")) files.back().file->require_regular();
    }
  }
}

void TableOutputs::commit(const Preamble& preamble, const Table& table, const Eigen::Vector2d& center) {
  const std::string text = csv_text(preamble, table);
  for (const auto& [name, file] : files_.files) {
    if (name.ends_with(".csv")) {
      file->commit(text);
      continue;
    }
    if (name.ends_with(".h5")) write_table_hdf5(file->temporary(), preamble, table);
    if (name.ends_with("hdf")) write_vtkhdf(file->temporary(), table, volume_outlines(table, center));
    file->publish();
  }
  if (files_.to_stdout) fmt::print("{}", text);
}

}  // namespace mikromakro
