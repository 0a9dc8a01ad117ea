// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/files/file_list.h"

#include <fmt/format.h>
#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <utility>

#include "io/files/file_kind.h"
#include "model/error.h"

namespace mikromakro {

std::vector<std::string> expand_files(const std::vector<std::string>& patterns) {
  std::vector<std::string> files;
  for (const std::string& pattern : patterns) {
    // An existing file name may contain brackets.
    if (std::error_code code; std::filesystem::exists(pattern, code)) {
      check_regular(pattern);
      files.push_back(pattern);
      continue;
    }
    glob_t found{};
    const int code = glob(pattern.c_str(), 0, nullptr, &found);
    const std::size_t before = files.size();
    for (std::size_t i = 0; code == 0 && i < found.gl_pathc; ++i) files.emplace_back(found.gl_pathv[i]);
    globfree(&found);
    for (std::size_t i = before; i < files.size(); ++i) check_regular(files[i]);
    if (code != 0)
      throw bad_input({pattern}, "cannot find the file", "a file or a pattern that matches one", "none");
  }
  return files;
}

namespace {

bool same_bytes(const std::string& one, const std::string& other) {
  std::error_code code;
  if (std::filesystem::equivalent(one, other, code)) return true;
  std::ifstream first(one, std::ios::binary), second(other, std::ios::binary);
  std::vector<char> bytes(1U << 16U), others(bytes.size());
  while (first && second) {
    first.read(bytes.data(), std::ssize(bytes));
    second.read(others.data(), std::ssize(others));
    if (first.gcount() != second.gcount() ||
        !std::equal(bytes.begin(), bytes.begin() + first.gcount(), others.begin()))
      return false;
  }
  return first.eof() && second.eof();
}

}  // namespace

void check_runs_differ(const std::vector<std::vector<std::string>>& files) {
  struct Known {
    std::size_t run;
    const std::string* name;
  };
  std::multimap<std::uintmax_t, Known> by_size;
  std::set<std::pair<std::size_t, std::size_t>> share_one;  // runs with a common initial state
  for (std::size_t run = 0; run < files.size(); ++run)
    for (const std::string& file : files[run]) {
      std::error_code code;
      const std::uintmax_t size = std::filesystem::file_size(file, code);
      if (code) continue;
      const auto [begin, end] = by_size.equal_range(size);
      for (auto known = begin; known != end; ++known) {
        const auto& [other, name] = known->second;
        if (other == run || !same_bytes(file, *name)) continue;
        const bool several = files[run].size() > 1 && files[other].size() > 1 && file != *name;
        if (several && share_one.emplace(other, run).second) continue;
        throw bad_input({file}, "the same frames are in two runs", "files of different runs",
                        fmt::format("the content of {} again", *name));
      }
      by_size.emplace(size, Known{run, &file});
    }
}

std::int64_t total_size(const std::vector<std::string>& files) {
  std::int64_t sum = 0;
  for (const std::string& file : files) {
    std::error_code code;
    const auto size = std::filesystem::file_size(file, code);
    if (!code) sum += static_cast<std::int64_t>(size);
  }
  return sum;
}

}  // namespace mikromakro
