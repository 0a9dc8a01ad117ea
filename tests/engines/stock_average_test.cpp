// SPDX-License-Identifier: GPL-2.0-or-later
// A run of the packaged LIGGGHTS with its own contact law, dumped by its own compute and averaged by naming
// the columns, against the same discs and contacts dumped by ours: the same fields. At step 0 the laws give
// the same forces (stock_comparison_test.cpp); the fields then differ by the rounding of overlaps and normals
// that are derived from positions.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine.h"
#include "packing.h"

namespace mikromakro::test {
namespace {

struct Laws {
  const char *name, *stock, *ours, *fields;
};

void PrintTo(const Laws& laws, std::ostream* out) {
  *out << laws.name;
}

using Table = std::vector<std::vector<double>>;  // columns

Table read_csv(const std::string& file) {
  std::ifstream stream(file);
  Table columns;
  bool header = true;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream words(line);
    std::size_t column = 0;
    for (std::string word; std::getline(words, word, ','); ++column) {
      if (header) {
        columns.emplace_back();
      } else {
        columns[column].push_back(std::stod(word));
      }
    }
    header = false;
  }
  return columns;
}

class StockRun : public testing::TestWithParam<Laws> {
 protected:
  StockRun() : folder_(testing::TempDir() + "stock_run" + std::to_string(getpid())) {
    std::filesystem::create_directories(folder_);
  }
  ~StockRun() override { std::filesystem::remove_all(folder_); }

  void shell(const std::string& command) const {
    const std::string line =
        fmt::format("cd {} && timeout 60 {} </dev/null >>log 2>&1", folder_.string(), command);
    std::ifstream log;
    ASSERT_EQ(std::system(line.c_str()), 0) << command << (log.open(folder_ / "log"), log.rdbuf());
  }

  /// Step 0 of the packing under a law; its contacts by the given compute.
  void run(const std::string& name, const std::string& program, const std::string& law,
           const std::string& compute) const {
    constexpr Material material{.k_n = 352.1, .gamma_n = 0.19, .k_t = 281.68, .gamma_t = 0.15, .mu = 0.44};
    std::ofstream(folder_ / (name + ".in"))
        << scene(law, material, packing_box, 2, "p p p", "0.002") << packing(20, 0.05)
        << "fix integrate all nve/sphere\nfix plane all enforce2d\ntimestep 4e-5\n"
        << "compute contacts all " << compute << "\n"
        << "dump particles all custom 1 " << name << ".particles id type x y radius mass vx vy omegaz\n"
        << "dump_modify particles format \"%d %d %.17g %.17g %.17g %.17g %.17g %.17g %.17g\"\n"
        << "run 0\n";
    shell(fmt::format("{} -in {}.in -log none", program, name));
  }

  Table average(const std::string& name, const std::string& columns) const {
    shell(
        fmt::format("{0} average --particles {1}.particles --contacts {1}.contacts {2} --rings 0.01 0.09 8 "
                    "--bulk-types 1 --kn 352.1 {3} --out {1}.csv",
                    MIKROMAKRO_PROGRAM, name, columns, GetParam().fields));
    return read_csv(folder_ / (name + ".csv"));
  }

  static std::string local_dump(const std::string& name, int columns) {
    std::string list, format;
    for (int k = 1; k <= columns; ++k) {
      list += fmt::format(" c_contacts[{}]", k);
      format += k > 1 ? " %.17g" : "%.17g";
    }
    return fmt::format("\ndump contacts all local 1 {}.contacts{}\ndump_modify contacts format \"{}\"", name,
                       list, format);
  }

  std::filesystem::path folder_;
};

TEST_P(StockRun, GivesTheFieldsOfOurCompute) {
  run("stock", "liggghts", GetParam().stock, "pair/gran/local pos id force" + local_dump("stock", 12));
  run("ours", LIGGGHTS_DISC, GetParam().ours, "contact/disc" + local_dump("ours", 16));
  const Table stock = average("stock", "--contact-columns x1,y1,z1,x2,y2,z2,id1,id2,periodic,fx,fy,fz");
  const Table ours = average("ours", "");
  ASSERT_EQ(stock.size(), ours.size());
  ASSERT_GT(ours.size(), 30U);
  double worst = 0;
  for (std::size_t column = 0; column < ours.size(); ++column) {
    ASSERT_EQ(ours[column].size(), 8U);
    double largest = 0;
    for (const double number : ours[column])
      if (!std::isnan(number)) largest = std::max(largest, std::abs(number));
    for (std::size_t row = 0; row < 8; ++row) {
      EXPECT_EQ(std::isnan(stock[column][row]), std::isnan(ours[column][row])) << "column " << column;
      if (std::isnan(ours[column][row]) || largest == 0) continue;
      worst = std::max(worst, std::abs(stock[column][row] - ours[column][row]) / largest);
    }
  }
  std::printf("%s: largest difference of a column %.1e of its largest number\n", GetParam().name, worst);
  // An overlap of 5 % of the radius loses two digits in the difference of positions.
  EXPECT_LE(worst, 1e-12);
}

// Without friction there are no moments: couple stress, curvature and what is made of them would be rounding
// compared with rounding.
const Laws laws[] = {
    {"normal force", "model hooke/stiffness tangential off absolute_damping on",
     "model disc/linear tangential off",
     "--fields "
     "solid_fraction,coordination,velocity,spin,fabric,stress,kinetic_stress,elastic_strain,stiffness,"
     "velocity_gradient"},
    {"Eq. 1", "model hooke/stiffness tangential no_history absolute_damping on",
     "model disc/linear tangential disc/viscous", ""}};
INSTANTIATE_TEST_SUITE_P(Laws, StockRun, testing::ValuesIn(laws));

}  // namespace
}  // namespace mikromakro::test
