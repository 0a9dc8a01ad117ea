// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/files/output_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "model/error.h"
#include "text_file.h"

namespace mikromakro {
namespace {

namespace fs = std::filesystem;

TEST(OutputFile, AppearsCompleteOrNotAtAll) {
  const Folder folder;
  {
    const OutputFile file(folder.path("a.csv"));
    EXPECT_FALSE(fs::exists(folder.path("a.csv")));
  }
  EXPECT_TRUE(folder.empty());
  OutputFile(folder.path("a.csv")).commit("numbers");
  EXPECT_EQ(read_text(folder.path("a.csv")), "numbers");
}

TEST(OutputFile, KeepsLinksAndRights) {
  const Folder folder;
  fs::create_symlink("target.csv", folder.path("link.csv"));
  OutputFile(folder.path("link.csv")).commit("first");
  EXPECT_TRUE(fs::is_symlink(folder.path("link.csv")));
  EXPECT_EQ(read_text(folder.path("target.csv")), "first");
  fs::permissions(folder.path("target.csv"), fs::perms::owner_read | fs::perms::owner_write);
  OutputFile(folder.path("link.csv")).commit("second");
  EXPECT_EQ(read_text(folder.path("target.csv")), "second");
  EXPECT_EQ(fs::status(folder.path("target.csv")).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST(OutputFile, IsNoPipeWhereItIsNotWrittenFromFrontToBack) {
  const Folder folder;
  ASSERT_EQ(mkfifo(folder.path("pipe").c_str(), 0600), 0);
  EXPECT_THROW(OutputFile(folder.path("pipe")).require_regular(), Error);
  EXPECT_TRUE(fs::is_fifo(folder.path("pipe")));
  EXPECT_NO_THROW(OutputFile(folder.path("file")).require_regular());
}

TEST(OutputFile, LeavesNothingBehindWhenASignalEndsTheProcess) {
  const Folder folder;
  const OutputFile file(folder.path("a.csv"));
  EXPECT_FALSE(folder.empty());
  remove_unfinished_outputs();
  EXPECT_TRUE(folder.empty());
}

std::string complaint_about(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
  try {
    check_outputs(outputs, inputs);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Outputs, AreNoInputsByWhateverName) {
  const Folder folder;
  const std::string input = folder.write("in.dump", "discs");
  fs::create_symlink("in.dump", folder.path("soft"));
  fs::create_hard_link(input, folder.path("hard"));
  for (const std::string name : {"in.dump", "soft", "hard", "./in.dump"}) {
    const std::string told = complaint_about({folder.path(name)}, {input});
    EXPECT_NE(told.find("the output is an input"), std::string::npos) << name;
  }
  EXPECT_EQ(complaint_about({folder.path("other"), "-"}, {input}), "");
}

TEST(Outputs, AreDifferentFiles) {
  const Folder folder;
  fs::create_symlink("new", folder.path("soft"));
  const auto twice = [&](const std::string& first, const std::string& second) {
    return complaint_about({first, second}, {}).find("two outputs are one file") != std::string::npos;
  };
  EXPECT_TRUE(twice(folder.path("new"), folder.path("new")));
  EXPECT_TRUE(twice(folder.path("new"), folder.path("./new")));
  EXPECT_TRUE(twice(folder.path("new"), folder.path("soft")));
  EXPECT_TRUE(twice("-", "-"));
  EXPECT_FALSE(twice(folder.path("new"), folder.path("old")));
}

}  // namespace
}  // namespace mikromakro
