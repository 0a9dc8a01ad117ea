// SPDX-License-Identifier: GPL-2.0-or-later
// Output of `info` for MercuryDPM files.
#pragma once

#include <string>

#include "io/tables/json.h"
#include "model/notes.h"

namespace mikromakro {

bool is_mercury_file(const std::string& file);
void print_mercury(const std::string& file, Notes& notes);
Json mercury_json(const std::string& file, Notes& notes);

}  // namespace mikromakro
