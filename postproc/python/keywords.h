// SPDX-License-Identifier: GPL-2.0-or-later
// Keywords of Python as options of the command line, which are their only definition.
#pragma once

#include <pybind11/pybind11.h>

#include <CLI/CLI.hpp>
#include <string>

namespace mikromakro {

/// Sets the options of `app` from keywords: `bulk_types=[1, 2]` is `--bulk-types 1,2`, `per_frame=True` is
/// `--per-frame`, a list of lists gives the option once per list; None is an option not given. Throws
/// TypeError on unknown keywords and on values of another type, Error on values that the program refuses.
/// `verb` is for messages.
void set_options(CLI::App& app, const std::string& verb, const pybind11::dict& keywords);

/// Of each option: keyword, type in Python, description.
pybind11::list describe_options(const CLI::App& app);

}  // namespace mikromakro
