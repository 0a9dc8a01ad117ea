// SPDX-License-Identifier: GPL-2.0-or-later
#include "engine.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include "atom.h"
#include "compute.h"
#include "fix.h"
#include "input.h"
#include "modify.h"
#include "program/registration.h"

namespace mikromakro::test {

namespace {

constexpr std::size_t disc_values = 12;

/// The line that the engine works on; told if the engine ends the process there.
std::string current_line;

void tell_where_the_engine_stopped() {
  if (!current_line.empty())
    std::fprintf(stderr, "the engine stopped the process at: %s\n", current_line.c_str());
}

/// One engine for each communicator, cleared for every test and never destroyed: LIGGGHTS enters its contact
/// models into static tables again, with a warning for each, whenever one is constructed.
LAMMPS_NS::LAMMPS* engine_on(MPI_Comm ranks) {
  static std::map<MPI_Comm, LAMMPS_NS::LAMMPS*> engines;
  auto& engine = engines[ranks];
  if (!engine) {
    std::array<std::string, 5> words = {"test", "-screen", "none", "-log", "none"};
    std::array<char*, 5> arguments = {words[0].data(), words[1].data(), words[2].data(), words[3].data(),
                                      words[4].data()};
    static const int told = std::atexit(tell_where_the_engine_stopped);
    (void)told;
    engine = new LAMMPS_NS::LAMMPS(static_cast<int>(arguments.size()), arguments.data(), ranks);
    styles::register_styles(*engine);
  }
  return engine;
}

/// Concatenates the rows of all ranks.
std::vector<double> gather(const std::vector<double>& mine, MPI_Comm ranks) {
  int size = 0;
  MPI_Comm_size(ranks, &size);
  std::vector<int> counts(size), offsets(size);
  const int count = static_cast<int>(mine.size());
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, ranks);
  for (int k = 1; k < size; ++k) offsets[k] = offsets[k - 1] + counts[k - 1];
  std::vector<double> all(offsets.back() + counts.back());
  MPI_Allgatherv(mine.data(), count, MPI_DOUBLE, all.data(), counts.data(), offsets.data(), MPI_DOUBLE,
                 ranks);
  return all;
}

template <typename Style>
Style* named(Style** styles, int count, const std::string& id) {
  Style** const found = std::find_if(styles, styles + count, [&](const Style* one) { return one->id == id; });
  if (found == styles + count) throw std::runtime_error("the script has no '" + id + "'");
  return *found;
}

}  // namespace

Engine::Engine(MPI_Comm ranks) : ranks_(ranks), lammps_(engine_on(ranks)) {
  run("clear");
}

void Engine::run(const std::string& lines) {
  std::istringstream text(lines);
  for (std::string line; std::getline(text, line);) {
    current_line = line;
    for (const auto& own : lines_.of(line)) lammps_->input->one(own.c_str());
  }
  current_line.clear();
}

LAMMPS_NS::Fix& Engine::fix(const std::string& id) const {
  const auto& modify = *lammps_->modify;
  return *named(modify.fix, modify.nfix, id);
}

LAMMPS_NS::Compute& Engine::compute(const std::string& id) const {
  const auto& modify = *lammps_->modify;
  return *named(modify.compute, modify.ncompute, id);
}

std::map<int, Disc> Engine::discs() const {
  const auto& atom = *lammps_->atom;
  std::vector<double> mine;
  for (int i = 0; i < atom.nlocal; ++i) {
    mine.insert(mine.end(), {static_cast<double>(atom.tag[i]), static_cast<double>(atom.type[i]),
                             atom.radius[i], atom.rmass[i], atom.x[i][0], atom.x[i][1], atom.v[i][0],
                             atom.v[i][1], atom.omega[i][2], atom.f[i][0], atom.f[i][1], atom.torque[i][2]});
  }
  const auto all = gather(mine, ranks_);
  std::map<int, Disc> discs;
  for (std::size_t k = 0; k < all.size(); k += disc_values) {
    const double* d = &all[k];
    discs[static_cast<int>(d[0])] = {
        static_cast<int>(d[1]), d[2], d[3], d[4], d[5], d[6], d[7], d[8], d[9], d[10], d[11]};
  }
  return discs;
}

std::map<std::pair<int, int>, Contact> Engine::contacts(const std::string& compute_id) const {
  auto* compute = &this->compute(compute_id);
  compute->compute_local();
  std::vector<double> mine;
  for (int k = 0; k < compute->size_local_rows; ++k) {
    mine.insert(mine.end(), compute->array_local[k], compute->array_local[k] + 16);
  }
  const auto all = gather(mine, ranks_);
  std::map<std::pair<int, int>, Contact> contacts;
  for (std::size_t k = 0; k < all.size(); k += 16) {
    static_assert(sizeof(Contact) == 16 * sizeof(double));
    Contact c{};
    std::memcpy(&c, &all[k], sizeof c);
    if (c.id1 > c.id2) {
      std::swap(c.id1, c.id2);
      std::swap(c.x1, c.x2);
      std::swap(c.y1, c.y2);
      c.n_x = -c.n_x, c.n_y = -c.n_y, c.f_x = -c.f_x, c.f_y = -c.f_y;
    }
    const std::pair<int, int> ids = {static_cast<int>(c.id1), static_cast<int>(c.id2)};
    EXPECT_TRUE(contacts.emplace(ids, c).second)
        << "two rows for the contact " << ids.first << "-" << ids.second;
  }
  return contacts;
}

std::string constants(const Material& material, int types) {
  const auto constant = [&](const char* id, const char* name, double value) {
    std::string line = fmt::format("fix {} all property/global {} peratomtypepair {}", id, name, types);
    for (int k = 0; k < types * types; ++k) line += fmt::format(" {:.17g}", value);
    return line + "\n";
  };
  return constant("kn", "kn", material.k_n) + constant("gamman", "gamman_abs", material.gamma_n) +
         constant("kt", "kt", material.k_t) + constant("gammat", "gammat_abs", material.gamma_t) +
         constant("mu", "coefficientFriction", material.mu);
}

std::string scene(const std::string& pair_style, const Material& material, double size, int types,
                  const std::string& boundary, const std::string& skin) {
  return fmt::format(
             "units si\ndimension 2\nnewton off\natom_style granular\natom_modify map array\n"
             "communicate single vel yes\nboundary {}\nregion box block -{} {} -{} {} -0.001 0.001 units "
             "box\n"
             "create_box {} box\nneighbor {} bin\nneigh_modify delay 0\n",
             boundary, size, size, size, size, types, skin) +
         constants(material, types) + fmt::format("pair_style gran {}\npair_coeff * *\n", pair_style);
}

std::string disc(int id, double x, double y, double radius, double density, int type) {
  return fmt::format(
      "create_atoms {} single {:.17g} {:.17g} 0 units box\nset atom {} diameter {:.17g} density {:.17g}\n",
      type, x, y, id, 2 * radius, density);
}

std::string motion(int id, double v_x, double v_y, double omega) {
  return fmt::format("set atom {0} vx {1:.17g} vy {2:.17g} omegaz {3:.17g}\n", id, v_x, v_y, omega);
}

}  // namespace mikromakro::test
