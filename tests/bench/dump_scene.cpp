#include "dump_scene.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>

namespace mikromakro::bench {
namespace {

constexpr int disc_count = 3800;
constexpr int contact_count = 4700;
constexpr double r_inner = 0.1032, r_outer = 0.2524, radius = 0.00371, k_n = 352.1, k_t = 281.68;

struct Rows {
  std::string particles, contacts;
};

std::string head(std::int64_t step, const char* label, int rows, const char* columns) {
  return fmt::format(
      "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF {}\n{}\nITEM: BOX BOUNDS ff ff pp\n-0.34 0.34\n-0.34 0.34\n-0.005 "
      "0.005\nITEM: {} {} \n",
      step, label, rows, label, columns);
}

Rows random_rows(std::mt19937& generator) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(generator);
  };
  Rows rows;
  std::vector<std::pair<double, double>> centres;
  for (int i = 0; i < disc_count; ++i) {
    const double r = std::sqrt(uniform(r_inner * r_inner, r_outer * r_outer));
    const double angle = uniform(0, 2 * std::numbers::pi);
    const auto& [x, y] = centres.emplace_back(r * std::cos(angle), r * std::sin(angle));
    rows.particles +=
        fmt::format("{} {} {:.17g} {:.17g} 0 {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} \n",
                    i + 1, 1 + i % 2, x, y, radius, 2.7502e-4, uniform(-0.01, 0.01), uniform(-0.01, 0.01),
                    uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
  }
  for (int k = 0; k < contact_count; ++k) {
    const int i = k % disc_count;
    const int j = (i + 1 + k / disc_count) % disc_count;
    const double angle = uniform(0, 2 * std::numbers::pi);
    const double n_x = std::cos(angle), n_y = std::sin(angle);
    const double overlap = uniform(0, 1e-4), distance = 2 * radius - overlap;
    const double f_n = k_n * overlap, f_t = uniform(-0.4, 0.4) * f_n;
    const auto [x, y] = centres[static_cast<std::size_t>(i)];
    rows.contacts += fmt::format(
        "{} {} {:.15g} {:.15g} {:.15g} {:.15g} {:.15g} {:.15g} {:.12g} {:.12g} {:.12g} {:.12g} {:.12g} "
        "{:.12g} "
        "{:.12g} {:.12g}\n",
        i + 1, j + 1, x, y, x + distance * n_x, y + distance * n_y, n_x, n_y, overlap, -f_n * n_x - f_t * n_y,
        -f_n * n_y + f_t * n_x, f_n, f_t, -f_t / k_t, uniform(-0.01, 0.01), uniform(-0.01, 0.01));
  }
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
    particles << head(1000 * frame, "ATOMS", disc_count, "id type x y z radius mass vx vy omegaz fx fy")
              << rows.particles;
    contacts << head(1000 * frame, "ENTRIES", contact_count,
                     "id1 id2 x1 y1 x2 y2 nx ny overlap fx fy fn ft xi vn vt")
             << rows.contacts;
  }
  dumps.bytes = static_cast<std::int64_t>(particles.tellp() + contacts.tellp());
  return dumps;
}

}  // namespace mikromakro::bench
