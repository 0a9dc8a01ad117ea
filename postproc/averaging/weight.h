// How a disc counts in the volumes: one of the three independent choices (volumes, weight, fields).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "averaging/volumes.h"

namespace mikromakro {

/// w^p of seed Eq. 4, for all volumes at once.
class Weight {
 public:
  Weight() = default;
  Weight(const Weight&) = delete;
  Weight& operator=(const Weight&) = delete;
  virtual ~Weight() = default;

  /// Replaces `shares` by the volumes in which the disc counts, and by how much (dimensionless).
  virtual void shares(const Volumes& volumes, const Eigen::Vector2d& centre, double radius,
                      std::vector<Share>& shares) const = 0;
};

/// The exact part of the disc's area in each volume.
class SlicedWeight : public Weight {
 public:
  void shares(const Volumes& volumes, const Eigen::Vector2d& centre, double radius,
              std::vector<Share>& shares) const override;
};

/// 1 in the volume that holds the disc's centre.
class CentreWeight : public Weight {
 public:
  void shares(const Volumes& volumes, const Eigen::Vector2d& centre, double radius,
              std::vector<Share>& shares) const override;
};

/// By the name given to --weight: sliced or centre. Throws on any other.
std::unique_ptr<const Weight> make_weight(const std::string& name);

}  // namespace mikromakro
