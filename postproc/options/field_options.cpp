// SPDX-License-Identifier: GPL-2.0-or-later
#include "options/field_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "model/error.h"
#include "options/value_checks.h"

namespace mikromakro {

void add_field_options(CLI::App& app, FieldChoice& choice) {
  app.option_defaults()->group("Fields");
  app.add_option("--kn", choice.numbers.normal_stiffness,
                 "normal stiffness k_n (N/m): E and G in units of k_n/h, curvature without springs")
      ->check(positive());
  app.add_option("--mu", choice.numbers.friction_coefficient, "coefficient of friction, for sliding_fraction")
      ->check(positive());
  app.add_option("--histogram", choice.numbers.histogram_bins,
                 "BINS: adds contact_angle_histogram with this many bins")
      ->transform(whole_number(1, 3600));
  app.add_option("--fields", choice.names,
                 fmt::format("all, or names of {}; default {}", fmt::join(field_names(), ","),
                             fmt::join(default_field_names(), ",")))
      ->delimiter(',');
  app.option_defaults()->group("Options");
}

namespace {

// Rejects constants that none of the fields uses.
void check_use(const FieldChoice& choice) {
  const std::vector<std::string>& names = choice.names;
  const auto averaged = [&](std::string_view name) {
    const auto& defaults = default_field_names();
    return names.empty() ? std::find(defaults.begin(), defaults.end(), name) != defaults.end()
                         : std::find(names.begin(), names.end(), name) != names.end() ||
                               std::find(names.begin(), names.end(), "all") != names.end();
  };
  if (choice.numbers.normal_stiffness > 0 && !averaged("stiffness") && !averaged("curvature") &&
      !averaged("rotational_stiffness"))
    throw bad_input({"--kn"}, "none of the fields uses it", "stiffness, curvature or rotational_stiffness",
                    fmt::format("{}", fmt::join(names, ",")));
  if (choice.numbers.friction_coefficient > 0 && !averaged("sliding_fraction"))
    throw bad_input({"--mu"}, "none of the fields uses it", "sliding_fraction in --fields",
                    names.empty() ? "the default fields" : fmt::format("{}", fmt::join(names, ",")));
}

}  // namespace

double stiffness_of(const FieldChoice& choice) {
  return choice.numbers.normal_stiffness > 0 ? choice.numbers.normal_stiffness : choice.stiffness_of_run;
}

FieldList fields_of(const FieldChoice& choice, const VolumeOptions& volumes) {
  check_use(choice);
  FieldOptions numbers = choice.numbers;
  numbers.rings = are_rings(volumes);
  numbers.normal_stiffness = stiffness_of(choice);
  std::vector<std::string> names = choice.names;
  if (numbers.histogram_bins > 0) {
    if (names.empty()) names = default_field_names(numbers);
    names.emplace_back("contact_angle_histogram");
  }
  return make_fields(names, numbers);
}

void describe_fields(const FieldChoice& choice, Preamble& lines) {
  if (!choice.names.empty()) lines.emplace_back("fields", fmt::format("{}", fmt::join(choice.names, ",")));
}

void describe_numbers(const FieldChoice& choice, Preamble& lines) {
  if (stiffness_of(choice) > 0) lines.emplace_back("kn", fmt::format("{} N/m", stiffness_of(choice)));
  if (choice.numbers.friction_coefficient > 0)
    lines.emplace_back("mu", fmt::format("{}", choice.numbers.friction_coefficient));
}

}  // namespace mikromakro
