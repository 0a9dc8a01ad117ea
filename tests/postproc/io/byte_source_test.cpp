#include "io/byte_source.h"

#include <gtest/gtest.h>
#include <zstd.h>

#include <cstdint>

#include "io/line_reader.h"
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

std::string all_lines(const std::string& file) {
  LineReader lines(file);
  std::string text;
  for (std::string_view line; lines.next(line);) text.append(line) += '\n';
  return text;
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

TEST(Zstd, ACutFileIsAnError) {
  const Folder folder;
  const std::string whole = packed(many_lines());
  const auto message = [&](const std::string& content) -> std::string {
    try {
      all_lines(folder.write("cut.zst", content));
    } catch (const Error& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_NE(message(whole.substr(0, whole.size() - 5)).find("expected a complete zstd file"),
            std::string::npos);
  EXPECT_NE(message(whole.substr(0, 6) + "junk and more junk").find("expected a complete zstd file"),
            std::string::npos);
}

}  // namespace
}  // namespace mikromakro
