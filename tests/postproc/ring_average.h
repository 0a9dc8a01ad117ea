// SPDX-License-Identifier: GPL-2.0-or-later
// Averages of one frame over rings or other volumes, by column names: what most tests look at.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "averaging/averager.h"
#include "averaging/volumes/ring_volumes.h"
#include "averaging/weight.h"

namespace mikromakro {

/// What is averaged, and how.
struct AverageSetup {
  std::string weight = "sliced";
  AveragingOptions options = {};
  std::vector<std::string> fields = {};
  FieldOptions field_options = {};
};

/// Averages over any volumes.
class VolumeAverage {
 public:
  VolumeAverage(const Frame& frame, std::unique_ptr<const Volumes> volumes, const AverageSetup& setup) {
    const Averager averager(std::move(volumes), make_weight(setup.weight),
                            make_fields(setup.fields, setup.field_options), setup.options);
    const Rows sums = averager.frame_sums(frame);
    table_ = averager.solve(sums);
    notes_ = averager.notes(sums);
  }

  double at(const std::string& column, int volume = 0) const {
    for (std::size_t i = 0; i < table_.columns.size(); ++i)
      if (table_.columns[i].name == column) return table_.rows(volume, static_cast<Eigen::Index>(i));
    ADD_FAILURE() << "no column " << column;
    return 0;
  }

  const Table& table() const { return table_; }
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  Table table_;
  std::vector<std::string> notes_;
};

struct RingSetup {
  std::vector<double> edges;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double height = 1;
  std::string weight = "sliced";
  AveragingOptions options = {};
  std::vector<std::string> fields = {};
  FieldOptions field_options = {};
};

class RingAverage : public VolumeAverage {
 public:
  RingAverage(const Frame& frame, const RingSetup& setup)
      : VolumeAverage(frame, std::make_unique<const RingVolumes>(setup.centre, setup.edges, setup.height),
                      {setup.weight, setup.options, setup.fields, setup.field_options}) {}
};

inline Particle make_disc(std::int64_t id, const Eigen::Vector2d& position, double radius, int type = 1) {
  Particle disc;
  disc.id = id;
  disc.type = type;
  disc.position = position;
  disc.radius = radius;
  disc.velocity = {0, 0};
  disc.spin = 0;
  disc.mass = 1;
  return disc;
}

/// Contact of particles i and j (by index) with the elastic force k_n overlap, from their positions.
inline Contact make_contact(const Frame& frame, int i, int j, double k_n) {
  const Particle& one = frame.particles[static_cast<std::size_t>(i)];
  const Particle& two = frame.particles[static_cast<std::size_t>(j)];
  const Eigen::Vector2d branch = two.position - one.position;
  Contact contact;
  contact.id1 = one.id;
  contact.id2 = two.id;
  contact.index1 = i;
  contact.index2 = j;
  contact.normal = branch.normalized();
  contact.overlap = one.radius + two.radius - branch.norm();
  contact.force = -k_n * contact.overlap * contact.normal;
  return contact;
}

}  // namespace mikromakro
