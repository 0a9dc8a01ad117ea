// SPDX-License-Identifier: GPL-2.0-or-later
// A table of windows in all formats: two rings, three windows.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <sstream>

#include "io/tables/series_csv.h"
#include "io/tables/series_hdf5.h"
#include "io/tables/series_vtkhdf.h"
#include "text_file.h"

namespace mikromakro {
namespace {

SeriesColumns columns() {
  Rows radii(2, 1);
  radii << 0.5, 1.5;
  return {{{"step", "-", "-", "mean step"}, {"time", "s", "-", "mean time"}},
          {{"r", "m", "-", "radius"}},
          {{"nu", "1", "Latzel2001 Eq. 3", "solid fraction"}, {"v_phi", "m/s", "-", "velocity"}},
          radii};
}

// Window k, volume i: nu = 10 k + i, v_phi = -nu.
Rows values_of(int window) {
  Rows values(2, 2);
  values << 10 * window, -10 * window, 10 * window + 1, -10 * window - 1;
  return values;
}

// Times `time_step` apart.
void write(SeriesWriter& writer, double time_step = 0.5) {
  for (int window = 0; window < 3; ++window)
    writer.add(Eigen::Array2d(100 * window, time_step * window), values_of(window));
  writer.finish({{"program", "test"}});
}

std::vector<double> numbers_of(const Hdf5File& file, const std::string& path) {
  const Hdf5Dataset dataset = file.dataset(path);
  const Hdf5Shape shape = dataset.shape();
  std::size_t size = 1;
  for (const auto length : shape) size *= length;
  std::vector<double> numbers(size);
  dataset.read<double>({Hdf5Shape(shape.size(), 0), shape}, numbers);
  return numbers;
}

TEST(SeriesOfWindows, IsOneLongTableAsText) {
  std::ostringstream text;
  SeriesCsv csv(columns(), [&](const SeriesCsv::Write& write_to) { write_to(text); });
  write(csv);
  EXPECT_EQ(text.str(),
            "# program: test\n"
            "# column step [-] (-) mean step\n"
            "# column time [s] (-) mean time\n"
            "# column r [m] (-) radius\n"
            "# column nu [1] (Latzel2001 Eq. 3) solid fraction\n"
            "# column v_phi [m/s] (-) velocity\n"
            "step,time,r,nu,v_phi\n"
            "0,0,0.5,0,0\n0,0,1.5,1,-1\n100,0.5,0.5,10,-10\n100,0.5,1.5,11,-11\n200,1,0.5,20,-20\n"
            "200,1,1.5,21,-21\n");
}

TEST(SeriesOfWindows, HasTimeAsTheFirstDimensionInHdf5) {
  const Folder folder;
  SeriesHdf5 series(folder.path("t.h5"), columns());
  write(series);
  const Hdf5File file = Hdf5File::open(folder.path("t.h5"));
  EXPECT_EQ(file.dataset("/table/nu").shape(), (Hdf5Shape{3, 2}));
  EXPECT_EQ(numbers_of(file, "/table/nu"), (std::vector<double>{0, 1, 10, 11, 20, 21}));
  EXPECT_EQ(numbers_of(file, "/table/step"), (std::vector<double>{0, 100, 200}));
  EXPECT_EQ(numbers_of(file, "/table/r"), (std::vector<double>{0.5, 1.5}));
  const auto axes = [&](const std::string& column) {
    return file.text_attribute("/table/" + column, "axes");
  };
  EXPECT_EQ(axes("nu"), (std::vector<std::string>{"time", "volume"}));
  EXPECT_EQ(axes("time"), std::vector<std::string>{"time"});
  EXPECT_EQ(axes("r"), std::vector<std::string>{"volume"});
  EXPECT_EQ(file.text_attribute("/table/nu", "equation"), std::vector<std::string>{"Latzel2001 Eq. 3"});
  EXPECT_EQ(file.text_attribute("/table", "columns"),
            (std::vector<std::string>{"step", "time", "r", "nu", "v_phi"}));
  EXPECT_EQ(file.text_attribute("/", "program"), std::vector<std::string>{"test"});
}

// Ring 1 has two polygons, so that there are three cells.
std::vector<Outline> outlines() {
  const std::vector<Eigen::Vector2d> corners = {{0, 0}, {1, 0}, {0, 1}};
  return {{corners, 0}, {corners, 1}, {corners, 1}};
}

TEST(SeriesOfWindows, IsASeriesForParaView) {
  const Folder folder;
  SeriesVtkhdf series(folder.path("t.vtkhdf"), columns(), outlines());
  write(series);
  const Hdf5File file = Hdf5File::open(folder.path("t.vtkhdf"));
  EXPECT_EQ(file.number_attribute("/VTKHDF", "Version"), (std::vector<std::int64_t>{2, 0}));
  EXPECT_EQ(file.number_attribute("/VTKHDF/Steps", "NSteps"), std::vector<std::int64_t>{3});
  EXPECT_EQ(numbers_of(file, "/VTKHDF/Steps/Values"), (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(numbers_of(file, "/VTKHDF/CellData/nu"), (std::vector<double>{0, 1, 1, 10, 11, 11, 20, 21, 21}));
  EXPECT_EQ(numbers_of(file, "/VTKHDF/Steps/CellDataOffsets/nu"), (std::vector<double>{0, 3, 6}));
  EXPECT_EQ(numbers_of(file, "/VTKHDF/CellData/r"), (std::vector<double>{0.5, 1.5, 1.5}));
  EXPECT_EQ(numbers_of(file, "/VTKHDF/Steps/CellDataOffsets/r"), (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(numbers_of(file, "/VTKHDF/CellData/step"),
            (std::vector<double>{0, 0, 0, 100, 100, 100, 200, 200, 200}));
  EXPECT_EQ(numbers_of(file, "/VTKHDF/NumberOfCells"), std::vector<double>{3});
  for (const char* name : {"PartOffsets", "PointOffsets", "CellOffsets", "ConnectivityIdOffsets"})
    EXPECT_EQ(numbers_of(file, std::string("/VTKHDF/Steps/") + name), (std::vector<double>{0, 0, 0})) << name;
}

// 1000 polygons of one ring, 100 windows: 3.2 MB of numbers that repeat.
TEST(SeriesOfWindows, StaysSmallForParaView) {
  const Folder folder;
  SeriesVtkhdf series(folder.path("t.vtkhdf"), columns(), std::vector<Outline>(1000, outlines()[1]));
  for (int window = 0; window < 100; ++window) series.add(Eigen::Array2d(window, window), values_of(window));
  series.finish({});
  EXPECT_LT(std::filesystem::file_size(folder.path("t.vtkhdf")), 400000U);
}

// Without times ParaView shows the steps.
TEST(SeriesOfWindows, ShowsStepsWithoutTimes) {
  const Folder folder;
  SeriesVtkhdf series(folder.path("t.vtkhdf"), columns(), outlines());
  write(series, std::nan(""));
  const Hdf5File file = Hdf5File::open(folder.path("t.vtkhdf"));
  EXPECT_EQ(numbers_of(file, "/VTKHDF/Steps/Values"), (std::vector<double>{0, 100, 200}));
}

}  // namespace
}  // namespace mikromakro
