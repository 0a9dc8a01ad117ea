// SPDX-License-Identifier: GPL-2.0-or-later
// What a file is, by its first bytes.
#pragma once

#include <string>
#include <string_view>

namespace mikromakro {

/// How text is compressed.
enum class Packing { none, gzip, zstd };
Packing packing_of(std::string_view first_bytes);

/// Throws, naming the kind and the way out, where the first bytes are those of a file that we know and do not
/// read as text: other compressions, binary dumps, files of other programs.
void check_kind(std::string_view first_bytes, const std::string& file);

/// Throws where there is no file, or no regular one: a pipe, a folder, a device.
void check_regular(const std::string& file);

}  // namespace mikromakro
