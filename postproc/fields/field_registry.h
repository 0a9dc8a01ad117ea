// All fields by their names.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fields/field.h"

namespace mikromakro {

using FieldList = std::vector<std::unique_ptr<const Field>>;

/// Names in the order of the output's columns.
const std::vector<std::string_view>& field_names();

/// The named fields, in the order of the output; all of them for an empty list. Throws on an unknown name.
FieldList make_fields(const std::vector<std::string>& names);

}  // namespace mikromakro
