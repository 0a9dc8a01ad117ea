// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/numbered_name.h"

#include <fmt/format.h>

#include <filesystem>

namespace mikromakro {

std::string numbered_name(const std::string& name, std::int64_t index, std::int64_t count) {
  const std::size_t percent = name.find('%');
  std::size_t end = percent;
  if (percent != std::string::npos) end = name.find_first_not_of("0123456789", percent + 1);
  if (end != std::string::npos && name[end] == 'd' && end - percent <= 3) {
    const int width = end == percent + 1 ? 0 : std::stoi(name.substr(percent + 1, end - percent - 1));
    return fmt::format("{}{:0{}}{}", name.substr(0, percent), index, width, name.substr(end + 1));
  }
  if (count == 1) return name;
  std::filesystem::path path(name);
  path.replace_filename(fmt::format("{}_{:04}{}", path.stem().string(), index, path.extension().string()));
  return path.string();
}

}  // namespace mikromakro
