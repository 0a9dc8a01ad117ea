#include "io/snapshot_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/particle_reader.h"
#include "io/snapshot_layout.h"

namespace mikromakro {
namespace {

constexpr std::uint64_t most_rows = 0x7fffffff;
const std::string steps_path = "/particles/discs/position/step";

ColumnNames without_option(const ColumnNames& names) {
  return {names.known, names.ignored, ""};
}

std::vector<std::int64_t> all_of(const Hdf5File& file, const std::string& path) {
  const Hdf5Dataset dataset = file.dataset(path);
  const Hdf5Shape shape = dataset.shape();
  std::vector<std::int64_t> numbers(shape.size() == 1 ? shape[0] : 0);
  dataset.read<std::int64_t>({{0}, {numbers.size()}}, numbers);
  return numbers;
}

std::string value_path(const snapshot::Element& element) {
  return snapshot::discs + std::string(element.name) + "/value";
}

std::string contact_path(std::size_t slot) {
  return snapshot::contacts + std::string(contact_column_names[slot]);
}

// The columns that are read: nothing that can be left out. Without any wish (to copy frames) all of them.
ColumnSet wanted_contact_columns(ColumnSet needed, ColumnSet given) {
  constexpr ColumnSet geometry = column_set(ContactColumn::nx, ContactColumn::ny, ContactColumn::overlap);
  constexpr ColumnSet positions = column_set(ContactColumn::x1, ContactColumn::y1, ContactColumn::x2,
                                             ContactColumn::y2, ContactColumn::periodic);
  if (needed == 0) return given;
  const ColumnSet derive_from = (geometry & ~given) != 0 ? positions : 0;
  return given & (needed | geometry | derive_from | column_set(ContactColumn::id1, ContactColumn::id2));
}

void check_finite(double number, const Place& place) {
  if (!std::isfinite(number))
    throw bad_input(place, "not a finite number", "a finite number", fmt::format("{}", number));
}

}  // namespace

SnapshotSummary summarise_snapshots(const Hdf5File& file, const std::string& name) {
  if (!file.has("/h5md") || !file.has(steps_path) || !file.has("/particles/discs/id/value"))
    throw bad_input({name}, "no snapshots in the file",
                    "/h5md and /particles/discs as mikromakro writes them", "neither");
  SnapshotSummary summary;
  summary.steps = all_of(file, steps_path);
  for (const auto& element : snapshot::elements)
    if (file.has(value_path(element))) summary.particles_given |= element.columns();
  const Hdf5Shape shape = file.dataset("/particles/discs/id/value").shape();
  if (shape.size() != 2 || shape[0] != summary.steps.size())
    throw bad_input({name}, "the frames do not fit together",
                    fmt::format("{} frames of ids", summary.steps.size()),
                    fmt::format("{}", shape.empty() ? 0 : shape[0]));
  if (shape[1] > most_rows)
    throw bad_input({name}, "the number of particles is no number of discs", "less than 2^31",
                    fmt::format("{}", shape[1]));
  summary.most_particles = shape[1];
  if (!file.has(snapshot::contacts + "offset")) return summary;
  for (std::size_t slot = 0; slot < std::size(contact_column_names); ++slot)
    if (file.has(contact_path(slot))) summary.contacts_given |= ColumnSet{1} << slot;
  summary.contact_offsets = all_of(file, snapshot::contacts + "offset");
  const auto& offsets = summary.contact_offsets;
  if (offsets.size() != summary.steps.size() + 1 || offsets.front() != 0 ||
      !std::is_sorted(offsets.begin(), offsets.end()))
    throw bad_input({name}, "contacts do not fit the frames", "offsets that ascend, one more than frames",
                    "others");
  const std::uint64_t rows = file.has(contact_path(0)) ? file.dataset(contact_path(0)).shape().front() : 0;
  if (static_cast<std::uint64_t>(offsets.back()) != rows)
    throw bad_input({name}, "contacts are missing", fmt::format("{} rows", offsets.back()),
                    fmt::format("{}", rows));
  return summary;
}

struct SnapshotReader::Open {
  Open(const std::string& name, const ColumnWishes& wishes)
      : file(Hdf5File::open(name)), summary(summarise_snapshots(file, name)) {
    const ColumnMap particles{{}, summary.particles_given};
    require_columns(particles, wishes.particles_needed | particle_base_columns,
                    without_option(particle_names()), {name});
    for (const auto& element : snapshot::elements)
      if ((element.columns() & summary.particles_given) != 0)
        elements.push_back(file.dataset(value_path(element)));
      else
        elements.emplace_back();
    const ColumnMap contacts{{}, summary.contacts_given};
    if (wishes.contacts_needed != 0)
      require_columns(contacts, required_contact_columns(wishes.contacts_needed),
                      without_option(contact_names()), {name});
    for (std::size_t slot = 0; slot < std::size(contact_column_names); ++slot)
      columns.push_back((summary.contacts_given >> slot & 1U) != 0 ? file.dataset(contact_path(slot))
                                                                   : Hdf5Dataset());
    low = file.dataset("/particles/discs/box/low/value");
    edges = file.dataset("/particles/discs/box/edges/value");
    boundary = file.text_attribute("/particles/discs/box", "boundary");
  }

  Hdf5File file;
  SnapshotSummary summary;
  std::vector<Hdf5Dataset> elements;
  std::vector<Hdf5Dataset> columns;
  Hdf5Dataset low, edges;
  std::vector<std::string> boundary;
};

SnapshotReader::SnapshotReader(std::vector<std::string> files, ColumnWishes wishes)
    : files_(std::move(files)), wishes_(std::move(wishes)) {}

SnapshotReader::~SnapshotReader() = default;

std::string SnapshotReader::place() const {
  return fmt::format("{}:frame {}", files_[opened_ - 1], frame_ - 1);
}

bool SnapshotReader::open_next() {
  if (opened_ == files_.size()) return false;
  const std::string& file = files_[opened_++];
  open_ = std::make_unique<Open>(file, wishes_);
  frame_ = 0;
  return true;
}

bool SnapshotReader::next(std::int64_t& step) {
  while (!open_ || frame_ == open_->summary.steps.size())
    if (!open_next()) return false;
  step = open_->summary.steps[frame_++];
  if (step <= last_step_)
    throw bad_input({place()}, "time steps do not ascend", fmt::format("more than {}", last_step_),
                    fmt::format("{}", step));
  last_step_ = step;
  return true;
}

void SnapshotReader::read(RawFrame& frame) {
  frame.step = last_step_;
  read_box(frame.box);
  read_particles(frame);
  frame.with_contacts = !open_->summary.contact_offsets.empty();
  if (frame.with_contacts) read_contacts(frame);
}

void SnapshotReader::read_box(Box& box) const {
  Eigen::Vector2d length;
  open_->low.read<double>({{frame_ - 1, 0}, {1, 2}}, {box.low.data(), 2});
  open_->edges.read<double>({{frame_ - 1, 0}, {1, 2}}, {length.data(), 2});
  box.high = box.low + length;
  for (std::size_t axis = 0; axis < 2; ++axis)
    box.periodic[axis] = axis < open_->boundary.size() && open_->boundary[axis] == "periodic";
}

void SnapshotReader::read_particles(RawFrame& frame) const {
  const std::string where = place();
  const std::uint64_t places = open_->summary.most_particles;
  std::vector<std::int64_t> ids(places);
  open_->elements.front().read<std::int64_t>({{frame_ - 1, 0}, {1, places}}, ids);
  const auto count =
      static_cast<std::uint64_t>(std::find(ids.begin(), ids.end(), snapshot::no_id) - ids.begin());
  constexpr auto width = static_cast<std::size_t>(ParticleColumn::count);
  std::vector<ParticleSlots> slots(count);
  for (auto& slot : slots) slot.fill(not_given);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < std::size(snapshot::elements); ++i) {
    const auto& element = snapshot::elements[i];
    if ((element.columns() & ~open_->summary.particles_given) != 0) continue;
    const auto per_disc = static_cast<std::uint64_t>(element.width);
    numbers.resize(count * per_disc);
    const Hdf5Block block = per_disc == 1 ? Hdf5Block{{frame_ - 1, 0}, {1, count}}
                                          : Hdf5Block{{frame_ - 1, 0, 0}, {1, count, per_disc}};
    open_->elements[i].read<double>(block, numbers);
    const auto first = static_cast<std::size_t>(element.first);
    for (std::size_t disc = 0; disc < count; ++disc) {
      for (std::size_t axis = 0; axis < per_disc && first + axis < width; ++axis) {
        slots[disc][first + axis] = numbers[disc * per_disc + axis];
        check_finite(slots[disc][first + axis], {where, static_cast<std::int64_t>(disc) + 1});
      }
    }
  }
  frame.particle_file = where;
  frame.first_particle_line = 1;
  frame.particles_given = open_->summary.particles_given;
  frame.particles.clear();
  for (std::size_t disc = 0; disc < count; ++disc)
    frame.particles.push_back(
        particle_of(slots[disc], frame.particles_given, {where, static_cast<std::int64_t>(disc) + 1}));
}

void SnapshotReader::read_contacts(RawFrame& frame) const {
  const auto& offsets = open_->summary.contact_offsets;
  const auto begin = static_cast<std::uint64_t>(offsets[frame_ - 1]);
  const std::uint64_t count = static_cast<std::uint64_t>(offsets[frame_]) - begin;
  ContactRows& rows = frame.contacts;
  rows.file = place();
  rows.first_line = 1;
  rows.given = wanted_contact_columns(wishes_.contacts_needed, open_->summary.contacts_given);
  rows.needed = wishes_.contacts_needed;
  ContactRow empty{};
  empty.value.fill(not_given);
  rows.rows.assign(count, empty);
  std::vector<double> numbers(count);
  for (std::size_t slot = 0; slot < open_->columns.size(); ++slot) {
    if ((rows.given >> slot & 1U) == 0) continue;
    open_->columns[slot].read<double>({{begin}, {count}}, numbers);
    for (std::size_t i = 0; i < count; ++i) rows.rows[i].value[slot] = numbers[i];
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t slot = 0; slot < open_->columns.size(); ++slot)
      if ((rows.given >> slot & 1U) != 0) check_finite(rows.rows[i].value[slot], rows.place(i));
    check_contact_row(rows.rows[i], rows.given, false, rows.place(i));
  }
}

}  // namespace mikromakro
