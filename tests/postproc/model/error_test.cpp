// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/error.h"

#include <gtest/gtest.h>

namespace mikromakro {
namespace {

TEST(OneLine, ShowsControlCharactersByTheirNumbers) {
  EXPECT_EQ(one_line("a\x1b[31m\nb\x7f", 100), "a\\x1b[31m\\x0ab\\x7f");
  EXPECT_EQ(one_line("gr\xC3\xB6\xC3\x9F"
                     "er",
                     100),
            "gr\xC3\xB6\xC3\x9F"
            "er");
}

// 11 bytes of 20: four in front, four at the end, three dots; a letter of two bytes is not cut.
TEST(OneLine, CutsTheMiddle) {
  EXPECT_EQ(one_line("0123456789abcdefghij", 11), "01234...hij");
  const std::string cut = one_line("01234\xC3\xB6\xC3\xB6\xC3\xB6\xC3\xB6xyz", 12);
  EXPECT_EQ(cut, "01234...xyz");
}

TEST(Messages, AreBoundedWhateverTheyQuote) {
  const std::string endless(100000, 'x');
  EXPECT_LT(std::string(bad_input({endless, 7}, endless, endless, endless).what()).size(), 3000U);
  EXPECT_LT(std::string(run_failed(endless, endless, endless).what()).size(), 3000U);
  const std::string told = bad_input({"a\nb"}, "what", "this", "that\t").what();
  EXPECT_EQ(told, "a\\x0ab: what; expected this, got that\\x09");
}

}  // namespace
}  // namespace mikromakro
