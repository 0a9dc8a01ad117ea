// SPDX-License-Identifier: GPL-2.0-or-later
// What an averaged quantity is: sums over discs and their contacts, and what is solved from them.
#pragma once

#include <array>
#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/columns.h"
#include "model/table.h"

namespace mikromakro {

/// A disc as fields see it: vectors in the basis of the averaging volumes at the disc's centre (SI units).
struct Disc {
  double volume = 0;  ///< V^p = pi a^2 h, m^3
  double radius = 0;
  double mass = 0;
  Eigen::Vector2d velocity;
  double spin = 0;  ///< omega_z, rad/s
  /// Number of its contacts, walls and wall discs included; `unknown` where there is no file of contacts.
  int contacts = 0;
  static constexpr int unknown = -1;
  double mean_radius = 0;  ///< of all averaged discs of the frame, by number
};

/// A contact as seen from that disc, in the same basis.
struct DiscContact {
  Eigen::Vector2d normal;  ///< n, from the disc outward
  Eigen::Vector2d force;   ///< f^c on the disc, N
  Eigen::Vector2d branch;  ///< l^pc, m
  double overlap = 0;      ///< m, > 0
  double spring = 0;       ///< slip xi along t = (-n_y, n_x), the same from either disc; nan: not in the dump
  bool with_wall = false;  ///< its partner is a wall or a disc that is not averaged

  Eigen::Vector2d tangent() const { return {-normal[1], normal[0]}; }
};

/// How many of the columns side by side are of one field.
struct ColumnsOfField {
  std::string name;
  Eigen::Index count = 0;
  std::vector<double> periods = {};  ///< of each column, see Column; empty: none is an angle
};

/// Names of the two directions: {"r", "phi"} or {"x", "y"}.
using Axes = std::array<std::string, 2>;

/// Blocks of such tables; rows are volumes.
using ConstRowsRef = Eigen::Ref<const Rows, 0, Eigen::OuterStride<>>;
using RowsRef = Eigen::Ref<Rows, 0, Eigen::OuterStride<>>;

/// The volumes over which was averaged, as far as solving needs them.
struct VolumeData {
  Eigen::ArrayXd measure;  ///< V = area * h of each volume, m^3
  double height = 0;       ///< h, m
  Eigen::ArrayXd radius;   ///< r of each ring, ascending, m; empty where the volumes are no rings
};

/// Where a contact counts when the weight is a kernel (docs/conventions.md, Kernels). With other weights it
/// counts as its disc does.
enum class ContactPlace {
  disc,        ///< at the disc's centre, as what belongs to the disc does
  branch,      ///< along its branch, as the force that runs through it
  wall_point,  ///< at the end of its branch, where the wall begins; contacts with averaged discs are left out
};

/// A field declares the quantity V^p Q^p of one disc in Eq. 4, Q = 1/V sum_p w^p V^p Q^p, as a list of
/// numbers, split into what comes from the disc and what comes from its contacts. The averager does the
/// weighting, the sum over discs and the mean over frames; the field then solves its columns from the summed
/// numbers. Instead of sums, or beside them, a field may take the columns of other fields. Fields have no
/// state but the options with which they were made.
class Field {
 public:
  Field() = default;
  Field(const Field&) = delete;
  Field& operator=(const Field&) = delete;
  virtual ~Field() = default;

  /// Name for --fields.
  virtual std::string_view name() const = 0;
  virtual std::vector<Column> columns(const Axes& axes) const = 0;
  /// Names of the fields whose columns solve() takes. They stand before this one in the registry.
  virtual std::vector<std::string_view> sources() const { return {}; }

  /// The option without which the field has no value and which was not given; empty: none.
  virtual std::string_view missing_option() const { return {}; }

  /// Columns of the dumps without which the field has no value.
  virtual ColumnSet particles_needed() const { return 0; }
  virtual ColumnSet contacts_needed() const { return 0; }
  /// Whether there must be contacts at all.
  virtual bool needs_contacts() const { return false; }

  /// Where its contacts count. Other places than the disc get them one at a time.
  virtual ContactPlace contact_place() const { return ContactPlace::disc; }

  /// How many numbers are summed; the spans below have this length.
  virtual int sums() const { return 0; }
  /// Adds the disc's own part to `quantity`.
  virtual void add_disc(const Disc& disc, std::span<double> quantity) const;
  /// Adds the part of some of its contacts.
  virtual void add_contacts(const Disc& disc, std::span<const DiscContact> contacts,
                            std::span<double> quantity) const;

  /// Whether all columns are the mean sums over V (fields/volume_sum.h).
  virtual bool is_volume_sum() const { return false; }
  /// To columns (volumes x columns().size()) from numbers: the mean sums (volumes x sums()), then the columns
  /// of each source. nan where a value is undefined.
  virtual void solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const = 0;
  /// What the reader of the columns must know and only the numbers tell; empty: nothing.
  virtual std::string note(const ConstRowsRef& numbers) const;
};

inline void Field::add_disc(const Disc& /*disc*/, std::span<double> /*quantity*/) const {}
inline void Field::add_contacts(const Disc& /*disc*/, std::span<const DiscContact> /*contacts*/,
                                std::span<double> /*quantity*/) const {}
inline std::string Field::note(const ConstRowsRef& /*numbers*/) const {
  return {};
}

/// `count` numbers of one volume, from the `first` one on.
inline std::span<const double> numbers_of(const ConstRowsRef& numbers, Eigen::Index volume,
                                          Eigen::Index first, std::size_t count) {
  return {numbers.data() + volume * numbers.outerStride() + first, count};
}

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
