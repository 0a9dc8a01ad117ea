// SPDX-License-Identifier: GPL-2.0-or-later
// The verbs of the program: each adds its options to the command line and registers the action to run if it
// is chosen.
#pragma once

#include <CLI/CLI.hpp>

namespace mikromakro {

void add_average_command(CLI::App& program);
void add_compare_command(CLI::App& program);
void add_info_command(CLI::App& program);
void add_convert_command(CLI::App& program);
void add_draw_command(CLI::App& program);
void add_fit_command(CLI::App& program);
void add_audit_command(CLI::App& program);
void add_report_command(CLI::App& program);
void add_timestep_command(CLI::App& program);

}  // namespace mikromakro
