// Input files from names and patterns.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mikromakro {

/// Expands patterns (`*`, `?`, `[...]`); a name without them stands for itself. Throws when a pattern matches
/// no file, or one that is no regular file (a pipe, a folder).
std::vector<std::string> expand_files(const std::vector<std::string>& patterns);

/// Sum of the sizes in bytes; files that cannot be asked count as 0.
std::int64_t total_size(const std::vector<std::string>& files);

}  // namespace mikromakro
