// SPDX-License-Identifier: GPL-2.0-or-later
#include "dump_scene.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <Eigen/Core>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

namespace mikromakro::bench {
namespace {

constexpr int disc_count = 3800;
constexpr int contact_count = 4700;
// A triangular lattice of overlapping discs; each is displaced by less than what would undo a contact.
constexpr double r_inner = 0.1032, r_outer = 0.2524, radius = 0.00358, pitch = 2 * radius - 5e-5;
constexpr double displaced = 1e-5;
constexpr double k_n = 352.1, k_t = 281.68;

struct Rows {
  std::string particles, contacts;
  int disc_count = 0, contact_count = 0;
};

std::string head(std::int64_t step, const char* label, int rows, const char* columns) {
  return fmt::format(
      "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF {}\n{}\nITEM: BOX BOUNDS ff ff pp\n-0.34 0.34\n-0.34 0.34\n-0.005 "
      "0.005\nITEM: {} {} \n",
      step, label, rows, label, columns);
}

using Uniform = std::function<double(double, double)>;

std::vector<Eigen::Vector2d> lattice(const Uniform& uniform) {
  std::vector<Eigen::Vector2d> centres;
  const double row_height = pitch * std::sqrt(3) / 2;
  const int most = static_cast<int>(r_outer / row_height);
  for (int row = -most; row <= most; ++row)
    for (int column = -2 * most; column <= 2 * most; ++column) {
      const Eigen::Vector2d site(pitch * (column + 0.5 * std::abs(row % 2)), row_height * row);
      if (site.norm() < r_inner || site.norm() > r_outer || std::ssize(centres) == disc_count) continue;
      centres.push_back(site +
                        Eigen::Vector2d(uniform(-displaced, displaced), uniform(-displaced, displaced)));
    }
  return centres;
}

std::string contact_row(int i, int j, const Eigen::Vector2d& one, const Eigen::Vector2d& two,
                        const Uniform& uniform) {
  const Eigen::Vector2d branch = two - one, n = branch.normalized(), t(-n.y(), n.x());
  const double overlap = 2 * radius - branch.norm();
  const double f_n = k_n * overlap, f_t = uniform(-0.4, 0.4) * f_n;
  const Eigen::Vector2d force = -f_n * n + f_t * t;
  return fmt::format(
      "{} {} {:.15g} {:.15g} {:.15g} {:.15g} {:.15g} {:.15g} {:.12g} {:.12g} {:.12g} {:.12g} {:.12g} {:.12g} "
      "{:.12g} {:.12g}\n",
      i + 1, j + 1, one.x(), one.y(), two.x(), two.y(), n.x(), n.y(), overlap, force.x(), force.y(), f_n, f_t,
      -f_t / k_t, uniform(-0.01, 0.01), uniform(-0.01, 0.01));
}

Rows random_rows(std::mt19937& generator) {
  const Uniform uniform = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(generator);
  };
  Rows rows;
  const auto centres = lattice(uniform);
  for (std::size_t i = 0; i < centres.size(); ++i)
    rows.particles +=
        fmt::format("{} {} {:.17g} {:.17g} 0 {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} \n",
                    i + 1, 1 + i % 2, centres[i].x(), centres[i].y(), radius, 2.7502e-4, uniform(-0.01, 0.01),
                    uniform(-0.01, 0.01), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
  rows.disc_count = static_cast<int>(centres.size());
  int count = 0;
  // Sites are listed row by row: neighbours are the next one and some of the following row.
  const int discs = static_cast<int>(centres.size());
  for (int i = 0; i < discs && count < contact_count; ++i)
    for (int j = i + 1; j < std::min(discs, i + 100) && count < contact_count; ++j) {
      const auto &one = centres[static_cast<std::size_t>(i)], &two = centres[static_cast<std::size_t>(j)];
      if ((two - one).norm() > 2 * radius || uniform(0, 1) > 0.43) continue;
      rows.contacts += contact_row(i, j, one, two, uniform);
      ++count;
    }
  rows.contact_count = count;
  return rows;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  path_ = (std::filesystem::temp_directory_path() / "mikromakro_bench_XXXXXX").string();
  if (mkdtemp(path_.data()) == nullptr) std::abort();
}

TemporaryFolder::~TemporaryFolder() {
  std::filesystem::remove_all(path_);
}

Dumps write_dumps(const TemporaryFolder& folder, int frames, std::int64_t bytes) {
  std::mt19937 generator(1);
  Dumps dumps{folder.path("particles.txt"), folder.path("contacts.txt")};
  std::ofstream particles(dumps.particles), contacts(dumps.contacts);
  Rows rows = random_rows(generator);
  const auto of_frame = static_cast<std::int64_t>(rows.particles.size() + rows.contacts.size());
  if (bytes > 0) frames = static_cast<int>(bytes / of_frame);
  for (int frame = 0; frame < frames; ++frame) {
    if (bytes == 0 && frame > 0) rows = random_rows(generator);
    particles << head(1000 * frame, "ATOMS", rows.disc_count, "id type x y z radius mass vx vy omegaz fx fy")
              << rows.particles;
    contacts << head(1000 * frame, "ENTRIES", rows.contact_count,
                     "id1 id2 x1 y1 x2 y2 nx ny overlap fx fy fn ft xi vn vt")
             << rows.contacts;
  }
  dumps.bytes = static_cast<std::int64_t>(particles.tellp() + contacts.tellp());
  return dumps;
}

}  // namespace mikromakro::bench
