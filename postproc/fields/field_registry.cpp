#include "fields/field_registry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fields/coordination.h"
#include "fields/fabric.h"
#include "fields/kinetic_stress.h"
#include "fields/solid_fraction.h"
#include "fields/spin.h"
#include "fields/stress.h"
#include "fields/velocity.h"
#include "io/error.h"

namespace mikromakro {
namespace {

template <typename... Fields>
FieldList make_all() {
  FieldList fields;
  (fields.push_back(std::make_unique<const Fields>()), ...);
  return fields;
}

// A new field is added here, and nowhere else.
FieldList all_fields() {
  return make_all<SolidFraction, Coordination, Velocity, Spin, Fabric, Stress, KineticStress>();
}

}  // namespace

std::vector<Column> tensor_columns(std::string_view name, const Axes& axes, const Column& like) {
  std::vector<Column> columns;
  for (const std::string& first : axes) {
    for (const std::string& second : axes)
      columns.push_back({fmt::format("{}_{}{}", name, first, second), like.unit, like.equation, like.text});
  }
  return columns;
}

const std::vector<std::string_view>& field_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    for (const auto& field : all_fields()) all.push_back(field->name());
    return all;
  }();
  return names;
}

FieldList make_fields(const std::vector<std::string>& names) {
  const auto& known = field_names();
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw bad_input({"--fields"}, "unknown field", fmt::format("one of {}", fmt::join(known, " ")),
                      in_quotes(name));
  }
  FieldList fields = all_fields();
  const auto not_asked = [&](const std::unique_ptr<const Field>& field) {
    return !names.empty() && std::find(names.begin(), names.end(), field->name()) == names.end();
  };
  fields.erase(std::remove_if(fields.begin(), fields.end(), not_asked), fields.end());
  return fields;
}

}  // namespace mikromakro
