// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/field_registry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fields/contact_angles.h"
#include "fields/coordination.h"
#include "fields/couple_stress.h"
#include "fields/curvature.h"
#include "fields/elastic_strain.h"
#include "fields/fabric.h"
#include "fields/kinetic_stress.h"
#include "fields/number_coordination.h"
#include "fields/principal_axes.h"
#include "fields/rattlers.h"
#include "fields/rotational_stiffness.h"
#include "fields/size_correction.h"
#include "fields/sliding_contacts.h"
#include "fields/solid_fraction.h"
#include "fields/spin.h"
#include "fields/stiffness.h"
#include "fields/stress.h"
#include "fields/velocity.h"
#include "fields/velocity_gradient.h"
#include "fields/velocity_gradient_fit.h"
#include "fields/wall_force_density.h"
#include "model/error.h"
#include "model/nearest_name.h"

namespace mikromakro {
namespace {

using FieldPointer = std::unique_ptr<const Field>;

template <typename Made>
FieldPointer plain(const FieldOptions& /*options*/) {
  return std::make_unique<const Made>();
}

template <typename Made>
FieldPointer with_stiffness(const FieldOptions& options) {
  return std::make_unique<const Made>(options.normal_stiffness);
}
template <typename Made>
FieldPointer over_rings(const FieldOptions& options) {
  return std::make_unique<const Made>(options.rings);
}
FieldPointer sliding(const FieldOptions& options) {
  return std::make_unique<const SlidingContacts>(options.friction_coefficient);
}
FieldPointer histogram(const FieldOptions& options) {
  return std::make_unique<const ContactAngleHistogram>(options.histogram_bins);
}

constexpr PrincipalAxes::Tensor stress_axes{"stress_axes", "stress", "sigma", "Pa", true};
constexpr PrincipalAxes::Tensor strain_axes{"strain_axes", "elastic_strain", "eps", "1", true};
constexpr PrincipalAxes::Tensor fabric_axes{"fabric_axes", "fabric", "F", "1", false};
template <const PrincipalAxes::Tensor& tensor>
FieldPointer axes_of(const FieldOptions& /*options*/) {
  return std::make_unique<const PrincipalAxes>(tensor);
}

struct Entry {
  FieldPointer (*make)(const FieldOptions&);
  bool by_default = true;
};

// The only place to add a new field; sources precede the fields that use them.
constexpr Entry entries[] = {
    {plain<SolidFraction>},
    {plain<Coordination>},
    {plain<Velocity>},
    {plain<Spin>},
    {plain<Fabric>},
    {plain<Stress>},
    {plain<KineticStress>},
    {plain<ElasticStrain>},
    {plain<CoupleStress>},
    {with_stiffness<Curvature>},
    {over_rings<VelocityGradient>},
    {with_stiffness<Stiffness>},
    {plain<RotationalStiffness>},
    {over_rings<VelocityGradientFit>, false},
    {axes_of<stress_axes>, false},
    {axes_of<strain_axes>, false},
    {axes_of<fabric_axes>, false},
    {plain<NumberCoordination>, false},
    {plain<SizeCorrection>, false},
    {plain<ContactAngles>, false},
    {histogram, false},
    {sliding, false},
    {plain<Rattlers>, false},
    {plain<WallForceDensity>, false},
};

std::vector<std::string_view> names_of(bool defaults_only) {
  std::vector<std::string_view> names;
  for (const Entry& entry : entries)
    if (entry.by_default || !defaults_only) names.push_back(entry.make({})->name());
  return names;
}

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void check_names(const std::vector<std::string>& names, const std::vector<GivenField>& given) {
  std::vector<std::string_view> known = field_names();
  for (const GivenField& field : given) {
    if (field.name == "all" || std::find(known.begin(), known.end(), field.name) != known.end())
      throw bad_input({"--fields"}, "two fields of one name", "another name for your own",
                      in_quotes(field.name));
    known.emplace_back(field.name);
  }
  for (const std::string& name : names) {
    if (name != "all" && std::find(known.begin(), known.end(), name) == known.end())
      throw bad_input({"--fields"}, "unknown field",
                      fmt::format("all, or some of {}", fmt::join(known, ", ")),
                      in_quotes_with_guess(name, known));
  }
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
  static const std::vector<std::string_view> names = names_of(false);
  return names;
}

std::vector<std::string_view> default_field_names() {
  return names_of(true);
}

std::vector<std::string_view> field_names_without_contacts() {
  std::vector<std::string_view> names;
  for (const Entry& entry : entries) {
    const FieldPointer field = entry.make({});
    const auto sources = field->sources();
    const bool without = std::all_of(sources.begin(), sources.end(), [&](std::string_view source) {
      return std::find(names.begin(), names.end(), source) != names.end();
    });
    if (without && !field->needs_contacts()) names.push_back(field->name());
  }
  return names;
}

std::vector<std::string> default_field_names(const FieldOptions& options) {
  std::vector<std::string> names;
  for (const Entry& entry : entries) {
    const FieldPointer field = entry.make(options);
    if (entry.by_default && field->missing_option().empty()) names.emplace_back(field->name());
  }
  return names;
}

FieldList make_fields(const std::vector<std::string>& names, const FieldOptions& options) {
  check_names(names, options.given);
  const bool all = contains(names, "all");
  FieldList fields;
  for (const Entry& entry : entries) {
    ListedField listed{entry.make(options)};
    listed.shown = all || (names.empty() ? entry.by_default : contains(names, listed.field->name()));
    const std::string_view missing = listed.field->missing_option();
    if (!missing.empty() && contains(names, listed.field->name()))
      throw bad_input({"--fields"}, fmt::format("{} has no value", listed.field->name()),
                      fmt::format("the option {}", missing), "none");
    if (!missing.empty()) listed.shown = false;
    fields.push_back(std::move(listed));
  }
  std::size_t first = 0;
  for (const GivenField& given : options.given) {
    fields.push_back(
        {std::make_unique<const GivenQuantity>(given, first), all || contains(names, given.name)});
    first += given.columns.size();
  }
  // Backwards, so that sources of sources are kept as well.
  std::vector<std::string> needed;
  for (std::size_t i = fields.size(); i-- > 0;) {
    const Field& field = *fields[i].field;
    if (!fields[i].shown && !contains(needed, field.name())) {
      fields.erase(fields.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      for (const std::string_view source : field.sources()) needed.emplace_back(source);
    }
  }
  return fields;
}

}  // namespace mikromakro
