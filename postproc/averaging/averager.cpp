#include "averaging/averager.h"

#include <algorithm>
#include <numbers>

namespace mikromakro {

// Memory used again for every disc of a frame.
struct Averager::Scratch {
  std::vector<Share> shares;
  std::vector<DiscContact> contacts;
  Eigen::Array<double, 1, Eigen::Dynamic> quantity;
};

Averager::Averager(std::unique_ptr<const Volumes> volumes, std::unique_ptr<const Weight> weight,
                   FieldList fields, const AveragingOptions& options)
    : volumes_(std::move(volumes)),
      weight_(std::move(weight)),
      fields_(std::move(fields)),
      offsets_{0},
      options_(options) {
  for (const auto& field : fields_)
    offsets_.push_back(offsets_.back() + static_cast<std::size_t>(field->sums()));
}

bool Averager::is_bulk(const Particle& particle) const {
  const auto& types = options_.bulk_types;
  return types.empty() || std::find(types.begin(), types.end(), particle.type) != types.end();
}

Rows Averager::frame_sums(const Frame& frame) const {
  Rows sums = Rows::Zero(volumes_->count(), static_cast<Eigen::Index>(offsets_.back()));
  const ContactLists lists(frame);
  Scratch scratch;
  scratch.quantity.resize(sums.cols());
  for (int i = 0; i < static_cast<int>(frame.particles.size()); ++i) {
    const Particle& particle = frame.particles[static_cast<std::size_t>(i)];
    if (!is_bulk(particle)) continue;
    weight_->shares(*volumes_, particle.position, particle.radius, scratch.shares);
    if (scratch.shares.empty()) continue;
    collect(frame, i, lists.of(i), scratch);
    for (const Share& share : scratch.shares) sums.row(share.volume) += share.weight * scratch.quantity;
  }
  return sums;
}

// V^p Q^p of one disc for all fields, in the basis at its centre.
void Averager::collect(const Frame& frame, int particle, std::span<const ContactEnd> ends,
                       Scratch& scratch) const {
  const Particle& from = frame.particles[static_cast<std::size_t>(particle)];
  const Eigen::Matrix2d basis = volumes_->basis(from.position);
  scratch.contacts.clear();
  for (const ContactEnd& end : ends) {
    const Contact& contact = frame.contacts[static_cast<std::size_t>(end.contact)];
    const double side = end.first ? 1.0 : -1.0;
    const Eigen::Vector2d normal = basis * (side * contact.normal);
    const double cut = options_.branch == Branch::radius ? 0.0
                       : contact.with_wall()             ? contact.overlap
                                                         : 0.5 * contact.overlap;
    scratch.contacts.push_back(
        {normal, basis * (side * contact.force), (from.radius - cut) * normal, contact.overlap});
  }
  Disc disc;
  disc.volume = std::numbers::pi * from.radius * from.radius * volumes_->height();
  disc.radius = from.radius;
  disc.mass = from.mass;
  disc.velocity = basis * from.velocity;
  disc.spin = from.spin;
  disc.contacts = static_cast<int>(ends.size());
  scratch.quantity.setZero();
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const std::span<double> quantity(scratch.quantity.data() + offsets_[i], offsets_[i + 1] - offsets_[i]);
    fields_[i]->add_disc(disc, quantity);
    fields_[i]->add_contacts(disc, scratch.contacts, quantity);
  }
}

Table Averager::solve(const Rows& mean_sums) const {
  const VolumeData data{volumes_->measure()};
  Table table;
  table.columns = volumes_->columns();
  std::vector<Eigen::Index> begin;
  for (const auto& field : fields_) {
    begin.push_back(static_cast<Eigen::Index>(table.columns.size()));
    for (Column& column : field->columns(volumes_->axes())) table.columns.push_back(std::move(column));
  }
  begin.push_back(static_cast<Eigen::Index>(table.columns.size()));
  table.rows.resize(volumes_->count(), begin.back());
  table.rows.leftCols(begin.front()) = volumes_->coordinates();
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const auto sums = mean_sums.middleCols(static_cast<Eigen::Index>(offsets_[i]), fields_[i]->sums());
    fields_[i]->solve(data, sums, table.rows.middleCols(begin[i], begin[i + 1] - begin[i]));
  }
  return table;
}

ColumnSet Averager::particles_needed() const {
  ColumnSet needed = options_.bulk_types.empty() ? 0 : column_set(ParticleColumn::type);
  for (const auto& field : fields_) needed |= field->particles_needed();
  return needed;
}

ColumnSet Averager::contacts_needed() const {
  ColumnSet needed = options_.branch == Branch::contact ? column_set(ContactColumn::overlap) : 0;
  for (const auto& field : fields_) needed |= field->contacts_needed();
  return needed;
}

bool Averager::needs_contacts() const {
  return std::any_of(fields_.begin(), fields_.end(),
                     [](const auto& field) { return field->needs_contacts(); });
}

}  // namespace mikromakro
