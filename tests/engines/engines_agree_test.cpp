// SPDX-License-Identifier: GPL-2.0-or-later
// The same discs under both engines, started as programs: no process can hold both.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace {

/// What the engines spell differently.
struct Spelling {
  const char *program, *before_the_box, *density, *format;
};
constexpr Spelling liggghts = {LIGGGHTS_DISC, "atom_style granular\ncommunicate single vel yes\n", "density",
                               "format"};
constexpr Spelling lammps = {LMP_DISC, "atom_style sphere\ncomm_modify vel yes\n", "density/disc",
                             "format line"};

struct Law {
  const char *name, *normal, *tangential;
  double k_n;
};

void PrintTo(const Law& law, std::ostream* out) {
  *out << law.name;
}

std::string constants(const Law& law, const Spelling& spelling) {
  if (std::string(spelling.density) == "density") {
    std::string lines;
    const std::vector<std::pair<std::string, double>> all = {{"kn", law.k_n},
                                                             {"gamman_abs", 0.19},
                                                             {"kt", 281.68},
                                                             {"gammat_abs", 0.15},
                                                             {"coefficientFriction", 0.44}};
    for (const auto& [name, value] : all)
      lines += fmt::format("fix {0} all property/global {0} peratomtypepair 1 {1:.17g}\n", name, value);
    return lines + fmt::format("pair_style gran model {} tangential {}\npair_coeff * *\n", law.normal,
                               law.tangential);
  }
  return fmt::format(
      "pair_style {} tangential {}\npair_coeff * * kn {:.17g} gamman 0.19 kt 281.68 gammat 0.15 mu 0.44\n",
      law.normal, law.tangential, law.k_n);
}

/// Discs on a triangular lattice that overlap a little, displaced and moving at random, in a periodic box of
/// 0.2 m.
std::string packing(const Spelling& spelling) {
  constexpr int columns = 20, rows = 22;
  constexpr double box = 0.1, pitch = 2 * box / columns, row_height = 2 * box / rows;
  std::mt19937 generator(5);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(generator()) / 4294967296.0;
  };
  std::string lines;
  int id = 0;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double x = -box + (column + 0.25 + 0.5 * (row % 2)) * pitch + uniform(-2e-4, 2e-4);
      const double y = -box + (row + 0.5) * row_height + uniform(-2e-4, 2e-4);
      lines += fmt::format(
          "create_atoms 1 single {:.17g} {:.17g} 0 units box\nset atom {} diameter {:.17g} {} 6.36 vx "
          "{:.17g} "
          "vy {:.17g}\n",
          x, y, ++id, 0.01 * uniform(0.98, 1.04), spelling.density, uniform(-0.05, 0.05),
          uniform(-0.05, 0.05));
    }
  }
  return lines;
}

std::string script(const Law& law, const Spelling& spelling) {
  std::string columns, formats = "%.0f %.0f";
  for (int k = 1; k <= 16; ++k) columns += fmt::format(" c_contacts[{}]", k);
  for (int k = 3; k <= 16; ++k) formats += " %.17g";
  return std::string("units si\ndimension 2\nnewton off\n") + spelling.before_the_box +
         "atom_modify map array\nboundary p p p\nregion box block -0.1 0.1 -0.1 0.1 -0.001 0.001 units box\n"
         "create_box 1 box\nneighbor 0.001 bin\nneigh_modify delay 0\n" +
         constants(law, spelling) + packing(spelling) +
         fmt::format(
             "timestep 4e-5\nfix integrate all nve/disc\ncompute contacts all contact/disc\n"
             "dump c all local 1000 c_*.txt{}\ndump_modify c {} \"{}\"\nrun 1000\n",
             columns, spelling.format, formats);
}

using Row = std::vector<double>;
using Rows = std::map<std::pair<int, int>, Row>;

/// A dump of contacts, the smaller id first.
Rows contacts_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  for (int k = 0; k < 9; ++k) std::getline(stream, line);
  Rows rows;
  while (std::getline(stream, line)) {
    std::istringstream words(line);
    Row row{std::istream_iterator<double>(words), {}};
    if (row[0] > row[1]) {
      std::swap(row[0], row[1]);
      for (const int k : {6, 7, 9, 10}) row[k] = -row[k];
    }
    rows[{static_cast<int>(row[0]), static_cast<int>(row[1])}] = row;
  }
  return rows;
}

class EnginesAgree : public testing::TestWithParam<Law> {
 protected:
  EnginesAgree() : folder_(testing::TempDir() + "engines" + std::to_string(getpid())) {
    std::filesystem::create_directories(folder_);
  }
  ~EnginesAgree() override { std::filesystem::remove_all(folder_); }

  /// Dumps of the steps 0 and 1000.
  std::vector<Rows> run(const Spelling& spelling) {
    for (const auto* old : {"c_0.txt", "c_1000.txt"}) std::filesystem::remove(folder_ / old);
    std::ofstream(folder_ / "in.test") << script(GetParam(), spelling);
    const auto command =
        fmt::format("cd {} && timeout 60 {} -in in.test -log none </dev/null >screen.txt 2>&1",
                    folder_.string(), spelling.program);
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return {contacts_of(folder_ / "c_0.txt"), contacts_of(folder_ / "c_1000.txt")};
  }

  std::filesystem::path folder_;
};

/// Largest difference of the force on a contact, over the force.
double difference(const Rows& a, const Rows& b) {
  double largest = 0;
  for (const auto& [ids, row] : a) {
    const auto& other = b.at(ids);
    const double force = std::hypot(row[9], row[10]);
    largest = std::max(largest, std::hypot(row[9] - other[9], row[10] - other[10]) / force);
  }
  return largest;
}

std::vector<std::pair<int, int>> partners(const Rows& rows) {
  std::vector<std::pair<int, int>> all;
  for (const auto& [ids, row] : rows) all.push_back(ids);
  return all;
}

TEST_P(EnginesAgree, OnTheForceOfEachContact) {
  const auto ours = run(liggghts), theirs = run(lammps);
  for (const int step : {0, 1}) {
    ASSERT_GT(ours[step].size(), 300U);
    ASSERT_EQ(partners(ours[step]), partners(theirs[step]));
  }
  const double first = difference(ours[0], theirs[0]), last = difference(ours[1], theirs[1]);
  std::printf("%s: forces per contact differ by %.1e at step 0, %.1e at step 1000\n", GetParam().name, first,
              last);
  EXPECT_LE(first, 1e-12);
  EXPECT_LE(last, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(OfEachLaw, EnginesAgree,
                         testing::Values(Law{"normal", "disc/linear", "off", 352.1},
                                         Law{"viscous", "disc/linear", "disc/viscous", 352.1},
                                         Law{"spring", "disc/linear", "disc/cundall_strack", 352.1},
                                         Law{"damped_spring", "disc/linear",
                                             "disc/cundall_strack tangential_damping on limitForce on",
                                             352.1},
                                         Law{"hertz", "disc/hertz", "disc/cundall_strack", 1e4}),
                         [](const auto& info) { return info.param.name; });

}  // namespace
