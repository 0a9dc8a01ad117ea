// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/files/file_kind.h"

#include <fmt/format.h>

#include <cstring>
#include <filesystem>

#include "model/error.h"

namespace mikromakro {
namespace {

using namespace std::string_view_literals;

struct Kind {
  std::string_view begin;
  std::string_view name;
  std::string_view way_out;
};

constexpr std::string_view decompress = "plain text, gzip or zstd (decompress it, or recompress it)";
constexpr std::string_view dump = "a text dump as `dump custom` and `dump local` write it";

// Signatures from the format specifications.
constexpr Kind kinds[] = {
    {"\xfd"
     "7zXZ\0"sv,
     "xz", decompress},
    {"BZh"sv, "bzip2", decompress},
    {"\x04\x22\x4d\x18"sv, "lz4", decompress},
    {"\x02\x21\x4c\x18"sv, "lz4", decompress},
    {"\x5d\0\0"sv, "lzma", decompress},
    {"\x1f\x9d"sv, "compress (.Z)", decompress},
    {"PK\x03\x04"sv, "zip", decompress},
    {"7z\xbc\xaf\x27\x1c"sv, "7z", decompress},
    {"\x89HDF\r\n\x1a\n"sv, "HDF5",
     "text (HDF5 snapshots of mikromakro are inputs of average, audit, draw without --particles; a table is "
     "read as .csv)"},
    {"CDF\x01"sv, "NetCDF", dump},
    {"CDF\x02"sv, "NetCDF", dump},
    {"CDF\x05"sv, "NetCDF", dump},
    {"\0\0\x07\xcb"sv, "xtc", dump},
    {"\x54\0\0\0CORD"sv, "dcd", dump},
    {"# vtk DataFile"sv, "VTK", dump},
    {"<?xml"sv, "XML", dump},
    {"<VTKFile"sv, "VTK", dump},
    {"---\n"sv, "yaml", dump},
    {"---\r\n"sv, "yaml", dump},
    {"Number of particles ="sv, "cfg", dump},
    {"\xff\xfe"sv, "UTF-16", "text of one byte per character (UTF-8)"},
    {"\xfe\xff"sv, "UTF-16", "text of one byte per character (UTF-8)"},
};

// Binary dumps of LAMMPS: minus the length of the signature, as 8 bytes, then the signature; before 2020, the
// step and the number of atoms, which contain zero bytes where text has none.
bool is_binary_dump(std::string_view bytes) {
  constexpr std::size_t mark = 8;
  return bytes.size() > mark &&
         (bytes.substr(mark).starts_with("DUMP") ||
          (bytes.find('\0') < mark && bytes.substr(mark / 2, mark / 2) == "\0\0\0\0"sv));
}

[[noreturn]] void refuse(const std::string& file, std::string_view name, std::string_view way_out) {
  throw bad_input({file}, "this kind of file is not supported", way_out, fmt::format("a file of {}", name));
}

}  // namespace

Packing packing_of(std::string_view bytes) {
  if (bytes.starts_with("\x1f\x8b"sv)) return Packing::gzip;
  if (bytes.starts_with("\x28\xb5\x2f\xfd"sv)) return Packing::zstd;
  // Skippable frames, with which pzstd begins: 0x184D2A50 to 0x184D2A5F.
  const bool skippable =
      bytes.size() >= 4 && (bytes[0] & '\xf0') == '\x50' && bytes.substr(1, 3) == "\x2a\x4d\x18"sv;
  return skippable ? Packing::zstd : Packing::none;
}

void check_kind(std::string_view first_bytes, const std::string& file) {
  for (const Kind& kind : kinds)
    if (first_bytes.starts_with(kind.begin)) refuse(file, kind.name, kind.way_out);
  if (is_binary_dump(first_bytes)) refuse(file, "binary numbers", dump);
}

void check_regular(const std::string& file) {
  std::error_code code;
  const auto status = std::filesystem::status(file, code);
  using Type = std::filesystem::file_type;
  if (status.type() == Type::regular) return;
  if (!std::filesystem::status_known(status) || status.type() == Type::not_found)
    throw bad_input({file}, "cannot open the file", "a readable file",
                    status.type() == Type::not_found ? "No such file or directory" : code.message());
  throw bad_input({file}, "not a regular file", "a file that can be opened more than once",
                  status.type() == Type::fifo        ? "a pipe"
                  : status.type() == Type::directory ? "a folder"
                                                     : "a device or socket");
}

}  // namespace mikromakro
