// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/files/byte_source.h"

#include <gtest/gtest.h>
#include <zlib.h>
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

std::string gzipped(const std::string& text) {
  z_stream stream = {};
  deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, MAX_WBITS + 16, 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&stream, text.size()), '\0');
  std::string in = text;
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
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

std::string error_of(const std::string& file) {
  try {
    all_lines(file);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Gzip, SeveralMembersAreReadOnAndZerosAtTheEndAreNothing) {
  const Folder folder;
  const std::string text = many_lines(), two = gzipped("a\n") + gzipped("") + gzipped(text);
  EXPECT_TRUE(all_lines(folder.write("two.gz", two)) == "a\n" + text);
  EXPECT_TRUE(all_lines(folder.write("tape.gz", two + std::string(1000000, '\0'))) == "a\n" + text);
}

// zlib's gzread drops all of it in silence, with the frames that it may hold.
TEST(Gzip, WhatStandsBehindTheLastMemberIsAnError) {
  const Folder folder;
  const std::string zeros(512, '\0'), many_zeros(1000000, '\0');
  for (const std::string& rest : {std::string("b\n"),
                                  std::string("\x1f"
                                              "b\n"),
                                  zeros + gzipped("b\n"), many_zeros + "b\n", zeros + "\n"})
    EXPECT_NE(error_of(folder.write("mixed.gz", gzipped("a\n") + rest))
                  .find("mixed.gz: the file continues after its gzip data"),
              std::string::npos)
        << rest.size();
}

TEST(Gzip, ACutFileGivesItsWholeLinesAndSaysSo) {
  const Folder folder;
  const std::string text = many_lines(), whole = gzipped(text);
  LineReader complete(folder.write("whole.gz", whole));
  EXPECT_TRUE(all_lines(complete) == text);
  EXPECT_FALSE(complete.cut());
  LineReader lines(folder.write("cut.gz", whole.substr(0, whole.size() / 2)));
  const std::string some = all_lines(lines);
  EXPECT_TRUE(lines.cut());
  EXPECT_GT(some.size(), 200000U);
  EXPECT_TRUE(text.starts_with(some));
  for (const std::size_t length : {std::size_t{1}, std::size_t{5}, whole.size() - 1}) {
    LineReader second(folder.write("second.gz", gzipped("a\n") + whole.substr(0, length)));
    EXPECT_TRUE(all_lines(second).starts_with("a\n"));
    EXPECT_TRUE(second.cut()) << length;
  }
}

TEST(Gzip, ADamagedFileIsAnError) {
  const Folder folder;
  std::string sum = gzipped("a\n");
  sum[sum.size() - 8] ^= 1;
  EXPECT_NE(error_of(folder.write("sum.gz", sum)).find("got incorrect data check"), std::string::npos);
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
