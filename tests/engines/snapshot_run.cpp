// SPDX-License-Identifier: GPL-2.0-or-later
#include "snapshot_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "engine_lines.h"
#include "io/frames/frame_stream.h"

namespace mikromakro::test {
namespace {

const std::string before_the_box = R"(
units si
newton off
atom_style granular
atom_modify map array
communicate single vel yes
processors * * 1
)";
const std::string discs_between_rings = R"(
dimension 2
boundary f f p
region box block -0.06 0.06 -0.06 0.06 -0.001 0.001 units box
create_box 4 box
create_ring 0 0 0.02 number 20 type 3 radius 0.00125 density 6
create_ring 0 0 0.045 number 40 type 4 radius 0.00125 density 6
create_discs ring 0 0 0.02 0.045 seed 3 density 6 velocity 1 discs 80 1 0.0025 discs 20 2 0.003
group inner type 3
group outer type 4
group wall type 3 4
group free type 1 2
)";
const std::string styles = R"(
neighbor 0.001 bin
neigh_modify delay 0
neigh_modify exclude group wall wall
fix kn all property/global kn peratomtypepair 4 400 400 400 400 400 400 400 400 400 400 400 400 400 400 400 400
fix kt all property/global kt peratomtypepair 4 300 300 300 300 300 300 300 300 300 300 300 300 300 300 300 300
fix gamman all property/global gamman_abs peratomtypepair 4 .1 .1 .1 .1 .1 .1 .1 .1 .1 .1 .1 .1 .1 .1 .1 .1
fix mu all property/global coefficientFriction peratomtypepair 4 .4 .4 .4 .4 .4 .4 .4 .4 .4 .4 .4 .4 .4 .4 .4 .4
pair_style gran model disc/linear tangential disc/cundall_strack
pair_coeff * *
fix integrate free nve/disc
compute contacts all contact/disc
timestep 2e-5
)";
const std::string wheel =
    "fix cell wall couette/2d center 0 0 inner rough inner 0.02 outer rough outer 0.045 omega_inner 5\n";
const std::string discs_in_a_periodic_box = R"(
dimension 2
boundary p p p
region box block -0.02 0.02 -0.015 0.015 -0.001 0.001 units box
create_box 4 box
create_discs box -0.02 0.02 -0.015 0.015 seed 3 density 6 velocity 1 discs 28 1 0.0022 discs 4 2 0.003
group wall type 3 4
group free type 1 2
)";

Numbers numbers_of(const Particle& d) {
  return {static_cast<double>(d.id),
          static_cast<double>(d.type),
          d.position[0],
          d.position[1],
          d.radius,
          d.velocity[0],
          d.velocity[1],
          d.spin,
          d.mass};
}

Content content_of(FrameStream& stream, const Frame& frame) {
  Content content;
  for (const Particle& disc : frame.particles) content.discs.push_back(numbers_of(disc));
  for (const auto& row : stream.raw().contacts.rows)
    content.contacts.emplace_back(row.value.begin(), row.value.begin() + contact_disc_columns);
  std::sort(content.contacts.begin(), content.contacts.end());
  return content;
}

std::map<std::int64_t, Content> contents(const FrameSource& source) {
  std::map<std::int64_t, Content> frames;
  FrameStream stream(source);
  Frame frame;
  while (stream.next(frame)) frames[frame.step] = content_of(stream, frame);
  return frames;
}

}  // namespace

const std::string turning_cell = before_the_box + discs_between_rings + styles + wheel;
const std::string periodic_box = before_the_box + discs_in_a_periodic_box + styles;

std::string turning_cell_from(const std::string& restart_file) {
  return before_the_box + "read_restart " + restart_file + "\n" + styles + wheel;
}

SnapshotOfARun::SnapshotOfARun() : folder_(testing::TempDir() + "snapshot" + std::to_string(getpid())) {
  std::filesystem::create_directories(folder_);
}

std::string SnapshotOfARun::text(const std::string& file) const {
  std::ifstream stream(folder_ / file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::string SnapshotOfARun::table(const std::string& file) const {
  std::istringstream lines(text(file));
  std::string numbers;
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with('#')) numbers += line + "\n";
  return numbers;
}

std::string SnapshotOfARun::command(const std::string& script, int ranks) const {
  std::ofstream(folder_ / "in.test") << lines_of_engine(script);
  const std::string mpi =
      ranks > 1 ? fmt::format("{} --mca mpi_yield_when_idle 1 -n {} ", MPIEXEC, ranks) : "";
  return fmt::format("cd {} && exec {}{} -in in.test -log none </dev/null >screen.txt 2>&1", folder_.string(),
                     mpi, ENGINE_PROGRAM);
}

void SnapshotOfARun::run(const std::string& script, int ranks) const {
  const int status = std::system(("timeout 60 sh -c '" + command(script, ranks) + "'").c_str());
  ASSERT_EQ(status, 0) << text("screen.txt");
}

void SnapshotOfARun::average(const std::string& options, const std::string& out) const {
  const std::string command =
      fmt::format("cd {} && {} average s.h5 {} --out {}", folder_.string(), MIKROMAKRO, options, out);
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
}

std::map<std::int64_t, Content> SnapshotOfARun::snapshots(const std::string& file) const {
  FrameSource source;
  source.snapshot_files = {path(file)};
  return contents(source);
}

std::map<std::int64_t, Content> SnapshotOfARun::dumped() const {
  FrameSource source;
  for (int step = 0; std::filesystem::exists(path(fmt::format("p_{}.txt", step))); step += 20) {
    source.particle_files.push_back(path(fmt::format("p_{}.txt", step)));
    source.contact_files.push_back(path(fmt::format("c_{}.txt", step)));
  }
  return contents(source);
}

}  // namespace mikromakro::test
