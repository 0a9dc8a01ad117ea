// SPDX-License-Identifier: GPL-2.0-or-later
// All fields by their names.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fields/field.h"

namespace mikromakro {

/// Numbers that some fields need beside the dumps; 0 where they are not given.
struct FieldOptions {
  double normal_stiffness = 0;      ///< k_n, N/m
  double friction_coefficient = 0;  ///< mu
  int histogram_bins = 0;           ///< of the contact angles
  bool rings = true;                ///< whether the volumes are a sequence of whole rings
};

/// A field, and whether its columns are wanted or only what other fields make of them.
struct ListedField {
  std::unique_ptr<const Field> field;
  bool shown = true;
};
using FieldList = std::vector<ListedField>;

/// Names in the order of the output's columns: first those that are averaged when no names are given.
const std::vector<std::string_view>& field_names();
std::vector<std::string_view> default_field_names();
/// Those of them that have a value with these options.
std::vector<std::string> default_field_names(const FieldOptions& options);
/// Those for which discs are enough.
std::vector<std::string_view> field_names_without_contacts();

/// The named fields, in the order of the output, with the sources that they need; the default ones for an
/// empty list, each that the options allow for "all". Throws on an unknown name, and on a field that needs an
/// option that is not given.
FieldList make_fields(const std::vector<std::string>& names, const FieldOptions& options = {});

}  // namespace mikromakro
