#include "options/field_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace mikromakro {

void add_field_options(CLI::App& app, FieldChoice& choice) {
  app.add_option("--kn", choice.numbers.normal_stiffness,
                 "normal stiffness k_n (N/m): E and G in units of k_n/h, curvature without springs")
      ->check(CLI::PositiveNumber);
  app.add_option("--mu", choice.numbers.friction_coefficient, "coefficient of friction, for sliding_fraction")
      ->check(CLI::PositiveNumber);
  app.add_option("--histogram", choice.numbers.histogram_bins,
                 "BINS: adds contact_angle_histogram with so many bins")
      ->check(CLI::Range(1, 3600));
  app.add_option("--fields", choice.names,
                 fmt::format("all, or names of {}; default {}", fmt::join(field_names(), ","),
                             fmt::join(default_field_names(), ",")))
      ->delimiter(',');
}

FieldList fields_of(const FieldChoice& choice, const VolumeOptions& volumes) {
  std::vector<std::string> names = choice.names;
  if (choice.numbers.histogram_bins > 0) {
    if (names.empty()) {
      for (const std::string_view name : default_field_names()) names.emplace_back(name);
    }
    names.emplace_back("contact_angle_histogram");
  }
  FieldOptions numbers = choice.numbers;
  numbers.rings = are_rings(volumes);
  return make_fields(names, numbers);
}

void describe_fields(const FieldChoice& choice, Preamble& lines) {
  if (!choice.names.empty()) lines.emplace_back("fields", fmt::format("{}", fmt::join(choice.names, ",")));
}

void describe_numbers(const FieldChoice& choice, Preamble& lines) {
  if (choice.numbers.normal_stiffness > 0)
    lines.emplace_back("kn", fmt::format("{} N/m", choice.numbers.normal_stiffness));
  if (choice.numbers.friction_coefficient > 0)
    lines.emplace_back("mu", fmt::format("{}", choice.numbers.friction_coefficient));
}

}  // namespace mikromakro
