// SPDX-License-Identifier: GPL-2.0-or-later
// Options that select the fields to average.
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
  double stiffness_of_run = 0;  ///< k_n from the files, used if no option gives it
};

/// k_n from the option, else from the run (N/m); 0 if not known.
double stiffness_of(const FieldChoice& choice);

void add_field_options(CLI::App& app, FieldChoice& choice);

/// Throws on unknown names, and on fields that require an option that is not given.
FieldList fields_of(const FieldChoice& choice, const VolumeOptions& volumes);

/// Header lines of a table: the field names given, and the constants.
void describe_fields(const FieldChoice& choice, Preamble& lines);
void describe_numbers(const FieldChoice& choice, Preamble& lines);

}  // namespace mikromakro
