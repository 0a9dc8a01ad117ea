#include "io/snapshot_writer.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/snapshot_layout.h"

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

// One of two components alone has no place in the layout.
ColumnSet storable(ColumnSet given) {
  ColumnSet stored = 0;
  for (const auto& element : snapshot::elements)
    if ((element.columns() & ~given) == 0) stored |= element.columns();
  return stored;
}

}  // namespace

SnapshotWriter::SnapshotWriter(const std::string& file, const std::string& program, double time_step)
    : file_(Hdf5File::create(file)), program_(program), time_step_(time_step) {}

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
  datasets_[step_path] = file_.add_growing(step_path, Hdf5Type::integer, {steps_per_chunk});
  if (time_step_ > 0) {
    datasets_[time_path] = file_.add_growing(time_path, Hdf5Type::real, {steps_per_chunk});
    file_.attribute(time_path, "unit", std::string("s"));
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
  file_.attribute("/particles/discs/box", "dimension", std::int64_t{2});
  file_.attribute("/particles/discs/box", "boundary", boundary(frame.box));
  periodic_ = frame.box.periodic;
  if (frame.with_contacts) begin_contacts(frame);
}

void SnapshotWriter::begin_element(const std::string& path, Hdf5Type type, const Hdf5Shape& chunk,
                                   std::string_view unit) {
  const std::string value = path + "/value";
  datasets_[value] = file_.add_growing(value, type, chunk, snapshot::no_id);
  if (!unit.empty()) file_.attribute(value, "unit", std::string(unit));
  if (path + "/step" == step_path) return;
  file_.link(step_path, path + "/step");
  if (time_step_ > 0) file_.link(time_path, path + "/time");
}

void SnapshotWriter::begin_contacts(const RawFrame& frame) {
  contacts_given_ = frame.contacts.given;
  constexpr std::uint64_t fewest = 1024;
  const std::uint64_t chunk = std::max<std::uint64_t>(frame.contacts.rows.size(), fewest);
  datasets_[snapshot::contacts + "offset"] =
      file_.add_growing(snapshot::contacts + "offset", Hdf5Type::integer, {steps_per_chunk});
  append(snapshot::contacts + "offset", std::int64_t{0});
  for (std::size_t slot = 0; slot < std::size(contact_column_names); ++slot) {
    const auto column = static_cast<ContactColumn>(slot);
    if ((contacts_given_ & column_bit(column)) == 0) continue;
    const std::string path = snapshot::contacts + std::string(contact_column_names[slot]);
    datasets_[path] =
        file_.add_growing(path, snapshot::whole(column) ? Hdf5Type::integer : Hdf5Type::real, {chunk});
    if (!snapshot::contact_units[slot].empty())
      file_.attribute(path, "unit", std::string(snapshot::contact_units[slot]));
  }
  file_.link(step_path, snapshot::contacts + "step");
  if (time_step_ > 0) file_.link(time_path, snapshot::contacts + "time");
}

void SnapshotWriter::check_same(const RawFrame& frame) const {
  const Place place{frame.particle_file, frame.first_particle_line - 1};
  if (storable(frame.particles_given) != particles_given_ ||
      (frame.with_contacts ? frame.contacts.given : 0) != contacts_given_)
    throw bad_input(place, "the columns change", "the columns of the first frame", "others");
  if (frame.box.periodic != periodic_)
    throw bad_input(place, "the boundaries change", "those of the first frame", "others");
}

void SnapshotWriter::add(const RawFrame& frame, const std::vector<Particle>& particles) {
  if (frames_ == 0) begin(frame, particles.size());
  check_same(frame);
  append(step_path, frame.step);
  if (time_step_ > 0) append(time_path, time_step_ * static_cast<double>(frame.step));
  const Eigen::Vector2d length = frame.box.length();
  for (const auto& [path, numbers] : {std::pair(edges_path, length), std::pair(low_path, frame.box.low)}) {
    Hdf5Dataset& dataset = datasets_.at(path + "/value");
    dataset.grow({frames_ + 1, 2});
    dataset.write<double>({{frames_, 0}, {1, 2}}, {numbers.data(), 2});
  }
  add_particles(particles);
  if (frame.with_contacts) add_contacts(frame.contacts);
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
    dataset.grow(shape);
    if (element.whole()) {
      std::vector<std::int64_t> numbers;
      numbers.reserve(particles.size());
      for (const Particle& particle : particles)
        numbers.push_back(element.first == ParticleColumn::id ? particle.id : particle.type);
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
    dataset.grow({rows_ + rows.rows.size()});
    std::vector<double> numbers;
    numbers.reserve(rows.rows.size());
    for (const ContactRow& row : rows.rows) numbers.push_back(row[column]);
    // HDF5 turns whole numbers into integers on the way.
    dataset.write<double>(block, numbers);
  }
  rows_ += rows.rows.size();
  append(snapshot::contacts + "offset", static_cast<std::int64_t>(rows_));
}

void SnapshotWriter::append(const std::string& path, double number) {
  Hdf5Dataset& dataset = datasets_.at(path);
  const std::uint64_t size = dataset.shape().front();
  dataset.grow({size + 1});
  dataset.write<double>({{size}, {1}}, {&number, 1});
}

void SnapshotWriter::append(const std::string& path, std::int64_t number) {
  Hdf5Dataset& dataset = datasets_.at(path);
  const std::uint64_t size = dataset.shape().front();
  dataset.grow({size + 1});
  dataset.write<std::int64_t>({{size}, {1}}, {&number, 1});
}

}  // namespace mikromakro
