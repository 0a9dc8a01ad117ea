#include "io/file_list.h"

#include <glob.h>

#include <filesystem>

#include "io/error.h"
#include "io/file_kind.h"

namespace mikromakro {

std::vector<std::string> expand_files(const std::vector<std::string>& patterns) {
  std::vector<std::string> files;
  for (const std::string& pattern : patterns) {
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
