// SPDX-License-Identifier: GPL-2.0-or-later
// mikromakro draw as a user runs it.
#include <gtest/gtest.h>

#include "run_program.h"

namespace mikromakro {
namespace {

const std::string good = "draw --particles good/particles.dump --contacts good/contacts.dump --bulk-types 1 ";

TEST(Draw, OneFrameHasTheGivenName) {
  const Folder folder;
  const Ran ran = run_program(good + "--chains --color pressure --out '" + folder.path("a.png") + "'");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.out + ran.err, "");
  EXPECT_TRUE(read_text(folder.path("a.png")).starts_with("\x89PNG"));
}

TEST(Draw, SeveralFramesAreNumbered) {
  const Folder folder;
  EXPECT_EQ(run_program(good + "--frames 0: --out '" + folder.path("a.svg") + "'").code, 0);
  EXPECT_NE(read_text(folder.path("a_0000.svg")), "");
  EXPECT_NE(read_text(folder.path("a_0001.svg")), read_text(folder.path("a_0000.svg")));
  EXPECT_EQ(run_program(good + "--frames 1: --out '" + folder.path("b%d.svg") + "'").code, 0);
  EXPECT_NE(read_text(folder.path("b0.svg")), "");
}

TEST(Draw, BadOptionsGiveOneLineAndNoPicture) {
  const auto fails = [](const std::string& arguments, const std::string& message) {
    const Folder folder;
    const Ran ran = run_program(arguments + " --out '" + folder.path("a.png") + "'");
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.err, "mikromakro: " + message + "\n");
    EXPECT_TRUE(folder.empty());
  };
  fails(good + "--box 1 1 0 1", "--box: not a box; expected XMIN < XMAX, YMIN < YMAX, got 1 1 0 1");
  fails(good + "--box 0 1e-9 0 1",
        "--box: the picture is too tall; expected at most 30000 pixels, got 1354838709781");
  fails(good + "--range 2 2", "--range: the range is empty; expected LOW < HIGH, got 2 2");
  fails(good + "--color mood",
        "--color: unknown quantity; expected one of radius velocity spin pressure contacts type, got 'mood'");
  fails(good + "--frames 5:",
        "good/particles.dump: no frame is selected; expected frames of 0 to 1, steps 100 to 200, that "
        "--frames and --steps select, got 0");
  fails("draw --particles good/particles.dump --chains",
        "--contacts: the picture needs contacts; expected files of contacts, got none");
  EXPECT_EQ(
      run_program(good + "--out a.gif").err,
      "mikromakro: --out: unknown kind of picture; expected a name ending in .png or .svg, got 'a.gif'\n");
}

}  // namespace
}  // namespace mikromakro
