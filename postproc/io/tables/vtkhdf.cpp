// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/tables/vtkhdf.h"

#include "io/tables/cartesian_parts.h"

namespace mikromakro {
namespace {

const std::string root = "/VTKHDF/";
constexpr std::uint8_t vtk_polygon = 7;

template <typename T>
void add_list(Hdf5File& out, const std::string& name, const std::vector<T>& numbers) {
  out.add<T>(root + name, numbers, {numbers.size()});
}

void add_part(Hdf5File& out, const CartesianPart& part, const Table& table,
              const std::vector<Outline>& outlines) {
  std::vector<double> values;
  values.reserve(outlines.size() * part.components());
  for (const Outline& outline : outlines) {
    const std::vector<double> one = part.at(table.rows, outline.row, outline.direction);
    values.insert(values.end(), one.begin(), one.end());
  }
  out.add<double>(root + "CellData/" + part.name, values, {outlines.size(), part.components()});
}

}  // namespace

void add_outlines(Hdf5File& out, const std::vector<Outline>& outlines) {
  std::vector<double> points;
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> offsets = {0};
  for (const Outline& outline : outlines) {
    for (const Eigen::Vector2d& corner : outline.corners) {
      connectivity.push_back(static_cast<std::int64_t>(connectivity.size()));
      points.insert(points.end(), {corner.x(), corner.y(), 0.0});
    }
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  const auto count = static_cast<std::int64_t>(connectivity.size());
  add_list<std::int64_t>(out, "NumberOfPoints", {count});
  add_list<std::int64_t>(out, "NumberOfCells", {static_cast<std::int64_t>(outlines.size())});
  add_list<std::int64_t>(out, "NumberOfConnectivityIds", {count});
  out.add<double>(root + "Points", points, {connectivity.size(), 3});
  add_list(out, "Connectivity", connectivity);
  add_list(out, "Offsets", offsets);
  add_list(out, "Types", std::vector<std::uint8_t>(outlines.size(), vtk_polygon));
}

Hdf5File begin_vtkhdf(const std::string& file, std::int64_t major_version) {
  Hdf5File out = Hdf5File::create(file);
  const std::int64_t version[] = {major_version, 0};
  out.add_group("/VTKHDF");
  out.attribute("/VTKHDF", "Version", version);
  out.short_attribute("/VTKHDF", "Type", "UnstructuredGrid");
  return out;
}

void write_vtkhdf(const std::string& file, const Table& table, const std::vector<Outline>& outlines) {
  Hdf5File out = begin_vtkhdf(file, 1);
  add_outlines(out, outlines);
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    std::vector<double> values;
    values.reserve(outlines.size());
    for (const Outline& outline : outlines)
      values.push_back(table.rows(outline.row, static_cast<Eigen::Index>(i)));
    add_list(out, "CellData/" + table.columns[i].name, values);
  }
  for (const CartesianPart& part : cartesian_parts(table.columns)) add_part(out, part, table, outlines);
  out.close();
}

}  // namespace mikromakro
