// SPDX-License-Identifier: GPL-2.0-or-later
// mikromakro report as a user runs it; what a browser makes of it is tested by report/check_page.
#include <gtest/gtest.h>

#include "run_program.h"

namespace mikromakro {
namespace {

const std::string good =
    "report --particles good/particles.dump --contacts good/contacts.dump --rings 0 4 2 --bulk-types 1 ";

TEST(Report, IsOneFileAndSilent) {
  const Folder folder;
  const Ran ran = run_program(good + "--out '" + folder.path("a.html") + "'");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_TRUE(read_text(folder.path("a.html")).starts_with("<!DOCTYPE html>"));
}

TEST(Report, TheSameInputGivesTheSamePage) {
  const Folder folder;
  ASSERT_EQ(run_program(good + "--title t --out '" + folder.path("a.html") + "'").code, 0);
  const std::string first = read_text(folder.path("a.html"));
  ASSERT_EQ(run_program(good + "--title t --out '" + folder.path("a.html") + "'").code, 0);
  EXPECT_TRUE(read_text(folder.path("a.html")) == first);
}

TEST(Report, NamesAndTitlesAreNoMarkup) {
  const Folder folder;
  const Ran ran = run_program(good + "--title '</script><script>alert(1)</script>' --out '" +
                              folder.path("<script>.html") + "'");
  EXPECT_EQ(ran.code, 0) << ran.err;
  const std::string page = read_text(folder.path("<script>.html"));
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_EQ(page.find("/<script>.html"), std::string::npos);
  EXPECT_NE(page.find("\\u003c/script>\\u003cscript>alert(1)"), std::string::npos);
}

TEST(Report, WithoutContactsThereIsNoAudit) {
  const Folder folder;
  const Ran ran =
      run_program("report --particles good/particles.dump --rings 0 4 2 --fields velocity --out '" +
                  folder.path("a.html") + "'");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(read_text(folder.path("a.html")).find("there are no contacts in the input"), std::string::npos);
}

TEST(Report, CommandLinesAreQuotedForShells) {
  const Folder folder;
  const Ran ran = run_program(good + "--title \"it's 5 \\$\" --out '" + folder.path("a.html") + "'");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(read_text(folder.path("a.html")).find("--title 'it'\\\\''s 5 $'"), std::string::npos);
}

TEST(Report, BadOptionsGiveOneLineAndNoPage) {
  const auto fails = [](const std::string& arguments, const std::string& message) {
    const Folder folder;
    const Ran ran = run_program(arguments + " --out '" + folder.path("a.html") + "'");
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.err.find("mikromakro: " + message + "\n"), std::string::npos) << ran.err;
    EXPECT_TRUE(folder.empty());
  };
  fails(good + "--every 3",
        "--every: no window is full; expected as many frames as a run has, or fewer, got 3");
  fails(
      "report --particles good/particles.dump --contacts good/contacts.dump --rings 0 4 9000",
      "--rings: too many numbers for a page; expected at most 500000 values and errors in all windows (fewer "
      "volumes, --fields, or longer windows), got 1224000");
  EXPECT_EQ(run_program(good + "--out a.pdf").err,
            "mikromakro: --out: unknown kind of output file; expected a name ending in .html, got 'a.pdf'\n");
}

}  // namespace
}  // namespace mikromakro
