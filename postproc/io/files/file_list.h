// SPDX-License-Identifier: GPL-2.0-or-later
// Input files from names and patterns.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mikromakro {

/// Expands patterns (`*`, `?`, `[...]`); a name without them stands for itself. Throws when a pattern matches
/// no file, or one that is no regular file (a pipe, a folder).
std::vector<std::string> expand_files(const std::vector<std::string>& patterns);

/// Throws where a file of one run is one of another, or a copy of it byte by byte: what is there twice would
/// count twice, and make errors too small. `files[k]` are those of run k.
void check_runs_differ(const std::vector<std::vector<std::string>>& files);

/// Sum of the sizes in bytes; files that cannot be asked count as 0.
std::int64_t total_size(const std::vector<std::string>& files);

}  // namespace mikromakro
