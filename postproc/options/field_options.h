// SPDX-License-Identifier: GPL-2.0-or-later
// The options that say which fields a verb averages.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "fields/field_registry.h"
#include "io/tables/csv_writer.h"
#include "options/volume_options.h"

namespace mikromakro {

struct FieldChoice {
  std::vector<std::string> names;
  FieldOptions numbers;
  double stiffness_of_run = 0;  ///< k_n as the files have it, for where no option gives it
};

/// k_n of the option, else of the run (N/m); 0: not known.
double stiffness_of(const FieldChoice& choice);

void add_field_options(CLI::App& app, FieldChoice& choice);

/// Throws on unknown names, and on fields that need an option that is not given.
FieldList fields_of(const FieldChoice& choice, const VolumeOptions& volumes);

/// Lines above a table: the names that were given, and the numbers.
void describe_fields(const FieldChoice& choice, Preamble& lines);
void describe_numbers(const FieldChoice& choice, Preamble& lines);

}  // namespace mikromakro
