// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/averager.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "averaging/periodic_images.h"

namespace mikromakro {

// Memory reused for every disc of a frame.
struct Averager::Scratch {
  Bulk bulk;
  Rows given;  // empty if no field is the caller's own
  std::vector<Eigen::Vector2d> images;
  ShareSums shares;
  Eigen::Matrix2d basis;
  Disc disc;
  std::vector<DiscContact> contacts;
  Eigen::Array<double, 1, Eigen::Dynamic> quantity;
};

namespace {

Branch branch_of(Branch given, const Weight& weight) {
  if (given != Branch::by_weight) return given;
  return weight.is_kernel() ? Branch::contact : Branch::radius;
}

// Indices of the fields whose columns a field uses, all of which precede it.
std::vector<std::size_t> find_sources(const FieldList& fields, std::size_t of) {
  std::vector<std::size_t> sources;
  for (const std::string_view name : fields[of].field->sources()) {
    std::size_t source = 0;
    while (source < of && fields[source].field->name() != name) ++source;
    if (source == of) throw std::logic_error("a field stands before its source");
    sources.push_back(source);
  }
  return sources;
}

}  // namespace

Averager::Averager(std::unique_ptr<const Volumes> volumes, std::unique_ptr<const Weight> weight,
                   FieldList fields, const AveragingOptions& options)
    : volumes_(std::move(volumes)),
      weight_(std::move(weight)),
      shares_(weight_->in(*volumes_)),
      fields_(std::move(fields)),
      offsets_{0},
      options_(options),
      branch_(branch_of(options.branch, *weight_)) {
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    offsets_.push_back(offsets_.back() + static_cast<std::size_t>(fields_[i].field->sums()));
    sources_.push_back(find_sources(fields_, i));
    const ContactPlace place = fields_[i].field->contact_place();
    on_branches_ |= shares_->of_places() && place == ContactPlace::branch;
    at_walls_ |= shares_->of_places() && place == ContactPlace::wall_point;
  }
}

bool Averager::is_bulk(const Particle& particle) const {
  const auto& types = options_.bulk_types;
  return types.empty() || std::find(types.begin(), types.end(), particle.type) != types.end();
}

Averager::Bulk Averager::bulk_of(const Frame& frame) const {
  Bulk bulk;
  bulk.holds.assign(frame.particles.size(), true);
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < frame.particles.size(); ++i) {
    if (!is_bulk(frame.particles[i])) {
      bulk.holds[i] = false;
      continue;
    }
    sum += frame.particles[i].radius;
    ++count;
  }
  bulk.mean_radius = sum / count;
  return bulk;
}

Rows Averager::frame_sums(const Frame& frame) const {
  Rows sums = Rows::Zero(volumes_->count(), static_cast<Eigen::Index>(offsets_.back()));
  const ContactLists lists(frame);
  const PeriodicImages images(frame.box, volumes_->bounds());
  Scratch scratch;
  scratch.quantity.resize(sums.cols());
  scratch.bulk = bulk_of(frame);
  if (options_.given) scratch.given = options_.given(frame);
  for (int i = 0; i < static_cast<int>(frame.particles.size()); ++i) {
    if (!scratch.bulk.holds[static_cast<std::size_t>(i)]) continue;
    const auto ends = lists.of(i);
    const Eigen::Vector2d& position = frame.particles[static_cast<std::size_t>(i)].position;
    if (!images.any()) {
      add_image(frame, i, position, ends, scratch, sums);
      continue;
    }
    images.of(position, reach_of(frame, i, ends), scratch.images);
    for (const Eigen::Vector2d& centre : scratch.images) add_image(frame, i, centre, ends, scratch, sums);
  }
  return sums;
}

// Distance from its centre within which a disc or its branches may contribute.
double Averager::reach_of(const Frame& frame, int particle, std::span<const ContactEnd> ends) const {
  const double radius = frame.particles[static_cast<std::size_t>(particle)].radius;
  const double reach = shares_->reach(radius);
  if (!on_branches_ && !at_walls_) return reach;
  double longest = 0;
  for (const ContactEnd& end : ends) {
    const double cut = cut_of(frame.contacts[static_cast<std::size_t>(end.contact)]);
    longest = std::max(longest, std::abs(radius - cut));
  }
  return reach + longest;
}

void Averager::add_image(const Frame& frame, int particle, const Eigen::Vector2d& centre,
                         std::span<const ContactEnd> ends, Scratch& scratch, Rows& sums) const {
  scratch.shares.clear();
  shares_->of_disc(centre, frame.particles[static_cast<std::size_t>(particle)].radius, scratch.shares);
  // A branch may extend into volumes that its disc does not overlap.
  if (scratch.shares.list().empty() && !on_branches_ && !at_walls_) return;
  collect(frame, particle, centre, ends, scratch);
  for (const Share& share : scratch.shares.list()) sums.row(share.volume) += share.weight * scratch.quantity;
  if (on_branches_ || at_walls_) add_placed(centre, scratch, sums);
}

// By how much a branch is shorter than the radius of its disc.
double Averager::cut_of(const Contact& contact) const {
  if (branch_ == Branch::radius) return 0;
  return contact.with_wall() ? contact.overlap : 0.5 * contact.overlap;
}

DiscContact Averager::contact_of(const Frame& frame, const ContactEnd& end, const Scratch& scratch) const {
  const Contact& contact = frame.contacts[static_cast<std::size_t>(end.contact)];
  const double side = end.first ? 1.0 : -1.0;
  const Eigen::Vector2d normal = scratch.basis * (side * contact.normal);
  const int partner = end.first ? contact.index2 : contact.index1;
  const bool with_wall = partner < 0 || !scratch.bulk.holds[static_cast<std::size_t>(partner)];
  return {normal,
          scratch.basis * (side * contact.force),
          (scratch.disc.radius - cut_of(contact)) * normal,
          contact.overlap,
          contact.spring,
          with_wall};
}

// V^p Q^p of one image of a disc for all fields, in the basis at its centre; without contacts that have their
// own weights.
void Averager::collect(const Frame& frame, int particle, const Eigen::Vector2d& centre,
                       std::span<const ContactEnd> ends, Scratch& scratch) const {
  const Particle& from = frame.particles[static_cast<std::size_t>(particle)];
  scratch.basis = volumes_->basis(centre);
  Disc& disc = scratch.disc;
  disc.volume = std::numbers::pi * from.radius * from.radius * volumes_->height();
  disc.radius = from.radius;
  disc.mass = from.mass;
  disc.velocity = scratch.basis * from.velocity;
  disc.spin = from.spin;
  disc.contacts = frame.contacts_known ? static_cast<int>(ends.size()) : Disc::unknown;
  disc.mean_radius = scratch.bulk.mean_radius;
  if (const Rows& given = scratch.given; given.size() > 0)
    disc.given = {given.row(particle).data(), static_cast<std::size_t>(given.cols())};
  scratch.contacts.clear();
  for (const ContactEnd& end : ends) scratch.contacts.push_back(contact_of(frame, end, scratch));
  scratch.quantity.setZero();
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const Field& field = *fields_[i].field;
    const std::span<double> quantity(scratch.quantity.data() + offsets_[i], offsets_[i + 1] - offsets_[i]);
    field.add_disc(disc, quantity);
    if (field.contact_place() == ContactPlace::disc || !shares_->of_places())
      field.add_contacts(disc, scratch.contacts, quantity);
  }
}

// Contacts of one disc, for the fields that attribute them to places other than the disc.
void Averager::add_placed(const Eigen::Vector2d& centre, Scratch& scratch, Rows& sums) const {
  for (const DiscContact& contact : scratch.contacts) {
    const Eigen::Vector2d branch = scratch.basis.transpose() * contact.branch;
    if (on_branches_) {
      scratch.shares.clear();
      shares_->of_branch(centre, branch, scratch.shares);
      add_contact(ContactPlace::branch, contact, scratch, sums);
    }
    if (!at_walls_ || !contact.with_wall) continue;
    scratch.shares.clear();
    shares_->of_point(centre + branch, scratch.shares);
    add_contact(ContactPlace::wall_point, contact, scratch, sums);
  }
}

void Averager::add_contact(ContactPlace place, const DiscContact& contact, Scratch& scratch,
                           Rows& sums) const {
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const Field& field = *fields_[i].field;
    if (field.contact_place() != place) continue;
    const auto offset = static_cast<Eigen::Index>(offsets_[i]);
    auto quantity = scratch.quantity.segment(offset, field.sums());
    quantity.setZero();
    field.add_contacts(scratch.disc, {&contact, 1},
                       {quantity.data(), static_cast<std::size_t>(field.sums())});
    for (const Share& share : scratch.shares.list())
      sums.row(share.volume).segment(offset, field.sums()) += share.weight * quantity;
  }
}

}  // namespace mikromakro
