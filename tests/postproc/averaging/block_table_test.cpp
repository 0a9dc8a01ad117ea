// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/block_table.h"

#include <gtest/gtest.h>

#include "model/error.h"
#include "text_file.h"

namespace mikromakro {
namespace {

const std::string table_text = "r_inner,r_outer,r,v_phi\n1,2,1.5,10\n2,3,2.5,nan\n";
const std::string names = "block,run,frames,r_inner,r_outer,r,v_phi\n";
const std::string all_frames = "0,0,7,1,2,1.5,10\n0,0,7,2,3,2.5,nan\n";
const std::string first = "1,1,3,1,2,1.5,11\n1,1,3,2,3,2.5,21\n";
const std::string second = "2,4,3,1,2,1.5,12\n2,4,3,2,3,2.5,22\n";

ColumnWithoutBlocks read(const std::string& blocks) {
  const Folder folder;
  const CsvTable table(folder.write("rings.csv", table_text));
  return column_without_blocks(CsvTable(folder.write("blocks.csv", blocks)), "v_phi", table);
}

TEST(BlockTable, GivesTheColumnWithoutEachBlock) {
  const ColumnWithoutBlocks column = read(names + all_frames + first + second);
  EXPECT_EQ(column.frames, 3);
  EXPECT_EQ(column.runs, (std::vector<std::int64_t>{1, 4}));
  EXPECT_TRUE((column.values == Eigen::ArrayXXd{{11, 12}, {21, 22}}).all());
}

std::string refusal(const std::string& blocks) {
  try {
    read(blocks);
  } catch (const Error& error) {
    const std::string message = error.what();
    return message.substr(message.find("blocks.csv"));
  }
  return "none";
}

TEST(BlockTable, OfOtherFramesOrRingsIsRefused) {
  EXPECT_EQ(refusal(table_text),
            "blocks.csv: the file has no blocks of frames; expected a file written by average --blocks, got "
            "no columns block, run, frames");
  EXPECT_NE(refusal(names + all_frames + first).find("three times 2 rows or more, got 4"), std::string::npos);
  EXPECT_NE(refusal(names + all_frames + first + "2,4,3,1,2,1.5,12\n").find("got 5"), std::string::npos);
  const auto with = [](const std::string& block0) { return names + block0 + first + second; };
  EXPECT_NE(refusal(with("0,0,7,1,2,1.5,10.5\n0,0,7,2,3,2.5,nan\n")).find("blocks.csv:2: the blocks are not"),
            std::string::npos);
  EXPECT_NE(
      refusal(with("0,0,7,1,2,1.5,10\n0,0,7,2,3,2.5,3\n")).find("v_phi = nan of all frames as in the table"),
      std::string::npos);
  EXPECT_NE(refusal(with("0,0,7,1,2,1.5,10\n0,0,7,2.2,3,2.5,nan\n")).find("r_inner = 2 as in the table"),
            std::string::npos);
}

// Volume 2, whose mean is not known, is not judged.
TEST(BlockTable, BlocksOfAnotherMeanOrOfMixedRunsAreRefused) {
  const std::string one = "1,1,3,1,2,1.5,", two = "2,4,3,1,2,1.5,", rest1 = "\n1,1,3,2,3,2.5,21\n",
                    rest2 = "\n2,4,3,2,3,2.5,22\n";
  EXPECT_EQ(refusal(names + all_frames + one + "9" + rest1 + two + "10.5" + rest2), "none");
  EXPECT_TRUE(refusal(names + all_frames + one + "-9" + rest1 + two + "-10.5" + rest2)
                  .starts_with("blocks.csv: v_phi without each block is not that of "));
  EXPECT_EQ(refusal(names + all_frames + "1,4,3,1,2,1.5,9\n1,4,3,2,3,2.5,9\n" +
                    "2,1,3,1,2,1.5,10\n2,1,3,2,3,2.5,9\n"),
            "blocks.csv:6: runs are not in order; expected run 4 or more, got 1");
}

TEST(BlockTable, OutOfOrderIsRefused) {
  EXPECT_EQ(refusal(names + all_frames + second + first),
            "blocks.csv:4: blocks are not in order; expected block 1, got 2");
  EXPECT_EQ(refusal(names + all_frames + first + "2,4,4,1,2,1.5,12\n2,4,4,2,3,2.5,22\n"),
            "blocks.csv:6: blocks differ in length; expected 3 frames, got 4");
  EXPECT_EQ(refusal(names + all_frames + first + "2,4,3,1,2,1.5,12\n2,5,3,2,3,2.5,22\n"),
            "blocks.csv:7: a block whose volumes differ from those of the table; expected 2 rows of the same "
            "block, run and frames, got 5 after 4");
}

}  // namespace
}  // namespace mikromakro
