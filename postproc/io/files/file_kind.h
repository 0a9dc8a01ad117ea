// SPDX-License-Identifier: GPL-2.0-or-later
// Identifies files by their first bytes.
#pragma once

#include <string>
#include <string_view>

namespace mikromakro {

/// Compression of a text file.
enum class Packing { none, gzip, zstd };
Packing packing_of(std::string_view first_bytes);

/// Throws, naming the kind and a remedy, if the first bytes are those of a file that is known but not
/// readable as text: other compressions, binary dumps, files of other programs.
void check_kind(std::string_view first_bytes, const std::string& file);

/// Throws if the file does not exist or is not a regular file: a pipe, a directory, a device.
void check_regular(const std::string& file);

}  // namespace mikromakro
