// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/snapshot/snapshot_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/snapshot/snapshot_layout.h"
#include "io/snapshot/snapshot_reader.h"

namespace mikromakro {
namespace {

const std::string step_path = "/particles/discs/position/step";
const std::string time_path = "/particles/discs/position/time";
const std::string edges_path = "/particles/discs/box/edges";
const std::string low_path = "/particles/discs/box/low";
constexpr std::uint64_t steps_per_chunk = 1024;

double number_of(const Particle& particle, const snapshot::Element& element, int axis) {
  switch (element.first) {
    case ParticleColumn::x:
      return particle.position[axis];
    case ParticleColumn::vx:
      return particle.velocity[axis];
    case ParticleColumn::radius:
      return particle.radius;
    case ParticleColumn::omegaz:
      return particle.spin;
    default:
      return particle.mass;
  }
}

std::vector<std::string> boundary(const Box& box) {
  std::vector<std::string> kinds;
  for (const bool periodic : box.periodic) kinds.emplace_back(periodic ? "periodic" : "none");
  return kinds;
}

// A single one of two components cannot be stored in the layout.
ColumnSet storable(ColumnSet given) {
  ColumnSet stored = 0;
  for (const auto& element : snapshot::elements)
    if ((element.columns() & ~given) == 0) stored |= element.columns();
  return stored;
}

}  // namespace

SnapshotWriter::SnapshotWriter(const std::string& file, const std::string& program, double time_step)
    : file_(Hdf5File::create(file)), program_(program), time_step_(time_step) {}

SnapshotWriter::SnapshotWriter(const std::string& file, const std::string& program, Use use)
    : file_(Hdf5File::create(file, use == Use::running)), program_(program), use_(use) {}

SnapshotWriter::SnapshotWriter(Hdf5File file, const std::string& name)
    : file_(std::move(file)), use_(Use::running) {
  resume(name);
}

void SnapshotWriter::resume(const std::string& name) {
  const SnapshotSummary summary = summarise_snapshots(file_, name);
  frames_ = summary.steps.size();
  most_particles_ = summary.most_particles;
  particles_given_ = summary.particles_given;
  contacts_given_ = summary.contacts_given;
  std::vector<std::string> paths = {step_path, edges_path + "/value", low_path + "/value"};
  with_time_ = file_.has(time_path);
  if (with_time_) paths.push_back(time_path);
  for (const auto& element : snapshot::elements)
    if ((element.columns() & ~particles_given_) == 0)
      paths.push_back(snapshot::discs + std::string(element.name) + "/value");
  if (contacts_given_ != 0) {
    paths.push_back(snapshot::contacts + "offset");
    rows_ = static_cast<std::uint64_t>(summary.contact_offsets.back());
  }
  for (std::size_t slot = 0; slot < std::size(contact_column_names); ++slot)
    if ((contacts_given_ >> slot & 1U) != 0)
      paths.push_back(snapshot::contacts + std::string(contact_column_names[slot]));
  for (const std::string& path : paths) datasets_[path] = file_.dataset(path);
  const auto numbers = file_.number_attribute(snapshot::box, snapshot::periodic);
  for (std::size_t axis = 0; axis < 2 && axis < numbers.size(); ++axis) periodic_[axis] = numbers[axis] != 0;
  walls_.resume(file_);
}

void SnapshotWriter::copy_parameters(const Hdf5File& run) {
  if (run.has(snapshot::parameters)) file_.copy(run, snapshot::parameters);
}

void SnapshotWriter::keep(std::uint64_t frames) {
  if (frames >= frames_) return;
  datasets_.at(step_path).grow({frames});
  frames_ = frames;
  if (contacts_given_ == 0) return;
  std::int64_t rows = 0;
  datasets_.at(snapshot::contacts + "offset").read<std::int64_t>({{frames}, {1}}, {&rows, 1});
  rows_ = static_cast<std::uint64_t>(rows);
}

void SnapshotWriter::begin(const RawFrame& frame, std::size_t particles) {
  const std::size_t blank = program_.find(' ');
  constexpr std::int64_t version[] = {1, 1};
  file_.add_group("/h5md/author");
  file_.add_group("/h5md/creator");
  file_.attribute("/h5md", "version", version);
  constexpr std::int64_t units_version[] = {1, 0};
  file_.add_group("/h5md/modules/units");
  file_.attribute("/h5md/modules/units", "version", units_version);
  file_.attribute("/h5md/modules/units", "system", std::string("SI"));
  file_.attribute("/h5md/author", "name", std::string("unknown"));
  file_.attribute("/h5md/creator", "name", program_.substr(0, blank));
  file_.attribute("/h5md/creator", "version", program_.substr(blank + 1));
  const bool checked = use_ == Use::finished;
  with_time_ = time_step_ > 0 || !std::isnan(frame.time);
  datasets_[step_path] =
      file_.add_growing(step_path, Hdf5Type::integer, {steps_per_chunk}, snapshot::no_id, checked);
  if (with_time_) {
    datasets_[time_path] = file_.add_growing(time_path, Hdf5Type::real, {steps_per_chunk}, 0, checked);
    file_.guarded_attribute(time_path, "unit", "s");
  }
  particles_given_ = storable(frame.particles_given);
  const std::uint64_t chunk = std::max<std::uint64_t>(particles, 1);
  for (const auto& element : snapshot::elements) {
    if ((element.columns() & ~particles_given_) != 0) continue;
    const auto width = static_cast<std::uint64_t>(element.width);
    begin_element(snapshot::discs + std::string(element.name),
                  element.whole() ? Hdf5Type::integer : Hdf5Type::real,
                  width == 1 ? Hdf5Shape{1, chunk} : Hdf5Shape{1, chunk, width}, element.unit);
  }
  begin_element(edges_path, Hdf5Type::real, {steps_per_chunk, 2}, "m");
  begin_element(low_path, Hdf5Type::real, {steps_per_chunk, 2}, "m");
  file_.attribute(snapshot::box, "dimension", std::int64_t{2});
  file_.attribute(snapshot::box, "boundary", boundary(frame.box));
  periodic_ = frame.box.periodic;
  const std::int64_t numbers[] = {periodic_[0] ? 1 : 0, periodic_[1] ? 1 : 0};
  file_.attribute(snapshot::box, snapshot::periodic, numbers);
  if (frame.with_contacts) begin_contacts(frame, particles);
  walls_.begin(file_, frame.walls, step_path, with_time_ ? time_path : "");
}

void SnapshotWriter::begin_element(const std::string& path, Hdf5Type type, const Hdf5Shape& chunk,
                                   std::string_view unit) {
  const std::string value = path + "/value";
  // For a chunk with more than one frame, see Use.
  const bool checked = use_ == Use::finished || chunk.front() == 1;
  datasets_[value] = file_.add_growing(value, type, chunk, snapshot::no_id, checked);
  if (!unit.empty()) file_.guarded_attribute(value, "unit", std::string(unit));
  if (path + "/step" == step_path) return;
  file_.link(step_path, path + "/step");
  if (with_time_) file_.link(time_path, path + "/time");
}

void SnapshotWriter::begin_contacts(const RawFrame& frame, std::size_t particles) {
  contacts_given_ = frame.contacts.given_in_all();
  constexpr std::uint64_t fewest = 1024;
  const bool checked = use_ == Use::finished;
  // The first frame of a run may have far fewer contacts than later ones.
  const std::uint64_t chunk =
      std::max<std::uint64_t>(checked ? frame.contacts.rows.size() : particles / 4, fewest);
  datasets_[snapshot::contacts + "offset"] =
      file_.add_growing(snapshot::contacts + "offset", Hdf5Type::integer, {steps_per_chunk}, 0, checked);
  put(snapshot::contacts + "offset", 0, std::int64_t{0});
  for (std::size_t slot = 0; slot < std::size(contact_column_names); ++slot) {
    const auto column = static_cast<ContactColumn>(slot);
    if ((contacts_given_ & column_bit(column)) == 0) continue;
    const std::string path = snapshot::contacts + std::string(contact_column_names[slot]);
    datasets_[path] = file_.add_growing(path, snapshot::whole(column) ? Hdf5Type::integer : Hdf5Type::real,
                                        {chunk}, 0, checked);
    if (!snapshot::contact_units[slot].empty())
      file_.guarded_attribute(path, "unit", std::string(snapshot::contact_units[slot]));
  }
  file_.link(step_path, snapshot::contacts + "step");
  if (with_time_) file_.link(time_path, snapshot::contacts + "time");
}

// A file stays open, and locked, as long as any of its datasets is open.
void SnapshotWriter::close() {
  datasets_.clear();
  walls_ = {};
  file_.close();
}

void SnapshotWriter::check_same(const RawFrame& frame) const {
  const Place place{frame.particle_file, frame.first_particle_line - 1};
  if (storable(frame.particles_given) != particles_given_ ||
      (frame.with_contacts ? frame.contacts.given_in_all() : 0) != contacts_given_)
    throw bad_input(place, "the columns change", "the columns of the first frame", "others");
  if (frame.box.periodic != periodic_)
    throw bad_input(place, "the boundaries change", "those of the first frame", "others");
  walls_.check(frame.walls, {frame.particle_file});
}

void SnapshotWriter::add(const RawFrame& frame, const std::vector<Particle>& particles) {
  if (frames_ == 0) begin(frame, particles.size());
  check_same(frame);
  if (with_time_)
    put(time_path, frames_, time_step_ > 0 ? time_step_ * static_cast<double>(frame.step) : frame.time);
  const Eigen::Vector2d length = frame.box.length();
  for (const auto& [path, numbers] : {std::pair(edges_path, length), std::pair(low_path, frame.box.low)}) {
    Hdf5Dataset& dataset = datasets_.at(path + "/value");
    dataset.reach({frames_ + 1, 2});
    dataset.write<double>({{frames_, 0}, {1, 2}}, {numbers.data(), 2});
  }
  add_particles(particles);
  if (frame.with_contacts) add_contacts(frame.contacts);
  walls_.add(frame.walls, frames_, {frame.particle_file});
  if (use_ == Use::running) file_.flush();
  put(step_path, frames_, frame.step);
  ++frames_;
}

void SnapshotWriter::add_particles(const std::vector<Particle>& particles) {
  most_particles_ = std::max<std::uint64_t>(most_particles_, particles.size());
  for (const auto& element : snapshot::elements) {
    if ((element.columns() & ~particles_given_) != 0) continue;
    Hdf5Dataset& dataset = datasets_.at(snapshot::discs + std::string(element.name) + "/value");
    Hdf5Shape shape{frames_ + 1, most_particles_};
    Hdf5Block block{{frames_, 0}, {1, particles.size()}};
    if (element.width == 2) {
      shape.push_back(2);
      block.begin.push_back(0);
      block.count.push_back(2);
    }
    dataset.reach(shape);
    if (element.whole()) {
      std::vector<std::int64_t> numbers;
      numbers.reserve(most_particles_);
      for (const Particle& particle : particles)
        numbers.push_back(element.first == ParticleColumn::id ? particle.id : particle.type);
      // Overwrites what an unfinished frame may have left.
      numbers.resize(most_particles_, snapshot::no_id);
      block.count[1] = most_particles_;
      dataset.write<std::int64_t>(block, numbers);
    } else {
      std::vector<double> numbers;
      numbers.reserve(particles.size() * static_cast<std::size_t>(element.width));
      for (const Particle& particle : particles)
        for (int axis = 0; axis < element.width; ++axis)
          numbers.push_back(number_of(particle, element, axis));
      dataset.write<double>(block, numbers);
    }
  }
}

void SnapshotWriter::add_contacts(const ContactRows& rows) {
  const Hdf5Block block{{rows_}, {rows.rows.size()}};
  for (std::size_t slot = 0; slot < std::size(contact_column_names); ++slot) {
    const auto column = static_cast<ContactColumn>(slot);
    if ((contacts_given_ & column_bit(column)) == 0) continue;
    Hdf5Dataset& dataset = datasets_.at(snapshot::contacts + std::string(contact_column_names[slot]));
    dataset.reach({rows_ + rows.rows.size()});
    std::vector<double> numbers;
    numbers.reserve(rows.rows.size());
    for (const ContactRow& row : rows.rows) numbers.push_back(row[column]);
    // HDF5 converts to integers where the dataset holds integers.
    dataset.write<double>(block, numbers);
  }
  rows_ += rows.rows.size();
  put(snapshot::contacts + "offset", frames_ + 1, static_cast<std::int64_t>(rows_));
}

template <typename T>
void SnapshotWriter::put(const std::string& path, std::uint64_t index, T number) {
  Hdf5Dataset& dataset = datasets_.at(path);
  dataset.reach({index + 1});
  dataset.write<T>({{index}, {1}}, std::span<const T>(&number, 1));
}

}  // namespace mikromakro
