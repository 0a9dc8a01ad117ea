// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/files/output_file.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "model/error.h"

namespace mikromakro {
namespace {

namespace fs = std::filesystem;

// The temporary names currently in use. Outputs beyond this capacity are still written, but left behind by a
// signal.
std::array<std::atomic<const char*>, 256> unfinished = {};

void remember(const char* name) {
  for (auto& place : unfinished) {
    const char* none = nullptr;
    if (place.compare_exchange_strong(none, name)) return;
  }
}

void forget(const char* name) {
  for (auto& place : unfinished) {
    const char* same = name;
    if (place.compare_exchange_strong(same, nullptr)) return;
  }
}

// Follows a symbolic link even if its target does not exist yet.
std::string target_of(const std::string& file) {
  constexpr int most_links = 40;
  fs::path path = file;
  std::error_code code;
  for (int i = 0; i < most_links && fs::is_symlink(fs::symlink_status(path, code)); ++i)
    path = path.parent_path() / fs::read_symlink(path, code);
  return path.string();
}

using Identity = std::pair<dev_t, ino_t>;

std::optional<Identity> identity_of(const std::string& file) {
  struct stat status = {};
  const bool is_output = file == "-";
  if ((is_output ? fstat(STDOUT_FILENO, &status) : stat(file.c_str(), &status)) != 0) return std::nullopt;
  if (is_output && !S_ISREG(status.st_mode)) return std::nullopt;  // a terminal may be input and output
  return Identity{status.st_dev, status.st_ino};
}

// A unique name for a file that need not exist, however it is spelled.
std::string full_name(const std::string& file) {
  const fs::path path = target_of(file);
  std::error_code code;
  const fs::path folder = fs::weakly_canonical(path.has_parent_path() ? path.parent_path() : ".", code);
  return (folder / path.filename()).string();
}

}  // namespace

OutputFile::OutputFile(const std::string& file) : file_(file), target_(target_of(file)), temporary_(target_) {
  std::error_code code;
  const fs::file_status status = fs::status(target_, code);
  if (fs::is_directory(status)) throw bad_input({file}, "cannot write the output", "a file name", "a folder");
  if (fs::exists(status) && access(target_.c_str(), W_OK) != 0)
    throw bad_input({file}, "cannot write the output", "a file that can be written", std::strerror(errno));
  if (fs::exists(status) && !fs::is_regular_file(status)) return;
  temporary_ = fmt::format("{}.part{}", target_, getpid());
  // Create the file at once, so that an unwritable name is found before a long run rather than after it.
  if (!std::ofstream(temporary_))
    throw bad_input({file}, "cannot write the output", "a file that can be written", std::strerror(errno));
  if (fs::exists(status)) fs::permissions(temporary_, status.permissions(), code);
  remember(temporary_.c_str());
}

OutputFile::~OutputFile() {
  if (!is_replaced()) return;
  std::remove(temporary_.c_str());
  forget(temporary_.c_str());
}

void OutputFile::fail() const {
  throw run_failed(fmt::format("{}: cannot write the output", file_), "space on the disk",
                   std::strerror(errno));
}

void OutputFile::commit(std::string_view content) {
  commit([&](std::ostream& stream) {
    stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  });
}

void OutputFile::commit(const std::function<void(std::ostream&)>& write) {
  std::ofstream stream(temporary_, std::ios::binary);
  write(stream);
  stream.close();
  if (!stream) fail();
  publish();
}

void OutputFile::publish() {
  if (is_replaced() && std::rename(temporary_.c_str(), target_.c_str()) != 0) fail();
}

void OutputFile::require_regular() const {
  if (!is_replaced())
    throw bad_input({file_}, "this kind of output cannot be written as a stream", "a regular file",
                    "a pipe or a device");
}

void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
  std::map<Identity, std::string> read;
  for (const std::string& input : inputs)
    if (const auto identity = identity_of(input)) read.emplace(*identity, input);
  std::set<std::string> names;
  std::set<Identity> written;
  for (const std::string& output : outputs) {
    const auto identity = identity_of(output);
    const std::string shown = output == "-" ? "standard output" : output;
    if (identity && read.count(*identity) != 0)
      throw bad_input({shown}, "the output is an input", "another file", in_quotes(read.at(*identity)));
    const bool again = !names.insert(output == "-" ? output : full_name(output)).second;
    if (again || (identity && !written.insert(*identity).second))
      throw bad_input({shown}, "two outputs are one file", "each file once", "it again");
  }
}

void remove_unfinished_outputs() noexcept {
  for (const auto& place : unfinished)
    if (const char* name = place.load()) unlink(name);
}

}  // namespace mikromakro
