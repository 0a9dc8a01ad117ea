// SPDX-License-Identifier: GPL-2.0-or-later
// How a disc counts in the volumes: one of the three independent choices (volumes, weight, fields).
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

  /// What it makes of these volumes, which must live as long as the result.
  virtual std::unique_ptr<const Shares> in(const Volumes& volumes) const = 0;
  /// Whether contacts count along their branches, not where their disc is.
  virtual bool is_kernel() const { return false; }
};

/// The exact part of the disc's area in each volume.
class SlicedWeight : public Weight {
 public:
  std::unique_ptr<const Shares> in(const Volumes& volumes) const override;
};

/// 1 in the volume that holds the disc's centre.
class CentreWeight : public Weight {
 public:
  std::unique_ptr<const Shares> in(const Volumes& volumes) const override;
};

/// By the name given to --weight: sliced, centre, or a kernel with its width in m, gauss:W, lucy:W,
/// wendland:W, tophat:W (averaging/kernel_weight.h). Throws on any other.
std::unique_ptr<const Weight> make_weight(const std::string& name);

}  // namespace mikromakro
