// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/files/byte_source.h"

#include <gtest/gtest.h>
#include <zstd.h>

#include <cstdint>

#include "io/files/line_reader.h"
#include "text_file.h"

namespace mikromakro {
namespace {

std::string packed(const std::string& text) {
  std::string out(ZSTD_compressBound(text.size()), '\0');
  out.resize(ZSTD_compress(out.data(), out.size(), text.data(), text.size(), 3));
  return out;
}

// Long enough for several blocks of the reader.
std::string many_lines() {
  std::string text;
  for (std::int64_t i = 0; i < 300000; ++i) text += std::to_string(i * 7919 % 100003) + "\n";
  return text;
}

std::string all_lines(LineReader& lines) {
  std::string text;
  for (std::string_view line; lines.next(line);) text.append(line) += '\n';
  return text;
}

std::string all_lines(const std::string& file) {
  LineReader lines(file);
  return all_lines(lines);
}

TEST(Zstd, GivesTheLinesOfThePlainFileUnderAnyName) {
  const Folder folder;
  const std::string text = many_lines();
  EXPECT_TRUE(all_lines(folder.write("plain_name", packed(text))) == text);
}

TEST(Zstd, SeveralFramesInAFileAreReadOn) {
  const Folder folder;
  EXPECT_EQ(all_lines(folder.write("two.zst", packed("a\n") + packed("b\n"))), "a\nb\n");
}

TEST(Zstd, SkippableFramesAreSkipped) {
  const Folder folder;
  const std::string skippable = std::string("\x50\x2a\x4d\x18\x04\0\0\0", 8) + "skip";
  EXPECT_EQ(all_lines(folder.write("first", skippable + packed("a\n"))), "a\n");
  EXPECT_EQ(all_lines(folder.write("between", packed("a\n") + skippable + packed("b\n"))), "a\nb\n");
}

TEST(Zstd, ACutFileGivesItsWholeLinesAndSaysSo) {
  const Folder folder;
  const std::string text = many_lines();
  const std::string whole = packed(text);
  LineReader complete(folder.write("whole.zst", whole));
  EXPECT_TRUE(all_lines(complete) == text);
  EXPECT_FALSE(complete.cut());
  LineReader lines(folder.write("cut.zst", whole.substr(0, whole.size() / 2)));
  const std::string some = all_lines(lines);
  EXPECT_TRUE(lines.cut());
  EXPECT_GT(some.size(), 200000U);  // two blocks of zstd, of the five before the lines repeat
  EXPECT_TRUE(text.starts_with(some));
}

TEST(Zstd, ADamagedFileIsAnError) {
  const Folder folder;
  const std::string whole = packed(many_lines());
  try {
    all_lines(folder.write("bad.zst", whole.substr(0, 6) + "junk and more junk"));
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("expected a complete zstd file"), std::string::npos);
  }
}

TEST(LineReader, SkipsTheMarkOfTheByteOrder) {
  const Folder folder;
  EXPECT_EQ(all_lines(folder.write("marked",
                                   "\xef\xbb\xbf"
                                   "a\nb\n")),
            "a\nb\n");
}

}  // namespace
}  // namespace mikromakro
