// SPDX-License-Identifier: GPL-2.0-or-later
// Input files from names and patterns.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mikromakro {

/// Expands patterns (`*`, `?`, `[...]`); other names are returned unchanged. Throws if a pattern matches no
/// file, or one that is not regular (a pipe, a directory).
std::vector<std::string> expand_files(const std::vector<std::string>& patterns);

/// Throws if a file belongs to two runs, or is a byte-by-byte copy of a file of another run: duplicated data
/// would count twice and make the errors too small. Two runs of several files each may share one, their
/// initial state. `files[k]` are the files of run k.
void check_runs_differ(const std::vector<std::vector<std::string>>& files);

/// Total size in bytes; files whose size is not available count as 0.
std::int64_t total_size(const std::vector<std::string>& files);

}  // namespace mikromakro
