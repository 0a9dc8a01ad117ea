// SPDX-License-Identifier: GPL-2.0-or-later
// How discs count in the volumes: one of the three independent choices (volumes, weight, fields).
#pragma once

#include <memory>
#include <string>

#include "averaging/shares.h"
#include "averaging/volumes/volumes.h"

namespace mikromakro {

/// w^p of Latzel2001 Eq. 4.
class Weight {
 public:
  Weight() = default;
  Weight(const Weight&) = delete;
  Weight& operator=(const Weight&) = delete;
  virtual ~Weight() = default;

  /// The weight applied to these volumes, which must outlive the result.
  virtual std::unique_ptr<const Shares> in(const Volumes& volumes) const = 0;
  /// Whether contacts count along their branches rather than where their disc does.
  virtual bool is_kernel() const { return false; }
};

/// The exact fraction of the disc's area in each volume.
class SlicedWeight : public Weight {
 public:
  std::unique_ptr<const Shares> in(const Volumes& volumes) const override;
};

/// 1 in the volume that contains the disc's centre.
class CentreWeight : public Weight {
 public:
  std::unique_ptr<const Shares> in(const Volumes& volumes) const override;
};

/// From the name given to --weight: sliced, centre, or a kernel with its width in m, gauss:W, lucy:W,
/// wendland:W, tophat:W (averaging/kernels/kernel_weight.h). Throws on any other name.
std::unique_ptr<const Weight> make_weight(const std::string& name);

}  // namespace mikromakro
