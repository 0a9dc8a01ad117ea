#include "io/output_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "io/error.h"

namespace mikromakro {

OutputFile::OutputFile(const std::string& file)
    : file_(file), temporary_(fmt::format("{}.part{}", file, getpid())) {
  if (std::filesystem::is_directory(file))
    throw bad_input({file}, "cannot write the output", "a file name", "a folder");
  // Made at once, so that a name that cannot be written is found before a long run and not after it.
  if (!std::ofstream(temporary_))
    throw bad_input({file}, "cannot write the output", "a file that can be written", std::strerror(errno));
}

OutputFile::~OutputFile() {
  std::remove(temporary_.c_str());
}

void OutputFile::commit(std::string_view content) {
  std::ofstream stream(temporary_, std::ios::binary);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream)
    throw run_failed(fmt::format("{}: cannot write the output", file_), "space on the disk",
                     std::strerror(errno));
  publish();
}

void OutputFile::publish() {
  if (std::rename(temporary_.c_str(), file_.c_str()) != 0)
    throw run_failed(fmt::format("{}: cannot write the output", file_), "space on the disk",
                     std::strerror(errno));
}

}  // namespace mikromakro
