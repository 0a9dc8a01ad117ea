// SPDX-License-Identifier: GPL-2.0-or-later
// All fields by name.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fields/field.h"
#include "fields/given_quantity.h"

namespace mikromakro {

/// Constants that some fields need in addition to the dumps; 0 if not given.
struct FieldOptions {
  double normal_stiffness = 0;         ///< k_n, N/m
  double friction_coefficient = 0;     ///< mu
  int histogram_bins = 0;              ///< number of bins of the contact angles
  bool rings = true;                   ///< whether the volumes are a sequence of whole rings
  std::vector<GivenField> given = {};  ///< the caller's own fields, behind all others; Disc::given in order
};

/// A field, and whether its columns are output or only serve as input of other fields.
struct ListedField {
  std::unique_ptr<const Field> field;
  bool shown = true;
};
using FieldList = std::vector<ListedField>;

/// Names in the order of the output columns; the default fields, averaged when no names are given, come
/// first.
const std::vector<std::string_view>& field_names();
std::vector<std::string_view> default_field_names();
/// The default fields that can be computed with these options.
std::vector<std::string> default_field_names(const FieldOptions& options);
/// The fields that need no contacts.
std::vector<std::string_view> field_names_without_contacts();

/// The named fields, among them those of `options.given`, in output order, together with the sources they
/// need; an empty list gives the default fields, "all" every field that the options allow. Throws on an
/// unknown name and on a field that requires an option that is not given.
FieldList make_fields(const std::vector<std::string>& names, const FieldOptions& options = {});

}  // namespace mikromakro
