// What an averaged quantity is: sums over discs and their contacts, and what is solved from them.
#pragma once

#include <array>
#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/column_map.h"
#include "io/table.h"

namespace mikromakro {

/// A disc as fields see it: vectors in the basis of the averaging volumes at the disc's centre (SI units).
struct Disc {
  double volume = 0;  ///< V^p = pi a^2 h, m^3
  double radius = 0;
  double mass = 0;
  Eigen::Vector2d velocity;
  double spin = 0;   ///< omega_z, rad/s
  int contacts = 0;  ///< number of its contacts, walls and wall discs included
};

/// A contact as seen from that disc, in the same basis.
struct DiscContact {
  Eigen::Vector2d normal;  ///< n, from the disc outward
  Eigen::Vector2d force;   ///< f^c on the disc, N
  Eigen::Vector2d branch;  ///< l^pc, m
  double overlap = 0;      ///< m, > 0
};

/// Names of the two directions: {"r", "phi"} or {"x", "y"}.
using Axes = std::array<std::string, 2>;

/// Blocks of such tables; rows are volumes.
using ConstRowsRef = Eigen::Ref<const Rows, 0, Eigen::OuterStride<>>;
using RowsRef = Eigen::Ref<Rows, 0, Eigen::OuterStride<>>;

/// The volumes over which was averaged, as far as solving needs them.
struct VolumeData {
  Eigen::ArrayXd measure;  ///< V = area * h of each volume, m^3
};

/// A field declares the quantity V^p Q^p of one disc in Eq. 4, Q = 1/V sum_p w^p V^p Q^p, as a list of
/// numbers, split into what comes from the disc and what comes from its contacts. The averager does the
/// weighting, the sum over discs and the mean over frames; the field then solves its columns from the summed
/// numbers. Fields have no state.
class Field {
 public:
  Field() = default;
  Field(const Field&) = delete;
  Field& operator=(const Field&) = delete;
  virtual ~Field() = default;

  /// Name for --fields.
  virtual std::string_view name() const = 0;
  virtual std::vector<Column> columns(const Axes& axes) const = 0;

  /// Columns of the dumps without which the field has no value.
  virtual ColumnSet particles_needed() const { return 0; }
  virtual ColumnSet contacts_needed() const { return 0; }
  /// Whether there must be contacts at all.
  virtual bool needs_contacts() const { return false; }

  /// How many numbers are summed; the spans below have this length.
  virtual int sums() const = 0;
  /// Adds the disc's own part to `quantity`.
  virtual void add_disc(const Disc& disc, std::span<double> quantity) const = 0;
  /// Adds the part of some of its contacts.
  virtual void add_contacts(const Disc& disc, std::span<const DiscContact> contacts,
                            std::span<double> quantity) const;

  /// From sums (volumes x sums()) to columns (volumes x columns().size()); nan where a value is undefined.
  virtual void solve(const VolumeData& volumes, const ConstRowsRef& sums, RowsRef columns) const = 0;
};

inline void Field::add_contacts(const Disc& /*disc*/, std::span<const DiscContact> /*contacts*/,
                                std::span<double> /*quantity*/) const {}

/// The four columns of a tensor, row by row: `name`_rr, `name`_rphi, `name`_phir, `name`_phiphi.
std::vector<Column> tensor_columns(std::string_view name, const Axes& axes, const Column& like);

/// Adds a (x) b to four sums in the same order.
inline void add_dyad(const Eigen::Vector2d& a, const Eigen::Vector2d& b, std::span<double> sums) {
  sums[0] += a[0] * b[0];
  sums[1] += a[0] * b[1];
  sums[2] += a[1] * b[0];
  sums[3] += a[1] * b[1];
}

}  // namespace mikromakro
