// SPDX-License-Identifier: GPL-2.0-or-later
// An averaged quantity: sums over discs and their contacts, and the columns solved from the sums.
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

/// A disc as seen by the fields: vectors in the basis of the averaging volumes at the centre of the disc, SI
/// units.
struct Disc {
  double volume = 0;  ///< V^p = pi a^2 h, m^3
  double radius = 0;
  double mass = 0;
  Eigen::Vector2d velocity;
  double spin = 0;  ///< omega_z, rad/s
  /// Number of contacts, including those with walls and wall discs; `unknown` if there is no contact file.
  int contacts = 0;
  static constexpr int unknown = -1;
  double mean_radius = 0;              ///< number average over all averaged discs of the frame
  std::span<const double> given = {};  ///< values of the caller's own fields
};

/// A contact seen from that disc, in the same basis.
struct DiscContact {
  Eigen::Vector2d normal;  ///< n, from the disc outward
  Eigen::Vector2d force;   ///< f^c on the disc, N
  Eigen::Vector2d branch;  ///< l^pc, m
  double overlap = 0;      ///< m, > 0
  double spring = 0;       ///< slip xi along t = (-n_y, n_x), same for both discs; nan: not in dump
  bool with_wall = false;  ///< the partner is a wall or a disc that is not averaged

  Eigen::Vector2d tangent() const { return {-normal[1], normal[0]}; }
};

/// Number of consecutive columns that belong to one field.
struct ColumnsOfField {
  std::string name;
  Eigen::Index count = 0;
  std::vector<Column> columns = {};  ///< empty if nothing is known about them
};

/// Names of the two directions: {"r", "phi"} or {"x", "y"}.
using Axes = std::array<std::string, 2>;

/// Blocks of such tables; one row per volume.
using ConstRowsRef = Eigen::Ref<const Rows, 0, Eigen::OuterStride<>>;
using RowsRef = Eigen::Ref<Rows, 0, Eigen::OuterStride<>>;

/// What solve() needs to know about the averaging volumes.
struct VolumeData {
  Eigen::ArrayXd measure;  ///< V = area * h of each volume, m^3
  double height = 0;       ///< h, m
  Eigen::ArrayXd radius;   ///< r of each ring, ascending, m; empty if the volumes are not rings
};

/// Where a contact counts if the weight is a kernel (docs/conventions.md, Kernels). With other weights, a
/// contact counts where its disc does.
enum class ContactPlace {
  disc,        ///< at the disc's centre, like the quantities of the disc itself
  branch,      ///< along the branch, which carries the force
  wall_point,  ///< at the end of the branch, on the wall; contacts between averaged discs are left out
};

/// A field defines the quantity V^p Q^p of one disc in Eq. 4, Q = 1/V sum_p w^p V^p Q^p, as a list of
/// numbers, split into the contribution of the disc and those of its contacts. The averager applies the
/// weights, sums over the discs and averages over the frames; the field then solves its columns from the
/// summed numbers. Instead of sums, or in addition to them, a field may use the columns of other fields.
/// Fields are stateless apart from their construction options.
class Field {
 public:
  Field() = default;
  Field(const Field&) = delete;
  Field& operator=(const Field&) = delete;
  virtual ~Field() = default;

  /// Name for --fields.
  virtual std::string_view name() const = 0;
  virtual std::vector<Column> columns(const Axes& axes) const = 0;
  /// Names of the fields whose columns solve() uses. They must precede this field in the registry.
  virtual std::vector<std::string_view> sources() const { return {}; }

  /// The option that the field requires and that was not given; empty if nothing is missing.
  virtual std::string_view missing_option() const { return {}; }

  /// Dump columns that the field requires.
  virtual ColumnSet particles_needed() const { return 0; }
  virtual ColumnSet contacts_needed() const { return 0; }
  /// Whether the field requires contacts at all.
  virtual bool needs_contacts() const { return false; }

  /// Where the contacts count. Fields with a place other than the disc get their contacts one at a time.
  virtual ContactPlace contact_place() const { return ContactPlace::disc; }

  /// Number of sums; the length of the spans below.
  virtual int sums() const { return 0; }
  /// Adds the contribution of the disc itself to `quantity`.
  virtual void add_disc(const Disc& disc, std::span<double> quantity) const;
  /// Adds the contributions of some of its contacts.
  virtual void add_contacts(const Disc& disc, std::span<const DiscContact> contacts,
                            std::span<double> quantity) const;

  /// Whether every column is a mean sum over V (fields/volume_sum.h).
  virtual bool is_volume_sum() const { return false; }
  /// Computes `columns` (volumes x columns().size()) from `numbers`: the mean sums (volumes x sums()), then
  /// the columns of each source. nan where a value is undefined.
  virtual void solve(const VolumeData& volumes, const ConstRowsRef& numbers, RowsRef columns) const = 0;
  /// A remark for users of the columns that depends on the numbers; empty if none.
  virtual std::string note(const ConstRowsRef& numbers) const;
};

inline void Field::add_disc(const Disc& /*disc*/, std::span<double> /*quantity*/) const {}
inline void Field::add_contacts(const Disc& /*disc*/, std::span<const DiscContact> /*contacts*/,
                                std::span<double> /*quantity*/) const {}
inline std::string Field::note(const ConstRowsRef& /*numbers*/) const {
  return {};
}

/// `count` numbers of one volume, starting at `first`.
inline std::span<const double> numbers_of(const ConstRowsRef& numbers, Eigen::Index volume,
                                          Eigen::Index first, std::size_t count) {
  return {numbers.data() + volume * numbers.outerStride() + first, count};
}

/// The four columns of a tensor in row order: `name`_rr, `name`_rphi, `name`_phir, `name`_phiphi.
std::vector<Column> tensor_columns(std::string_view name, const Axes& axes, const Column& like);

/// Adds a (x) b to four sums in that order.
inline void add_dyad(const Eigen::Vector2d& a, const Eigen::Vector2d& b, std::span<double> sums) {
  sums[0] += a[0] * b[0];
  sums[1] += a[0] * b[1];
  sums[2] += a[1] * b[0];
  sums[3] += a[1] * b[1];
}

}  // namespace mikromakro
